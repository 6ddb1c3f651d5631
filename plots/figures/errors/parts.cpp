#include "plots/drawing/rows.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// One of the terms of a difference.
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

double largest_term(const std::vector<Run>& runs) {
  double largest = 10 * least_term;
  for (const Run& run : runs)
    for (const Term& term : terms_of_difference) largest = std::max(largest, (run.*term.size).value_or(0));
  return largest;
}

/// How many of the runs have that term as their largest.
auto led_by(const std::vector<Run>& runs, const Term& led) {
  return std::ranges::count_if(runs, [&](const Run& run) {
    return std::ranges::all_of(terms_of_difference, [&](const Term& term) {
      return term.size == led.size || run.*term.size < run.*led.size;
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
  for (const Term& term : terms_of_difference) {
    legend.emplace_back(fmt::format("with lines lw 8 lc rgb '{}'", term.colour), term.name);
    answer += fmt::format("{}{} in {}", answer.empty() ? "" : ", ", term.name, led_by(runs, term));
  }
  Sheet sheet = subject.sheet(legend, "The largest part, runs: " + answer);
  std::vector<RowColumn> columns;
  for (const double dt : chosen_steps(runs))
    columns.push_back({"step " + duration_text(dt), bars(sheet, lines, dt, columns.size())});
  add_rows(sheet, {words, least_term, 1.5 * largest_term(runs), "x", 34}, columns);
  sheet.note("RMS of each part over all samples and blocks (rad); as histories the three add up");
  if (!draws_note(subject.comparison, subject.scene.name).empty()) sheet.note("medians over replicates");
  return sheet.finish();
}

}  // namespace rockstack::plots
