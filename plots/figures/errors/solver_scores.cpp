#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "plots/data/scores.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/rows.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// What the axis shows. Answers below it, and those that are none at all, stand on its left edge.
struct Extent {
  double low = 0, high = 0;
};

Extent extent_of(const std::vector<Score>& list) {
  constexpr double decades = 1e8;
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const Score& score : list)
    for (const double value : score.values) {
      high = std::max(high, value);
      if (value > 0) low = std::min(low, value);
    }
  if (high == 0) return {least_error, 1};
  low = std::max(low, high / decades);
  const double room = std::max(1.5, std::pow(high / low, 0.04));
  return {low / room, high * room};
}

std::string marks(const std::vector<double>& values, std::size_t row, double low) {
  std::string lines;
  for (const double value : values) lines += fmt::format("{} {}\n", plain(std::max(value, low)), row);
  return lines;
}

std::string words_of(const Score& score, std::size_t scenes) {
  const std::size_t answered = score.runs.size();
  return line_label(score.runs.front()) +
         (answered < scenes ? fmt::format(" ({} of {})", answered, scenes) : "");
}

/// All solvers by their answers to one question: a row a solver and set, a small mark a scene, a large one
/// their median. Precondition: there is a score.
Drawing drawing(const ComparisonSubject& subject, const SolverQuestion& question, std::vector<Score> list) {
  const std::size_t all = list.size();
  list.resize(std::min(list.size(), most_rows));
  const std::size_t scenes = list.front().runs.size();
  Sheet sheet =
      subject.sheet({}, question.name == "accuracy" ? first_of_all(subject.comparison)
                                                    : fmt::format("{}: {:.2g} in the median of {} scenes",
                                                                  line_label(list.front().runs.front()),
                                                                  list.front().median, scenes));
  const Extent extent = extent_of(list);
  RowPanel panel{{}, extent.low, extent.high};
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Run& run = list[i].runs.front();
    panel.words.push_back(words_of(list[i], scenes));
    const std::string name = fmt::format("row_{}", i);
    sheet.data(fmt::format("${} << END\n{}END\n", name, marks(list[i].values, i, extent.low)));
    sheet.data(fmt::format("${}_median << END\n{}END\n", name, marks({list[i].median}, i, extent.low)));
    plots.push_back(
        fmt::format("${} using 1:2 with points pt 2 ps 0.7 lc rgb '{}' notitle", name, style_of(run).colour));
    plots.push_back(fmt::format("${}_median using 1:2 {} notitle", name, mark_style(run, 1.6)));
  }
  add_rows(sheet, panel, {{question.axis, plots}});
  if (all > list.size()) sheet.note(fmt::format("the first {} of {}", list.size(), all), "#000000");
  sheet.note(fmt::format("{}; crosses: scenes; large marks: their median; on the left edge: nothing, or too "
                         "little to show",
                         question.steps.empty()
                             ? "at a step of " + duration_text(value_of(list.front().runs.front().dt))
                             : question.steps),
             "#000000");
  return sheet.finish();
}

}  // namespace

Drawings solver_scores(const ComparisonSubject& subject) {
  if (!has_scores(subject.comparison)) return {};
  const auto question =
      std::find_if(solver_questions().begin(), solver_questions().end(),
                   [&](const SolverQuestion& one) { return "solvers." + one.name == subject.figure.name; });
  std::vector<Score> list = scores(subject.comparison, *question);
  if (list.empty()) return {};
  return {{"", drawing(subject, *question, std::move(list))}};
}

}  // namespace rockstack::plots
