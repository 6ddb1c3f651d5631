#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "comparisons/measures/results/csv.hpp"
#include "plots/data/selection.hpp"
#include "plots/data/spread.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

/// Absolute differences of one engine run, one curve a block, and how long each draw agrees.
struct Departure {
  Run run;
  std::vector<Curve> sizes;
  std::vector<double> agreement_times;  ///< s, rising; one where there are no draws
  double end = 0;                       ///< last time, s
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
  if (departure.agreement_times.empty()) departure.agreement_times = {run.agreement_time};
  if (!columns[0].empty()) departure.end = columns[0].back();
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
      std::vector<double> values = curve.values;
      if (values.empty()) continue;
      std::sort(values.begin(), values.end());
      high = std::max(high, values.back());
      low = std::min(low, values[values.size() / 10]);
    }
  low = std::max(low, tolerance * 1e-7);
  return {std::pow(10, std::floor(std::log10(low))), std::pow(10, std::ceil(std::log10(high) - 1e-9))};
}

std::string difference_name(std::size_t run, std::size_t block) {
  return fmt::format("difference_{}_{}", run, block + 1);
}

std::vector<std::string> panel_plots(const std::vector<Departure>& departures, std::size_t block,
                                     double tolerance) {
  std::vector<std::string> plots{fmt::format("{} {} notitle", plain(tolerance), tolerance_style)};
  for (std::size_t i = 0; i < departures.size(); ++i)
    if (!departures[i].sizes[block].times.empty())
      plots.push_back(fmt::format("${} using 1:2 {} notitle", difference_name(i, block),
                                  curve_style(departures[i].run, i)));
  return plots;
}

/// The axis' end, after the last time, so that marks of runs that agree to the end stand free.
double axis_end(const std::vector<Departure>& departures) {
  constexpr double room = 1.012;
  double end = 1e-9;
  for (const Departure& departure : departures) end = std::max(end, departure.end);
  return room * end;
}

std::string settings_of(const std::vector<Departure>& departures, const LogRange& range, double height) {
  return fmt::format("set xrange [0:{}]\nset logscale y\nset yrange [{}:{}]\n", plain(axis_end(departures)),
                     plain(range.low), plain(range.high)) +
         logarithmic_tics("y", range.low, range.high, height) + grid_lines;
}

void add_panels(Sheet& sheet, const std::vector<Departure>& departures, const LogRange& range,
                double tolerance, bool together) {
  const std::size_t blocks = departures.front().sizes.size();
  const double height = panel_height(static_cast<int>(blocks));
  for (std::size_t k = 0; k < blocks; ++k) {
    const std::string words =
        together ? "largest |Δθ|" : fmt::format("|Δ{}|", angle_name(static_cast<int>(k) + 1));
    sheet.panel(height, 20,
                settings_of(departures, range, height) + without_horizontal_labels() +
                    fmt::format("set ylabel '{} (rad)' offset 0.5\n", words),
                panel_plots(departures, k, tolerance));
  }
}

