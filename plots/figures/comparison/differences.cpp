#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "comparisons/results/csv.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

/// Absolute differences of one engine run, one curve a block.
struct Departure {
  Run run;
  std::vector<Curve> sizes;
  double end = 0;  ///< last time, s
};

struct LogRange {
  double low, high;
};

Departure read_departure(const Run& run, int blocks, std::size_t bins, double floor) {
  std::vector<std::string> names = numbered("difference_", blocks);
  names.insert(names.begin(), "time");
  std::vector<std::vector<double>> columns = read_columns(run.folder / "difference.csv", names);
  Departure departure{.run = run, .sizes = {}};
  if (!columns[0].empty()) departure.end = columns[0].back();
  for (std::size_t k = 1; k < columns.size(); ++k)
    departure.sizes.push_back(envelope(Curve{columns[0], std::move(columns[k])}, bins, floor));
  return departure;
}

/// Powers of ten around the tolerance and all that is drawn.
LogRange range_of(const std::vector<Departure>& departures, double tolerance, double floor) {
  double low = tolerance / 10, high = tolerance * 10;
  for (const Departure& departure : departures)
    for (const Curve& curve : departure.sizes)
      for (const double value : curve.values) {
        high = std::max(high, value);
        if (value > floor) low = std::min(low, value);
      }
  return {std::pow(10, std::floor(std::log10(low))), std::pow(10, std::ceil(std::log10(high) - 1e-9))};
}

std::string difference_name(std::size_t run, std::size_t block) {
  return fmt::format("difference_{}_{}", run, block + 1);
}

/// Where a run's agreement ends: its mark, filled, on the line of the tolerance.
std::string agreement_mark(const Departure& departure, const Styles& styles, double tolerance) {
  return fmt::format("'+' every ::0::0 using ({}):({}) {} notitle", plain(departure.run.agreement_time),
                     plain(tolerance), mark_style(styles.at(solver_name(departure.run)), true, 1.5));
}

std::vector<std::string> panel_plots(const std::vector<Departure>& departures, const Styles& styles,
                                     std::size_t block, double tolerance) {
  std::vector<std::string> plots{
      fmt::format("{} with lines lw 2 dt (5,8) lc rgb '#666666' notitle", plain(tolerance))};
  for (std::size_t i = 0; i < departures.size(); ++i)
    if (!departures[i].sizes[block].times.empty())
      plots.push_back(fmt::format("${} using 1:2 {} notitle", difference_name(i, block),
                                  curve_style(styles, departures[i].run, i)));
  for (const Departure& departure : departures)
    if (departure.run.agreement_time < departure.end)
      plots.push_back(agreement_mark(departure, styles, tolerance));
  return plots;
}

double last_time(const std::vector<Departure>& departures) {
  double end = 1e-9;
  for (const Departure& departure : departures) end = std::max(end, departure.end);
  return end;
}

Legend legend_of(const std::vector<Departure>& departures, const Styles& styles) {
  Legend legend;
  for (std::size_t i = 0; i < departures.size(); ++i)
    legend.emplace_back(curve_style(styles, departures[i].run, i), run_label(departures[i].run));
  legend.emplace_back("with lines lw 2 dt (5,8) lc rgb '#666666'", "tolerance; filled mark: agreement ends");
  return legend;
}

}  // namespace

Drawing differences(const Comparison& comparison, const ComparedScene& scene, const Styles& styles) {
  const std::vector<Run> runs = shown_runs(comparison, scene.name).engines;
  if (runs.empty()) return empty_sheet(heading(scene), "No engine run of this scene to compare.");
  const auto blocks = static_cast<std::size_t>(scene.blocks);
  const double floor = std::min(comparison.tolerance * 1e-4, 1e-6);
  std::vector<Departure> departures;
  for (const Run& run : runs)
    if (std::filesystem::exists(run.folder / "difference.csv"))
      departures.push_back(read_departure(run, scene.blocks, bins_for(2 * runs.size() * blocks), floor));
  if (departures.empty()) return empty_sheet(heading(scene), "No exact run of this scene to compare with.");
  const LogRange range = range_of(departures, comparison.tolerance, floor);

  Sheet sheet(heading(scene), legend_of(departures, styles));
  for (std::size_t i = 0; i < departures.size(); ++i)
    for (std::size_t k = 0; k < blocks; ++k)
      sheet.data(data_block(difference_name(i, k), departures[i].sizes[k]));
  for (std::size_t k = 0; k < blocks; ++k)
    sheet.panel(
        panel_height(scene.blocks), 28,
        fmt::format("set xrange [0:{}]\nset logscale y\nset yrange [{}:{}]\nset format y '10^{{%T}}'\n"
                    "set grid lt 1 dt solid lw 1 lc rgb '#E4E4E4'\nset ylabel '|difference in {}| (rad)' "
                    "offset 0.5\n",
                    plain(last_time(departures)), plain(range.low), plain(range.high),
                    angle_name(static_cast<int>(k) + 1)) +
            (k + 1 == blocks ? "set format x '%g'\nset xlabel 'time (s)'\n" : without_horizontal_labels()),
        panel_plots(departures, styles, k, comparison.tolerance));
  return sheet.finish();
}

}  // namespace rockstack::plots
