#include <fmt/format.h>

#include "comparisons/measures/results/csv.hpp"
#include "plots/data/scores.hpp"
#include "plots/drawing/rows.hpp"
#include "plots/figures/figure.hpp"

// Who is first: of the runs of one scene, and of solvers over all scenes.

namespace rockstack::plots {
namespace {

/// The whole range of the errors of a run's replicates, by the names of the runs that have some.
using Ranges = std::map<std::string, Extent>;

Ranges read_ranges(const fs::path& file) {
  Ranges ranges;
  if (!fs::exists(file)) return ranges;
  for (CsvLine row(file); row.next();)
    if (row.text("quantity") == "error")
      ranges[row.text("run")] = {row.value("least"), row.value("greatest")};
  return ranges;
}

/// One row: the runs of a series that have errors, and what the rows are ordered by.
struct RankedSeries {
  std::string label;
  std::vector<Run> runs;
  double largest = 0;  ///< error of the whole line
};

/// A row for the whole line, or one for each number of iterations, rising, where these vary.
std::vector<RankedSeries> rows_of(const StepLine& line) {
  RankedSeries whole{line_label(line), {}};
  for (const Run& run : line)
    if (!run.is_variant() && run.error > 0) {
      whole.runs.push_back(run);
      whole.largest = std::max(whole.largest, *run.error);
    }
  if (whole.runs.empty()) return {};
  if (!varies_iterations(line)) return {whole};
  std::vector<RankedSeries> rows;
  for (auto run = whole.runs.rbegin(); run != whole.runs.rend(); ++run)
    rows.push_back({line_label(*run), {*run}, whole.largest});
  return rows;
}

/// Rows by rising error, those with more steps first; at most so many that a page shows.
std::vector<RankedSeries> ranked(const Comparison& comparison, const std::string& scene) {
  std::vector<RankedSeries> rows;
  for (const StepLine& line : step_lines(comparison, scene))
    for (const RankedSeries& row : rows_of(line)) rows.push_back(row);
  std::ranges::stable_sort(rows, [](const RankedSeries& a, const RankedSeries& b) {
    return a.runs.size() != b.runs.size() ? a.runs.size() > b.runs.size() : a.largest < b.largest;
  });
  rows.resize(std::min(rows.size(), most_rows));
  return rows;
}

Extent range_of(const Run& run, const Ranges& ranges) {
  const auto found = ranges.find(run.run);
  return found == ranges.end() ? Extent{*run.error, *run.error} : found->second;
}

/// With room about it on a logarithmic axis, a twenty-fifth of its decades or more.
Extent with_log_room(const Extent& reach) {
  return reach.wider_times(std::max(1.5, std::pow(reach.high / reach.low, 0.04)));
}

Extent reach_of(const std::vector<Run>& runs, const Ranges& ranges) {
  Extent reach;
  for (const Run& run : runs) {
    const auto [least, greatest] = range_of(run, ranges);
    reach.low = std::min(reach.low, std::max(least, *run.error / 100));
    reach.high = std::max(reach.high, greatest);
  }
  return with_log_room({std::max(reach.low, least_error), std::max(reach.high, least_error)});
}

void add_run(Plots& plots, const Run& run, std::size_t row, const Ranges& ranges) {
  const double error = *run.error;
  const auto [least, greatest] = range_of(run, ranges);
  const auto shown = [](double value) { return std::max(value, least_error); };
  const std::string bars = fmt::format("lc rgb '{}' pt 0", style_of(run).colour);
  plots.add({{shown(error), static_cast<double>(row), shown(run.error_lower.value_or(error)),
              shown(run.error_upper.value_or(error)), shown(least), shown(greatest)}},
            {"using 1:2:5:6 with xerrorbars lw 1 " + bars, "using 1:2:3:4 with xerrorbars lw 4 " + bars,
             "using 1:2 " + mark_style(run, 1.4)});
}

std::string answer(const std::vector<Run>& runs, const std::vector<double>& steps) {
  std::vector<std::string> parts;
  for (const double dt : steps) {
    std::vector<std::string> first;
    std::size_t all = 0;
    for (const Run& run : runs) {
      if (run.dt != dt || !run.rank) continue;
      ++all;
      if (run.rank == 1) first.push_back(line_label(run));
    }
    if (all > 0) parts.push_back(fmt::format("at {}: {}", duration_text(dt), nearest_phrase(first, all)));
  }
  return parts.empty() ? "Nothing moves, and none is ranked" : fmt::format("{}", fmt::join(parts, "; "));
}

/// What the axis shows. Answers below it, and those that are none at all, stand on its left edge.
Extent reach_of(const std::vector<Score>& list) {
  constexpr double decades = 1e8;
  Extent reach{std::numeric_limits<double>::infinity(), 0};
  for (const Score& score : list)
    for (const double value : score.values) {
      reach.high = std::max(reach.high, value);
      if (value > 0) reach.low = std::min(reach.low, value);
    }
  if (reach.high == 0) return {least_error, 1};
  return with_log_room({std::max(reach.low, reach.high / decades), reach.high});
}

/// All solvers by their answers to one question: a row a solver and set, a small mark a scene, a large one
/// their median. Precondition: there is a score.
Drawing drawing(const ComparisonSubject& subject, const SolverQuestion& question, std::vector<Score> list) {
  const std::size_t all = list.size(), scenes = list.front().runs.size();
  list.resize(std::min(list.size(), most_rows));
  const Run& first = list.front().runs.front();
  Sheet sheet = subject.sheet(subject.comparison.title, {},
                              question.name == "accuracy"
                                  ? first_of_all(subject.comparison)
                                  : fmt::format("{}: {:.2g} in the median of {} scenes", line_label(first),
                                                list.front().median, scenes));
  const Extent reach = reach_of(list);
  RowPanel panel{{}, reach.low, reach.high};
  Plots plots(sheet, "row");
  for (const Score& score : list) {
    const Run& run = score.runs.front();
    const auto row = static_cast<double>(panel.words.size());
    const std::size_t answered = score.runs.size();
    panel.words.push_back(line_label(run) +
                          (answered < scenes ? fmt::format(" ({} of {})", answered, scenes) : ""));
    const auto mark = [&](double value) { return std::vector{std::max(value, reach.low), row}; };
    plots.add(mapped(score.values, mark),
              {fmt::format("using 1:2 with points pt 2 ps 0.7 lc rgb '{}'", style_of(run).colour)});
    plots.add({mark(score.median)}, {"using 1:2 " + mark_style(run, 1.6)});
  }
  add_rows(sheet, panel, {{question.axis, plots.list()}});
  if (all > list.size()) sheet.note(fmt::format("the first {} of {}", list.size(), all));
  sheet.note(fmt::format(
      "{}; crosses: scenes; large marks: their median; on the left edge: nothing, or too little to show",
      question.steps.empty() ? "at a step of " + duration_text(value_of(first.dt)) : question.steps));
  return sheet.finish();
}

}  // namespace

Drawing ranking(const SceneSubject& subject) {
  const std::vector<RankedSeries> rows = ranked(subject.comparison, subject.scene.name);
  if (rows.empty()) return subject.nothing("No engine run of this scene with an error.");
  const Ranges ranges =
      read_ranges(rows.front().runs.front().folder.parent_path().parent_path() / "spread.csv");
  std::vector<Run> runs;
  for (const RankedSeries& row : rows) runs.insert(runs.end(), row.runs.begin(), row.runs.end());
  const std::vector<double> steps = chosen_steps(runs);
  Sheet sheet = subject.sheet({}, answer(runs, steps));
  std::vector<RowColumn> columns;
  for (const double dt : steps) {
    Plots plots(sheet, fmt::format("rank_{}", columns.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const Run& run : rows[i].runs)
        if (run.dt == dt) add_run(plots, run, i, ranges);
    columns.push_back({"step " + duration_text(dt), plots.list()});
  }
  const Extent reach = reach_of(runs, ranges);
  add_rows(sheet, {mapped(rows, &RankedSeries::label), reach.low, reach.high}, columns);
  sheet.note(
      "RMS differences up to the horizon: of angles (rad), or of centres as a share of the least block height");
  sheet.note(ranges.empty()
                 ? "one run each"
                 : "marks: medians over replicates; thick bars: quartiles; thin: least to greatest");
  return sheet.finish();
}

Drawings solver_scores(const ComparisonSubject& subject) {
  if (!has_scores(subject.comparison)) return {};
  const auto question = std::ranges::find_if(solver_questions(), [&](const SolverQuestion& one) {
    return "solvers." + one.name == subject.figure.name;
  });
  std::vector<Score> list = scores(subject.comparison, *question);
  if (list.empty()) return {};
  return {{"", drawing(subject, *question, std::move(list))}};
}

}  // namespace rockstack::plots
