#include "plots/pages/show.hpp"

#include "plots/figures/figure.hpp"

namespace rockstack::plots {

using WritePage = void(const fs::path& results, const Json& json);
WritePage write_course, write_record_report, write_canon_report, write_advice_report, write_fit_report,
    write_stability_report, write_sweep_report, write_impact_law_report;
/// Writes the report of one motion: its verdict, its player, its figures and everything that its summary
/// says.
void write_report(const fs::path& results, const Motion& motion);

namespace {

/// Results that are known by a file, and how their page is written of what the JSON file of that name says.
struct Kind {
  const char* file;
  WritePage* write_page;
};

/// The first that is there holds: a study of stability has runs too.
constexpr std::array kinds{
    Kind{"course.json", write_course},      Kind{"record.json", write_record_report},
    Kind{"canon.json", write_canon_report}, Kind{"advice.json", write_advice_report},
    Kind{"fit.json", write_fit_report},     Kind{"stability.json", write_stability_report},
    Kind{"sweep.json", write_sweep_report}, Kind{"impact-laws.csv", write_impact_law_report}};

const Kind* kind_of(const fs::path& results) {
  const auto* const kind =
      std::ranges::find_if(kinds, [&](const Kind& one) { return fs::exists(results / one.file); });
  return kind == kinds.end() ? nullptr : kind;
}

}  // namespace

bool write_study_page(const fs::path& results) {
  const Kind* kind = kind_of(results);
  if (kind == nullptr) return false;
  read_json((results / kind->file).replace_extension(".json"),
            [&](const Json& json) { kind->write_page(results, json); });
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
    write_report(results, comparison);
    if (fs::exists(results / "lesson.json")) write_lesson(results, comparison);
  } else {
    throw InputError(
        fmt::format("{}: cannot be read: must be a folder with results that have figures", results.string()));
  }
}

}  // namespace rockstack::plots
