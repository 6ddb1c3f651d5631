#include <array>

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

/// The bars of one step: left end, row, left and right end, lower and upper edge of each.
std::vector<std::string> bars(Sheet& sheet, const std::vector<StepLine>& lines, double dt, std::size_t at) {
  Plots plots(sheet, fmt::format("part_{}", at));
  double below = -0.36;
  for (const Part& part : parts_of_difference) {
    Numbers numbers;
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const Run& run : lines[i]) {
        if (run.dt != dt) continue;
        const double low = static_cast<double>(i) + below;
        const double size = std::max((run.*part.size).value_or(0), least_part);
        numbers.push_back({least_part, low + 0.12, least_part, size, low, low + 0.24});
      }
    plots.add(numbers, {fmt::format("with boxxyerror fs solid noborder lc rgb '{}'", part.colour)});
    below += 0.24;
  }
  return plots.list();
}

double largest_part(const std::vector<Run>& runs) {
  double largest = 10 * least_part;
  for (const Run& run : runs)
    for (const Part& part : parts_of_difference) largest = std::max(largest, (run.*part.size).value_or(0));
  return largest;
}

/// How many of the runs have that part as their largest.
auto led_by(const std::vector<Run>& runs, const Part& led) {
  return std::count_if(runs.begin(), runs.end(), [&](const Run& run) {
    return std::all_of(parts_of_difference.begin(), parts_of_difference.end(), [&](const Part& part) {
      return part.size == led.size || run.*part.size < run.*led.size;
    });
  });
}

}  // namespace

Drawing split_parts(const SceneSubject& subject) {
  const std::vector<StepLine> lines = split_lines(subject.comparison, subject.scene.name);
  if (lines.empty()) return subject.nothing("No engine run of this scene that is split.");
  std::vector<std::string> words;
  std::vector<Run> runs;
  for (const StepLine& line : lines) {
    words.push_back(line_label(line));
    runs.insert(runs.end(), line.begin(), line.end());
  }
  Legend legend;
  std::string answer;
  for (const Part& part : parts_of_difference) {
    legend.emplace_back(fmt::format("with lines lw 8 lc rgb '{}'", part.colour), part.name);
    answer += fmt::format("{}{} in {}", answer.empty() ? "" : ", ", part.name, led_by(runs, part));
  }
  Sheet sheet = subject.sheet(legend, "The largest part, runs: " + answer);
  std::vector<RowColumn> columns;
  for (const double dt : chosen_steps(runs))
    columns.push_back({"step " + duration_text(dt), bars(sheet, lines, dt, columns.size())});
  add_rows(sheet, {words, least_part, 1.5 * largest_part(runs), "x", 34}, columns);
  sheet.note("RMS of each part over all samples and blocks (rad); as histories the three add up");
  if (!draws_note(subject.comparison, subject.scene.name).empty()) sheet.note("medians over replicates");
  return sheet.finish();
}

}  // namespace rockstack::plots
