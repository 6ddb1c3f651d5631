#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/statistics/quantile.hpp"
#include "plots/data/run_files.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/series.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// Absolute differences of one engine run, one curve a block, and how long each draw agrees.
struct Departure {
  Run run;
  std::vector<Curve> sizes;
  std::vector<double> agreement_times;  ///< s, rising; one where there are no draws
};

struct LogRange {
  double low, high;
};

constexpr auto tolerance_style = "with lines lw 2 dt (5,8) lc rgb '#666666'";

/// The largest absolute value over all blocks at each time.
std::vector<double> largest_of(const std::vector<std::vector<double>>& columns) {
  std::vector<double> largest(columns[0].size(), 0);
  for (std::size_t k = 1; k < columns.size(); ++k)
    for (std::size_t i = 0; i < largest.size(); ++i)
      largest[i] = std::max(largest[i], std::abs(columns[k][i]));
  return largest;
}

/// One curve a block, or where `together` is set one of all of them.
Departure read_departure(const Run& run, int blocks, std::size_t bins, bool together) {
  std::vector<std::string> names = numbered("difference_", blocks);
  names.insert(names.begin(), "time");
  std::vector<std::vector<double>> columns = read_columns(run.folder / "difference.csv", names);
  if (together) columns = {columns[0], largest_of(columns)};
  Departure departure{.run = run, .sizes = {}, .agreement_times = draws_of(run, "agreement_time")};
  if (departure.agreement_times.empty()) departure.agreement_times = {value_of(run.agreement_time)};
  constexpr double nothing = 1e-30;  // under every axis: a curve that is nearer leaves the panel
  for (std::size_t k = 1; k < columns.size(); ++k)
    departure.sizes.push_back(envelope(Curve{columns[0], std::move(columns[k])}, bins, nothing));
  return departure;
}

/// Powers of ten around the tolerance, the largest difference and what each curve mostly is.
LogRange range_of(const std::vector<Departure>& departures, double tolerance) {
  double low = tolerance / 100, high = tolerance * 10;
  for (const Departure& departure : departures)
    for (const Curve& curve : departure.sizes) {
      if (curve.values.empty()) continue;
      high = std::max(high, quantile(curve.values, 1));
      low = std::min(low, quantile(curve.values, 0.1));
    }
  low = std::max(low, tolerance * 1e-7);
  return {std::pow(10, std::floor(std::log10(low))), std::pow(10, std::ceil(std::log10(high) - 1e-9))};
}

/// Behind the axis' end, so that marks of runs that agree to the end stand free.
constexpr double room_for_marks = 1.012;

/// One panel a curve of each run; small ones where runs are many, whose curve is that of all blocks.
void add_panels(Sheet& sheet, const std::vector<Departure>& departures, const LogRange& range,
                const TimeAxis& axis, double tolerance, bool together) {
  const std::size_t panels = departures.front().sizes.size();
  for (std::size_t k = 0; k < panels; ++k) {
    std::vector<Series> series;
    for (std::size_t i = 0; i < departures.size(); ++i) {
      const std::string name = fmt::format("difference_{}_{}", i, k + 1);
      const Curve& sizes = departures[i].sizes[k];
      sheet.data(data_block(name, sizes));
      if (sizes.size() > 0) series.push_back(curve_series(departures[i].run, name, i, {2.5, true}));
    }
    const std::string words =
        together ? "largest |Δθ| (rad)" : fmt::format("|Δ{}| (rad)", angle_name(static_cast<int>(k) + 1));
    const auto axes = [&](double, double height) {
      return time_range(axis, room_for_marks) + logarithmic_range("y", range.low, range.high, height) +
             grid_lines;
    };
    add_series(sheet,
               {"time (s)",
                words,
                words,
                false,
                axes,
                panel_height(static_cast<int>(panels)),
                20,
                {fmt::format("{} {} notitle", plain(tolerance), tolerance_style)}},
               series, departures.size() > most_series);
  }
}