void add_small_panels(Sheet& sheet, const std::vector<Departure>& departures, const LogRange& range,
                      double tolerance) {
  std::vector<Multiple> series;
  std::vector<std::string> context{fmt::format("{} {} notitle", plain(tolerance), tolerance_style)};
  for (std::size_t i = 0; i < departures.size(); ++i) {
    const std::string data = "$" + difference_name(i, 0) + " using 1:2 with lines lw {} lc rgb '{}' notitle";
    const std::string colour = style_of(departures[i].run).colour;
    context.push_back(fmt::format(fmt::runtime(data), 1, context_colour));
    series.push_back({line_label(departures[i].run), colour, {fmt::format(fmt::runtime(data), 2.5, colour)}});
  }
  add_multiples(sheet, series, context, settings_of(departures, range, multiple_height), "time (s)",
                "largest |Δθ| (rad)");
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
void add_agreements(Sheet& sheet, const std::vector<Departure>& departures) {
  std::vector<std::string> plots;
  const double end = axis_end(departures);
  for (std::size_t i = 0; i < departures.size(); ++i) {
    const Departure& one = departures[i];
    const auto row = static_cast<double>(departures.size() - i);
    sheet.data(data_block(fmt::format("agree_{}", i),
                          {one.agreement_times, std::vector<double>(one.agreement_times.size(), row)}));
    const Style style = style_of(one.run);
    plots.push_back(fmt::format("$agree_{} using 1:2 with points pt 2 ps 0.7*mark lw 1 lc rgb '{}' notitle",
                                i, style.colour));
    plots.push_back(fmt::format("'+' every ::0::0 using ({}):({}) {} notitle", plain(one.run.agreement_time),
                                plain(row), mark_style(one.run, 1.6)));
  }
  constexpr double row_height = 22, room_for_names = 0.34;
  const bool named = departures.size() > most_series;
  const std::string rows = named ? row_names(departures)
                                 : "unset ytics\nset label 2 'agrees until' at graph 0, graph 0.5 right "
                                   "offset -0.6,0 font ',12'\n";
  sheet.row(row_height * (static_cast<double>(departures.size()) + 1), named ? 84 : 20,
            {{fmt::format("set xrange [0:{}]\nset yrange [0:{}]\nset xlabel '{}time (s)'\n", plain(end),
                          departures.size() + 1, named ? "agrees until " : "") +
                  grid_lines + rows,
              plots}},
            1, named ? room_for_names : left_edge);
}

std::string question(const std::vector<Departure>& departures, double tolerance) {
  const auto longest =
      std::max_element(departures.begin(), departures.end(), [](const Departure& a, const Departure& b) {
        if (is_variant(a.run) != is_variant(b.run)) return is_variant(a.run);
        return a.run.agreement_time < b.run.agreement_time;
      });
  return fmt::format(
      "How far off is each engine, and from when? Longest within {} rad: {}, {:.3g} of {:.3g} s", tolerance,
      run_phrase(longest->run), longest->run.agreement_time, longest->end);
}

Legend legend_of(const std::vector<Departure>& departures) {
  Legend legend;
  if (departures.size() <= most_series)
    for (std::size_t i = 0; i < departures.size(); ++i)
      legend.emplace_back(curve_style(departures[i].run, i), run_label(departures[i].run));
  legend.emplace_back(tolerance_style, "tolerance");
  return legend;
}

}  // namespace

Drawing differences(const Comparison& comparison, const ComparedScene& scene) {
  const std::vector<Run> runs = shown_runs(comparison, scene.name).engines;
  if (runs.empty()) return empty_sheet(heading(scene), "No engine run of this scene to compare.");
  constexpr int most_blocks = 4;  // with a panel each
  const bool many = runs.size() > most_series, together = many || scene.blocks > most_blocks;
  const std::size_t curves = runs.size() * (many ? runs.size() : 2 * static_cast<std::size_t>(scene.blocks));
  std::vector<Departure> departures;
  for (const Run& run : runs)
    if (std::filesystem::exists(run.folder / "difference.csv"))
      departures.push_back(read_departure(run, scene.blocks, bins_for(curves), together));
  if (departures.empty()) return empty_sheet(heading(scene), "No exact run of this scene to compare with.");
  const LogRange range = range_of(departures, comparison.tolerance);
  Sheet sheet(heading(scene), legend_of(departures), question(departures, comparison.tolerance));
  for (std::size_t i = 0; i < departures.size(); ++i)
    for (std::size_t k = 0; k < departures[i].sizes.size(); ++k)
      sheet.data(data_block(difference_name(i, k), departures[i].sizes[k]));
  if (many)
    add_small_panels(sheet, departures, range, comparison.tolerance);
  else
    add_panels(sheet, departures, range, comparison.tolerance, together);
  add_agreements(sheet, departures);
  return sheet.finish();
}

}  // namespace rockstack::plots
