#include "analytic/scene/messages/number_text.hpp"
#include "plots/drawing/rows.hpp"
#include "plots/figures/figure.hpp"

// How near to toppling blocks come, beside the exact motion.

namespace rockstack::plots {
namespace {

/// Nothing rocks below this normalized rotation. What lies beyond the axis' end has toppled or nearly so.
constexpr double least_shown = 1e-3, furthest = 1.5;

/// A run's median with its quartiles over replicates.
void add_run(Plots& plots, const Run& run, double row, double end) {
  const double peak = *run.peak_over_slenderness;
  const auto shown = [&](double value) { return std::min(value, end); };
  plots.add({{shown(peak), row, shown(run.peak_over_slenderness_lower.value_or(peak)),
              shown(run.peak_over_slenderness_upper.value_or(peak))}},
            {fmt::format("using 1:2:3:4 with xerrorbars lw 4 lc rgb '{}' pt 0", style_of(run).colour),
             "using 1:2 " + mark_style(run, 1.4)});
}

std::string answer(double exact, const std::vector<Run>& runs) {
  const auto [least, most] =
      std::ranges::minmax(mapped(runs, [](const Run& run) { return *run.peak_over_slenderness; }));
  return fmt::format("Exact {}, engines {} to {} of the slenderness angle, in the median of replicates",
                     number_text(exact, 2), number_text(least, 2), number_text(most, 2));
}

}  // namespace

Drawing peaks(const SceneSubject& subject) {
  std::vector<StepLine> lines = step_lines(subject.comparison, subject.scene.name);
  std::vector<Run> runs;
  double exact = 0;
  for (StepLine& line : lines) {
    std::erase_if(line, [](const Run& run) { return run.is_variant() || !run.peak_over_slenderness; });
    for (const Run& run : line) exact = std::max(exact, run.exact_peak_over_slenderness.value_or(0));
    runs.insert(runs.end(), line.begin(), line.end());
  }
  std::erase_if(lines, [](const StepLine& line) { return line.empty(); });
  const std::size_t all = lines.size();
  lines.resize(std::min(all, most_rows));
  if (runs.empty() || exact < least_shown)
    return subject.nothing("Nothing rocks in the exact motion, so there are no peaks to compare.");
  double end = std::max(1.0, exact);
  for (const Run& run : runs) end = std::max(end, *run.peak_over_slenderness);
  end = std::min(1.05 * end, std::max(furthest, 1.05 * exact));
  const std::string brink = fmt::format("with lines {}", tolerance_style);
  Sheet sheet = subject.sheet({{exact_style, "exact"}, {brink, "slenderness angle"}}, answer(exact, runs));
  std::vector<RowColumn> columns;
  const auto rows = static_cast<double>(lines.size());
  for (const double dt : chosen_steps(runs)) {
    Plots plots(sheet, fmt::format("peak_{}", columns.size()));
    plots.add({{exact, -0.7}, {exact, rows}}, {fmt::format("using 1:2 {}", exact_style)});
    plots.add({{1, -0.7}, {1, rows}}, {"using 1:2 " + brink});
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const Run& run : lines[i])
        if (run.dt == dt) add_run(plots, run, static_cast<double>(i), end);
    columns.push_back({"step " + duration_text(dt), plots.list(), "", "", end});
  }
  add_rows(sheet, {mapped(lines, [](const StepLine& line) { return line_label(line); })}, columns);
  sheet.note("largest angle of a block over its slenderness angle, in the whole scene");
  if (subject.scene.horizon() < subject.scene.duration)
    sheet.note("beyond the horizon the exact ones, too, are of scenes that differ in the sixth digit");
  if (all > lines.size()) sheet.note(fmt::format("the first {} of {} rows", lines.size(), all));
  return sheet.finish();
}

}  // namespace rockstack::plots
