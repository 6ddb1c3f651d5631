#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "plots/data/run_files.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/rows.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

using Ranges = std::map<std::string, SpreadRange>;

bool has_error(const Run& run) {
  return !is_variant(run) && run.error > 0;
}

/// One row: the runs of a series that have errors, and what the rows are ordered by.
struct RankedSeries {
  std::string label;
  std::vector<Run> runs;
  std::size_t steps = 0;  ///< of the whole line
  double largest = 0;     ///< error of the whole line
};

/// A row for the whole line, or one for each number of iterations, rising, where these vary.
std::vector<RankedSeries> rows_of(const StepLine& line) {
  RankedSeries whole{line_label(line), {}, 0, 0};
  for (const Run& run : line)
    if (has_error(run)) {
      whole.runs.push_back(run);
      whole.largest = std::max(whole.largest, *run.error);
    }
  if (whole.runs.empty()) return {};
  if (!varies_iterations(line)) {
    whole.steps = whole.runs.size();
    return {whole};
  }
  std::vector<RankedSeries> rows;
  for (auto run = whole.runs.rbegin(); run != whole.runs.rend(); ++run)
    rows.push_back({line_label(*run), {*run}, 1, whole.largest});
  return rows;
}

/// Rows by rising error, those with more steps first; at most so many that a page shows.
std::vector<RankedSeries> ranked(const Comparison& comparison, const std::string& scene) {
  std::vector<RankedSeries> rows;
  for (const StepLine& line : step_lines(comparison, scene))
    for (const RankedSeries& row : rows_of(line)) rows.push_back(row);
  std::stable_sort(rows.begin(), rows.end(), [](const RankedSeries& a, const RankedSeries& b) {
    return a.steps != b.steps ? a.steps > b.steps : a.largest < b.largest;
  });
  rows.resize(std::min(rows.size(), most_rows));
  return rows;
}

/// A run's error, its quartiles and its whole range over draws.
std::string point(const Run& run, std::size_t row, const Ranges& ranges) {
  const auto found = ranges.find(run.run);
  const double error = *run.error;
  const SpreadRange range = found == ranges.end() ? SpreadRange{error, error} : found->second;
  const auto shown = [](double value) { return plain(std::max(value, least_error)); };
  return fmt::format("{} {} {} {} {} {}\n", shown(error), row, shown(run.error_lower.value_or(error)),
                     shown(run.error_upper.value_or(error)), shown(range.least), shown(range.greatest));
}

struct ErrorExtent {
  double low = std::numeric_limits<double>::infinity(), high = 0;
};

ErrorExtent extent_of(const std::vector<RankedSeries>& rows, const Ranges& ranges) {
  ErrorExtent extent;
  for (const RankedSeries& row : rows)
    for (const Run& run : row.runs) {
      const auto found = ranges.find(run.run);
      const double error = *run.error;
      extent.low =
          std::min(extent.low, found == ranges.end() ? error : std::max(found->second.least, error / 100));
      extent.high = std::max(extent.high, found == ranges.end() ? error : found->second.greatest);
    }
  const double low = std::max(extent.low, least_error), high = std::max(extent.high, least_error);
  const double room = std::max(1.5, std::pow(high / low, 0.04));
  return {low / room, high * room};
}

std::vector<std::string> column_plots(Sheet& sheet, const std::vector<RankedSeries>& rows, double dt,
                                      std::size_t at, const Ranges& ranges) {
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const Run& run : rows[i].runs) {
      if (run.dt != dt) continue;
      const std::string name = fmt::format("rank_{}_{}_{}", at, i, plots.size());
      const std::string colour = style_of(run).colour;
      sheet.data("$" + name + " << END\n" + point(run, i, ranges) + "END\n");
      plots.push_back(
          fmt::format("${} using 1:2:5:6 with xerrorbars lw 1 lc rgb '{}' pt 0 notitle", name, colour));
      plots.push_back(
          fmt::format("${} using 1:2:3:4 with xerrorbars lw 4 lc rgb '{}' pt 0 notitle", name, colour));
      plots.push_back(fmt::format("${} using 1:2 {} notitle", name, mark_style(run, 1.4)));
    }
  return plots;
}

/// Which rows share the first rank, step by step.
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

}  // namespace

Drawing ranking(const SceneSubject& subject) {
  const Comparison& comparison = subject.comparison;
  const ComparedScene& scene = subject.scene;
  const std::vector<RankedSeries> rows = ranked(comparison, scene.name);
  if (rows.empty()) return subject.nothing("No engine run of this scene with an error.");
  const Ranges ranges = ranges_of(rows.front().runs.front().folder.parent_path().parent_path(), "error");
  const ErrorExtent extent = extent_of(rows, ranges);
  RowPanel panel{{}, extent.low, extent.high};
  std::vector<Run> runs;
  for (const RankedSeries& row : rows) {
    panel.words.push_back(row.label);
    runs.insert(runs.end(), row.runs.begin(), row.runs.end());
  }
  const std::vector<double> steps = chosen_steps(runs);
  Sheet sheet = subject.sheet({}, answer(runs, steps));
  std::vector<RowColumn> columns;
  columns.reserve(steps.size());
  for (const double dt : steps)
    columns.push_back({"step " + duration_text(dt), column_plots(sheet, rows, dt, columns.size(), ranges)});
  add_rows(sheet, panel, columns);
  sheet.note(
      "RMS differences up to the horizon: of angles (rad), or of centres as a share of the least block height",
      "#000000");
  sheet.note(ranges.empty()
                 ? "one run each"
                 : "marks: medians over replicates; thick bars: quartiles; thin: least to greatest",
             "#000000");
  return sheet.finish();
}

}  // namespace rockstack::plots
