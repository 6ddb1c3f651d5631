#include "plots/pages/show.hpp"

#include "plots/figures/figure.hpp"

namespace rockstack::plots {

using WritePage = void(const fs::path& results, const Json& json);
WritePage write_course, write_canon_report;
/// Writes the page of a study: title, headline, figures and the tables that its JSON file names.
WritePage write_study;
/// Writes the report of one motion: its verdict, its player, its figures and everything that its summary
/// says.
void write_report(const fs::path& results, const Motion& motion);

namespace {

/// Results that are known by a JSON file, and how their page is written of what it says.
struct Kind {
  const char *file, *before_title = "";
  WritePage* write_page = write_study;
};

/// The first that is there holds: a study of stability has runs too.
constexpr std::array kinds{Kind{"course.json", "", write_course},
                           Kind{"canon.json", "", write_canon_report},
                           Kind{"record.json", "Record "},
                           Kind{"advice.json", "Advice: "},
                           Kind{"fit.json", "Fit: "},
                           Kind{"threshold.json", "Threshold: "},
                           Kind{"stability.json", "Stability: "},
                           Kind{"sweep.json"},
                           Kind{"impact-laws.json"},
                           Kind{"checks.json"},
                           Kind{"diff.json"}};

const Kind* kind_of(const fs::path& results) {
  const auto* const kind =
      std::ranges::find_if(kinds, [&](const Kind& one) { return fs::exists(results / one.file); });
  return kind == kinds.end() ? nullptr : kind;
}

}  // namespace

bool write_study_page(const fs::path& results) {
  const Kind* kind = kind_of(results);
  if (kind == nullptr) return false;
  read_json(results / kind->file, [&](Json json) {
    // Results of before had no title where they had no scene.
    json["title"] = kind->before_title + json.value("title", results.filename().string());
    kind->write_page(results, json);
  });
  return true;
}

void show(const fs::path& results) {
  if (kind_of(results) != nullptr) {
    draw_figures(results);
    write_study_page(results);
  } else if (fs::exists(results / "summary.json") && fs::exists(results / "history.csv")) {
    const Motion motion = read_motion(results);
    draw_figures(results, motion.comparison);
    draw_figures(results);
    write_report(results, motion);
  } else if (has_runs(results)) {
    const Comparison comparison = read_comparison(results);  // whose files are read once for all
    draw_figures(results, comparison);
    print_figures(results, comparison);
    write_report(results, comparison);
    if (fs::exists(results / "lesson.json")) write_lesson(results, comparison);
  } else {
    throw InputError(
        fmt::format("{}: cannot be read: must be a folder with results that have figures", results.string()));
  }
}

}  // namespace rockstack::plots
