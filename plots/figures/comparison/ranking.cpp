#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "plots/data/selection.hpp"
#include "plots/data/spread.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/row_words.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

using Ranges = std::map<std::string, SpreadRange>;

bool has_error(const Run& run) {
  return !is_variant(run) && std::isfinite(run.rms_angle_difference) && run.rms_angle_difference > 0;
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
      whole.largest = std::max(whole.largest, run.rms_angle_difference);
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

/// The largest, the middle and the smallest of the time steps; or all, where there are fewer.
std::vector<double> steps_of(const std::vector<RankedSeries>& rows) {
  std::set<double> all;
  for (const RankedSeries& row : rows)
    for (const Run& run : row.runs) all.insert(run.dt);
  std::vector<double> steps(all.rbegin(), all.rend());
  if (steps.size() > 3) steps = {steps.front(), steps[steps.size() / 2], steps.back()};
  return steps;
}

/// A run's error, its quartiles and its whole range over draws.
std::string point(const Run& run, std::size_t row, const Ranges& ranges) {
  const auto found = ranges.find(run.name);
  const double error = run.rms_angle_difference;
  const SpreadRange range = found == ranges.end() ? SpreadRange{error, error} : found->second;
  const auto shown = [](double value) { return plain(std::max(value, least_error)); };
  return fmt::format(
      "{} {} {} {} {} {}\n", shown(error), row, shown(quartile_or(run.rms_angle_difference_lower, error)),
      shown(quartile_or(run.rms_angle_difference_upper, error)), shown(range.least), shown(range.greatest));
}

struct ErrorExtent {
  double low = std::numeric_limits<double>::infinity(), high = 0;
};

ErrorExtent extent_of(const std::vector<RankedSeries>& rows, const Ranges& ranges) {
  ErrorExtent extent;
  for (const RankedSeries& row : rows)
    for (const Run& run : row.runs) {
      const auto found = ranges.find(run.name);
      const double error = run.rms_angle_difference;
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

RowWords words_of(const std::vector<RankedSeries>& rows) {
  std::vector<std::string> labels;
  labels.reserve(rows.size());
  for (const RankedSeries& row : rows) labels.push_back(row.label);
  return row_words(labels);
}

const Run& least_of(const std::vector<RankedSeries>& rows) {
  const Run* least = &rows.front().runs.front();
  for (const RankedSeries& row : rows)
    for (const Run& run : row.runs)
      if (run.rms_angle_difference < least->rms_angle_difference) least = &run;
  return *least;
}

}  // namespace

Drawing ranking(const Comparison& comparison, const ComparedScene& scene) {
  const std::vector<RankedSeries> rows = ranked(comparison, scene.name);
  if (rows.empty()) return empty_sheet(heading(scene), "No engine run of this scene with an error.");
  const Ranges ranges =
      ranges_of(rows.front().runs.front().folder.parent_path().parent_path(), "rms_angle_difference");
  const Run& least = least_of(rows);
  Sheet sheet(heading(scene), {},
              fmt::format("Which is nearest to the exact motion? {}, {} RMS", run_phrase(least),
                          off_by(least.rms_angle_difference)));
  const ErrorExtent extent = extent_of(rows, ranges);
  const std::vector<double> steps = steps_of(rows);
  const RowWords words = words_of(rows);
  constexpr double pixels = 1200;
  const double width = (right_edge - words.left) * pixels / static_cast<double>(steps.size());
  std::vector<SidePanel> cells;
  for (std::size_t i = 0; i < steps.size(); ++i)
    cells.push_back({fmt::format("set logscale x\nset xrange [{}:{}]\nset yrange [{}:-0.7]\n"
                                 "set grid x y lt 1 dt solid lw 1 lc rgb '#E4E4E4'\n"
                                 "set xlabel 'step {}'\n",
                                 plain(extent.low), plain(extent.high),
                                 static_cast<double>(rows.size()) - 0.3, duration_text(steps[i])) +
                         (i == 0 ? words.tics : words.blank) +
                         logarithmic_tics("x", extent.low, extent.high, width),
                     column_plots(sheet, rows, steps[i], i, ranges)});
  sheet.row(row_height(words) * static_cast<double>(rows.size()) + 30, 0, cells, cells.size(), words.left);
  sheet.note("RMS angle differences (rad)", "#000000");
  sheet.note(ranges.empty()
                 ? "one run each"
                 : "marks: medians over replicates; thick bars: quartiles; thin: least to greatest",
             "#000000");
  return sheet.finish();
}

}  // namespace rockstack::plots