/// The runs' names beside their rows, where no legend has them.
std::string row_names(const std::vector<Departure>& departures) {
  std::string tics;
  for (std::size_t i = 0; i < departures.size(); ++i)
    tics += fmt::format("{}{} {}", i > 0 ? ", " : "", in_quotes(line_label(departures[i].run)),
                        departures.size() - i);
  return "set ytics (" + tics + ") noenhanced font ',11'\n";
}

/// A row a run: when each draw first passes the tolerance, and their median, filled.
void add_agreements(Sheet& sheet, const std::vector<Departure>& departures, const TimeAxis& axis) {
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < departures.size(); ++i) {
    const Departure& one = departures[i];
    const auto row = static_cast<double>(departures.size() - i);
    sheet.data(data_block(fmt::format("agree_{}", i),
                          {one.agreement_times, std::vector<double>(one.agreement_times.size(), row)}));
    const Style style = style_of(one.run);
    plots.push_back(fmt::format("$agree_{} using 1:2 with points pt 2 ps 0.7*mark lw 1 lc rgb '{}' notitle",
                                i, style.colour));
    plots.push_back(fmt::format("'+' every ::0::0 using ({}):({}) {} notitle",
                                plain(value_of(one.run.agreement_time)), plain(row),
                                mark_style(one.run, 1.6)));
  }
  constexpr double row_height = 22, room_for_names = 0.34;
  const bool named = departures.size() > most_series;
  const std::string rows = named ? row_names(departures)
                                 : "unset ytics\nset label 2 'agrees until' at graph 0, graph 0.5 right "
                                   "offset -0.6,0 font ',12'\n";
  sheet.row(row_height * (static_cast<double>(departures.size()) + 1), named ? 84 : 20,
            {{time_range(axis, room_for_marks) +
                  fmt::format("set yrange [0:{}]\nset xlabel '{}time (s)'\n", departures.size() + 1,
                              named ? "agrees until " : "") +
                  grid_lines + rows,
              plots}},
            1, named ? room_for_names : left_edge);
}

/// The first and the last time at which an engine passes the tolerance.
std::string answer(const std::vector<Departure>& departures, const ComparedScene& scene, double tolerance) {
  double first = scene.horizon(), last = 0;
  for (const Departure& one : departures) {
    if (is_variant(one.run)) continue;
    first = std::min(first, one.run.agreement_time.value_or(first));
    last = std::max(last, one.run.agreement_time.value_or(last));
  }
  return fmt::format("Within {} rad until {} of {} that can be compared", tolerance,
                     span_text(rounded_duration(first), rounded_duration(std::max(first, last))),
                     duration_text(scene.horizon()));
}

}  // namespace

Drawing differences(const SceneSubject& subject) {
  const Comparison& comparison = subject.comparison;
  const ComparedScene& scene = subject.scene;
  const Shown shown = shown_runs(comparison, scene.name);
  std::vector<Run> runs = shown.engines;
  if (runs.empty()) return subject.nothing("No engine run of this scene to compare.");
  std::erase_if(runs, [](const Run& run) { return !std::filesystem::exists(run.folder / "difference.csv"); });
  if (runs.empty()) return subject.nothing("No exact run of this scene to compare with.");
  constexpr int most_blocks = 4;  // with a panel each
  const bool many = are_many(runs), together = many || scene.blocks() > most_blocks;
  const std::size_t curves =
      runs.size() * (many ? runs.size() : 2 * static_cast<std::size_t>(scene.blocks()));
  std::vector<Departure> departures;
  departures.reserve(runs.size());
  for (const Run& run : runs)
    departures.push_back(read_departure(run, scene.blocks(), bins_for(curves), together));
  Legend legend = legend_of(runs, curve_style);
  legend.emplace_back(tolerance_style, "tolerance");
  std::vector<Run> motions = shown.exact;
  motions.insert(motions.end(), runs.begin(), runs.end());
  const TimeAxis axis = time_axis(scene, motions);
  explain_shade(axis, legend);
  Sheet sheet = subject.sheet(legend, answer(departures, scene, comparison.tolerance));
  add_panels(sheet, departures, range_of(departures, comparison.tolerance), axis, comparison.tolerance,
             together);
  add_agreements(sheet, departures, axis);
  return sheet.finish();
}

}  // namespace rockstack::plots
