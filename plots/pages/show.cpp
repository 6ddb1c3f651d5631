#include "plots/pages/show.hpp"

#include <fmt/core.h>

#include "analytic/scene/messages/input_error.hpp"
#include "plots/figures/table.hpp"
#include "plots/pages/pages.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

/// Results that are known by a file, and how their page is written.
struct Kind {
  const char* file;
  void (*write_page)(const fs::path&);
};

/// The first that is there holds: a study of stability has runs too.
constexpr Kind kinds[]{{"course.json", write_course},
                       {"record.json", write_record_report},
                       {"canon.json", write_canon_report},
                       {"advice.json", write_advice_report},
                       {"stability.json", write_stability_report},
                       {"sweep.json", write_sweep_report},
                       {"impact-laws.csv", write_impact_law_report}};

/// Files of runs are read once for figures and pages together.
void show_runs(const fs::path& results) {
  const Comparison comparison = read_comparison(results);
  draw_figures(results, comparison);
  write_report(results, comparison);
  if (fs::exists(results / "lesson.json")) write_lesson(results, comparison);
}

void show_motion(const fs::path& results) {
  const Motion motion = read_motion(results);
  draw_figures(results, motion.comparison);
  write_report(results, motion);
}

}  // namespace

bool has_runs(const fs::path& results) {
  return fs::exists(results / "comparison.json") && !fs::exists(results / "stability.json");
}

void show(const fs::path& results) {
  for (const Kind& kind : kinds)
    if (fs::exists(results / kind.file)) {
      draw_figures(results);
      return kind.write_page(results);
    }
  if (has_one_motion(results)) return show_motion(results);
  if (has_runs(results)) return show_runs(results);
  throw InputError(
      fmt::format("{}: cannot be read: must be a folder with results that have figures", results.string()));
}

}  // namespace rockstack::plots
