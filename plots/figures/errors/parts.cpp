#include "plots/drawing/rows.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

struct Term {
  const char* name;
  const char* colour;
  std::optional<double> RunMetrics::*size;
};

constexpr std::array terms_of_difference{
    Term{"contact model", "#4477AA", &RunMetrics::model_difference},
    Term{"contact softness", "#997700", &RunMetrics::softness_difference},
    Term{"time step", "#AA3377", &RunMetrics::step_difference}};

/// What a logarithmic axis does not reach stands on its left edge.
constexpr double least_term = 1e-9;  // rad

/// The bars of one step: left end, row, left and right end, lower and upper edge of each.
std::vector<std::string> bars(Sheet& sheet, const std::vector<StepLine>& lines, double dt, std::size_t at) {
  Plots plots(sheet, fmt::format("term_{}", at));
  double below = -0.36;
  for (const Term& term : terms_of_difference) {
    Numbers numbers;
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const Run& run : lines[i]) {
        if (run.dt != dt) continue;
        const double low = static_cast<double>(i) + below;
        const double size = std::max((run.*term.size).value_or(0), least_term);
        numbers.push_back({least_term, low + 0.12, least_term, size, low, low + 0.24});
      }
    plots.add(numbers, {fmt::format("with boxxyerror fs solid noborder lc rgb '{}'", term.colour)});
    below += 0.24;
  }
  return plots.list();
}

}  // namespace

Drawing split_parts(const SceneSubject& subject) {
  std::vector<StepLine> lines = step_lines(subject.comparison, subject.scene.name);
  for (StepLine& line : lines) std::erase_if(line, [](const Run& run) { return !run.step_difference; });
  std::erase_if(lines, [](const StepLine& line) { return line.empty(); });
  if (lines.empty()) return subject.nothing("No engine run of this scene that is split.");
  std::vector<Run> runs;
  for (const StepLine& line : lines) runs.insert(runs.end(), line.begin(), line.end());
  Legend legend;
  std::string answer;
  double largest = 10 * least_term;
  for (const Term& term : terms_of_difference) {
    std::size_t led = 0;  // runs whose largest term it is
    for (const Run& run : runs) {
      largest = std::max(largest, (run.*term.size).value_or(0));
      led += std::ranges::all_of(terms_of_difference, [&](const Term& other) {
        return other.size == term.size || run.*other.size < run.*term.size;
      });
    }
    legend.emplace_back(fmt::format("with lines lw 8 lc rgb '{}'", term.colour), term.name);
    answer += fmt::format("{}{} in {}", answer.empty() ? "" : ", ", term.name, led);
  }
  Sheet sheet = subject.sheet(legend, "The largest part, runs: " + answer);
  std::vector<RowColumn> columns;
  for (const double dt : chosen_steps(runs))
    columns.push_back({"step " + duration_text(dt), bars(sheet, lines, dt, columns.size())});
  add_rows(sheet,
           {mapped(lines, [](const StepLine& line) { return line_label(line); }), least_term, 1.5 * largest,
            "x", 34},
           columns);
  sheet.note("RMS of each part over all samples and blocks (rad); as histories the three add up");
  if (!draws_note(subject.comparison, subject.scene.name).empty()) sheet.note("medians over replicates");
  return sheet.finish();
}

}  // namespace rockstack::plots
