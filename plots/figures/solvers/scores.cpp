#include "plots/figures/solvers/scores.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/row_words.hpp"
#include "plots/drawing/style.hpp"

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

RowWords words_of(const std::vector<Score>& list, std::size_t scenes) {
  std::vector<std::string> labels;
  labels.reserve(list.size());
  for (const Score& score : list) {
    const std::size_t answered = score.runs.size();
    labels.push_back(line_label(score.runs.front()) +
                     (answered < scenes ? fmt::format(" ({} of {})", answered, scenes) : ""));
  }
  return row_words(labels);
}

}  // namespace

Drawing solver_scores(const Comparison& comparison, const SolverQuestion& question) {
  constexpr double pixels = 1200;
  std::vector<Score> list = scores(comparison, question);
  const std::size_t all = list.size();
  list.resize(std::min(list.size(), most_rows));
  const std::size_t scenes = list.front().runs.size();
  Sheet sheet(comparison.title, {},
              fmt::format("{} {}: {:.2g} in the median of {} scenes", question.question,
                          line_label(list.front().runs.front()), list.front().median, scenes));
  const Extent extent = extent_of(list);
  const RowWords words = words_of(list, scenes);
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Run& run = list[i].runs.front();
    const std::string name = fmt::format("row_{}", i);
    sheet.data(fmt::format("${} << END\n{}END\n", name, marks(list[i].values, i, extent.low)));
    sheet.data(fmt::format("${}_median << END\n{}END\n", name, marks({list[i].median}, i, extent.low)));
    plots.push_back(
        fmt::format("${} using 1:2 with points pt 2 ps 0.7 lc rgb '{}' notitle", name, style_of(run).colour));
    plots.push_back(fmt::format("${}_median using 1:2 {} notitle", name, mark_style(run, 1.6)));
  }
  const double width = (right_edge - words.left) * pixels;
  sheet.row(row_height(words) * static_cast<double>(list.size()) + 30, 0,
            {{fmt::format("set logscale x\nset xrange [{}:{}]\nset yrange [{}:-0.7]\n"
                          "set grid x y lt 1 dt solid lw 1 lc rgb '#E4E4E4'\nset xlabel '{}'\n",
                          plain(extent.low), plain(extent.high), static_cast<double>(list.size()) - 0.3,
                          question.axis) +
                  words.tics + logarithmic_tics("x", extent.low, extent.high, width),
              plots}},
            1, words.left);
  if (all > list.size()) sheet.note(fmt::format("the first {} of {}", list.size(), all), "#000000");
  sheet.note(
      fmt::format("{}; crosses: scenes; large marks: their median; on the left edge: nothing, or too "
                  "little to show",
                  question.steps.empty() ? "at a step of " + duration_text(list.front().runs.front().dt)
                                         : question.steps),
      "#000000");
  return sheet.finish();
}

void draw_solver_scores(const Comparison& comparison, const std::filesystem::path& results) {
  if (!has_scores(comparison)) return;
  for (const SolverQuestion& question : solver_questions()) {
    std::filesystem::path stem = results / "figures" / "solvers.";
    stem += question.name;
    if (!scores(comparison, question).empty()) draw(solver_scores(comparison, question), stem);
  }
}

}  // namespace rockstack::plots
