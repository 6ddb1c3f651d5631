#include "comparisons/measures/results/sentences.hpp"
#include "plots/drawing/rows.hpp"
#include "plots/figures/figure.hpp"

// The difference of angles in its two parts: how large the engine's motion is, and how late.

namespace rockstack::plots {
namespace {

/// One part, whose size the axis shows, and its words.
struct DifferencePart {
  const char *axis, *short_name;
  std::optional<double> Run::*value;

  double size(const Run& run) const { return std::abs(*(run.*value)); }
};

constexpr std::array difference_parts{
    DifferencePart{"amplitude, as a share", "amplitudes", &Run::magnitude_error},
    DifferencePart{"phase, as a share of half a turn", "phases", &Run::phase_error}};

/// Sizes that are not zero, of all steps or the finest of each row.
Extent extent_of(const DifferencePart& part, const std::vector<StepLine>& lines, bool finest) {
  Extent extent;
  for (const StepLine& line : lines)
    for (const Run& run : line)
      if (part.size(run) > 0 && (!finest || run.dt == line.front().dt)) extent.add(part.size(run));
  return extent;
}

std::string answer(const std::vector<StepLine>& lines) {
  const auto words = mapped(difference_parts, [&](const DifferencePart& part) {
    const Extent extent = extent_of(part, lines, true);
    return fmt::format("{} are off by {:.1g} to {:.1g}", part.short_name, extent.low, extent.high);
  });
  return fmt::format("At the finest steps {}", joined(words));
}

}  // namespace

Drawing amplitude_phase(const SceneSubject& subject) {
  std::vector<StepLine> lines = step_lines(subject.comparison, subject.scene.name);
  for (StepLine& line : lines)
    std::erase_if(
        line, [](const Run& run) { return run.is_variant() || !run.magnitude_error || !run.phase_error; });
  std::erase_if(lines, [](const StepLine& line) { return line.empty(); });
  const std::size_t all = lines.size();
  lines.resize(std::min(all, most_rows));
  Extent reach;
  for (const DifferencePart& part : difference_parts) {
    const Extent own = extent_of(part, lines, false);
    reach = {std::min(reach.low, own.low), std::max(reach.high, own.high)};
  }
  if (reach.low > reach.high) return subject.nothing("No angle differs from the exact one.");
  Sheet sheet = subject.sheet({}, answer(lines));
  constexpr double room = 1.5;
  std::vector<RowColumn> columns;
  for (const DifferencePart& part : difference_parts) {
    Plots plots(sheet, fmt::format("part_{}", columns.size()));
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const Run& run : lines[i])
        plots.add({{std::max(part.size(run), reach.low / room), static_cast<double>(i)}},
                  {"using 1:2 " + mark_style(run, run.dt == lines[i].front().dt ? 1.6 : 0.9)});
    columns.push_back({part.axis, plots.list()});
  }
  add_rows(sheet,
           {mapped(lines, [](const StepLine& line) { return line_label(line); }), reach.low / room,
            reach.high * room},
           columns);
  sheet.note("small marks: longer steps; on the left edge: none");
  if (all > lines.size()) sheet.note(fmt::format("the first {} of {} rows", lines.size(), all));
  return sheet.finish();
}

}  // namespace rockstack::plots
