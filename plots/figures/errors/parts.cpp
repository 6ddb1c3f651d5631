#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "plots/data/selection.hpp"
#include "plots/drawing/rows.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// One of the parts of a difference.
struct Part {
  const char* name;
  const char* colour;
  std::optional<double> RunMetrics::*size;
};

constexpr std::array parts_of_difference{
    Part{"contact model", "#4477AA", &RunMetrics::model_difference},
    Part{"contact softness", "#CCBB44", &RunMetrics::softness_difference},
    Part{"time step", "#AA3377", &RunMetrics::step_difference}};

/// What a logarithmic axis does not reach stands on its left edge.
constexpr double least_part = 1e-9;  // rad

std::vector<StepLine> split_lines(const Comparison& comparison, const std::string& scene) {
  std::vector<StepLine> lines;
  for (StepLine line : step_lines(comparison, scene)) {
    std::erase_if(line, [](const Run& run) { return !run.step_difference; });
    if (!line.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

/// The bars of one step: left end, row, right end, lower and upper edge of each.
std::vector<std::string> bars(Sheet& sheet, const std::vector<StepLine>& lines, double dt, std::size_t at) {
  std::vector<std::string> plots;
  for (std::size_t p = 0; p < parts_of_difference.size(); ++p) {
    const Part& part = parts_of_difference[p];
    const std::string name = fmt::format("part_{}_{}", at, p);
    std::string block = "$" + name + " << END\n";
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const Run& run : lines[i]) {
        if (run.dt != dt) continue;
        const double top = static_cast<double>(i) - 0.36 + 0.24 * static_cast<double>(p);
        block += fmt::format("{} {} {} {} {} {}\n", plain(least_part), plain(top + 0.12), plain(least_part),
                             plain(std::max((run.*part.size).value_or(0), least_part)), plain(top),
                             plain(top + 0.24));
      }
    sheet.data(block + "END\n");
    plots.push_back(
        fmt::format("${} with boxxyerror fs solid noborder lc rgb '{}' notitle", name, part.colour));
  }
  return plots;
}

double largest_part(const std::vector<StepLine>& lines) {
  double largest = 10 * least_part;
  for (const StepLine& line : lines)
    for (const Run& run : line)
      for (const Part& part : parts_of_difference) largest = std::max(largest, (run.*part.size).value_or(0));
  return largest;
}

/// How many of the runs have that part as their largest.
std::size_t led_by(const std::vector<StepLine>& lines, const Part& led) {
  std::size_t count = 0;
  for (const StepLine& line : lines)
    count += static_cast<std::size_t>(std::count_if(line.begin(), line.end(), [&](const Run& run) {
      return std::all_of(parts_of_difference.begin(), parts_of_difference.end(), [&](const Part& part) {
        return part.size == led.size || run.*part.size < run.*led.size;
      });
    }));
  return count;
}

}  // namespace

Drawing split_parts(const SceneSubject& subject) {
  const Comparison& comparison = subject.comparison;
  const ComparedScene& scene = subject.scene;
  const std::vector<StepLine> lines = split_lines(comparison, scene.name);
  if (lines.empty()) return subject.nothing("No engine run of this scene that is split.");
  Legend legend;
  for (const Part& part : parts_of_difference)
    legend.emplace_back(fmt::format("with lines lw 8 lc rgb '{}'", part.colour), part.name);
  std::string answer;
  for (const Part& part : parts_of_difference)
    answer += fmt::format("{}{} in {}", answer.empty() ? "" : ", ", part.name, led_by(lines, part));
  Sheet sheet = subject.sheet(legend, "The largest part, runs: " + answer);
  RowPanel panel{{}, least_part, 1.5 * largest_part(lines), "x", 34};
  std::vector<Run> runs;
  for (const StepLine& line : lines) {
    panel.words.push_back(line_label(line));
    runs.insert(runs.end(), line.begin(), line.end());
  }
  std::vector<RowColumn> columns;
  for (const double dt : chosen_steps(runs))
    columns.push_back({"step " + duration_text(dt), bars(sheet, lines, dt, columns.size())});
  add_rows(sheet, panel, columns);
  sheet.note("RMS of each part over all samples and blocks (rad); as histories the three add up", "#000000");
  if (const std::string note = draws_note(comparison, scene.name); !note.empty())
    sheet.note("medians over replicates", "#000000");
  return sheet.finish();
}

}  // namespace rockstack::plots
