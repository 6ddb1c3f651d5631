#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "comparisons/measures/results/csv.hpp"
#include "plots/data/events.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

/// The energy of one engine run beside the exact one at the same times, and how far it is from that with what
/// its contacts have stored, J.
struct Energies {
  Run run;
  Curve exact, engine;
  Curve apart;  ///< the median of each stretch between exact impacts
};

/// The times of the exact impacts, s, none nearer to the last than a part of the whole.
std::vector<double> stretches(const Shown& shown, int blocks, double end) {
  std::vector<double> times;
  if (!shown.exact.empty() && std::filesystem::exists(shown.exact.front().folder / "events.csv"))
    for (const PatternChange& impact : read_impact_changes(shown.exact.front(), blocks))
      times.push_back(impact.time);
  std::sort(times.begin(), times.end());
  constexpr double parts = 60;
  std::vector<double> kept{0};
  for (const double time : times)
    if (time - kept.back() > end / parts) kept.push_back(time);
  while (end - kept.back() > 4 * end / parts) kept.push_back(kept.back() + 2 * end / parts);
  kept.push_back(end);
  return kept;
}

/// The median of each stretch, as a level from its begin to its end: an engine that is a little late or early
/// is far off for a moment at each impact, which says nothing of its energy.
Curve medians(const std::vector<double>& times, const std::vector<double>& values,
              const std::vector<double>& bounds) {
  Curve levels;
  std::size_t i = 0;
  for (std::size_t k = 1; k < bounds.size(); ++k) {
    std::vector<double> inside;
    for (; i < times.size() && times[i] <= bounds[k]; ++i)
      if (std::isfinite(values[i])) inside.push_back(values[i]);
    if (inside.empty()) continue;
    const auto middle = inside.begin() + static_cast<std::ptrdiff_t>(inside.size() / 2);
    std::nth_element(inside.begin(), middle, inside.end());
    for (const double at : {bounds[k - 1], bounds[k]}) {
      levels.times.push_back(at);
      levels.values.push_back(*middle);
    }
  }
  return levels;
}

Energies read_energies(const Run& run, const Shown& shown, int blocks, std::size_t bins) {
  const auto columns =
      read_columns(run.folder / "energy.csv", {"time", "exact", "engine", "input", "balance"});
  std::vector<double> apart;
  for (std::size_t i = 0; i < columns[0].size(); ++i)
    apart.push_back(columns[4][i] + columns[3][i] - columns[1][i]);
  const double end = columns[0].empty() ? 1 : std::max(columns[0].back(), 1e-9);
  return {run, thin({columns[0], columns[1]}, bins), thin({columns[0], columns[2]}, bins),
          medians(columns[0], apart, stretches(shown, blocks, end))};
}

std::string range_of(const std::vector<const Curve*>& curves, double height) {
  double low = 0, high = 0;
  for (const Curve* curve : curves)
    for (const double value : curve->values) low = std::min(low, value), high = std::max(high, value);
  const double margin = std::max(0.06 * (high - low), 1e-9);
  return fmt::format("set yrange [{}:{}]\n", plain(low - margin), plain(high + margin)) +
         linear_tics("y", low - margin, high + margin, height) + "set format y '%.5g'\n";
}

std::vector<std::string> level_plots(const std::vector<Energies>& all) {
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < all.size(); ++i)
    plots.push_back(
        all.size() > most_series
            ? fmt::format("$engine_{} using 1:2 with lines lw 1 lc rgb '{}' notitle", i, context_colour)
            : fmt::format("$engine_{} using 1:2 {} notitle", i, curve_style(all[i].run, i)));
  plots.push_back(fmt::format("$exact using 1:2 {} notitle", exact_style));
  plots.emplace_back("$exact using 1:2 with lines lw 1 lc rgb '#000000' notitle");
  return plots;
}

std::vector<std::string> apart_plots(const std::vector<Energies>& all) {
  std::vector<std::string> plots{zero_line};
  for (std::size_t i = 0; i < all.size(); ++i)
    plots.push_back(fmt::format("$apart_{} using 1:2 {} notitle", i, curve_style(all[i].run, i)));
  return plots;
}

void add_small_panels(Sheet& sheet, const std::vector<Energies>& all, const std::string& settings) {
  std::vector<Multiple> series;
  std::vector<std::string> context{zero_line};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string data = fmt::format("$apart_{} using 1:2 with lines ", i);
    const std::string colour = style_of(all[i].run).colour;
    context.push_back(data + fmt::format("lw 1 lc rgb '{}' notitle", context_colour));
    series.push_back(
        {line_label(all[i].run), colour, {data + fmt::format("lw 2 lc rgb '{}' notitle", colour)}});
  }
  add_multiples(sheet, series, context, settings, "time (s)", "engine − exact (J)");
}

Legend legend_of(const std::vector<Energies>& all) {
  Legend legend{{exact_style, "exact"}};
  if (all.size() > most_series)
    legend.emplace_back(fmt::format("with lines lw 1 lc rgb '{}'", context_colour), "engines");
  else
    for (std::size_t i = 0; i < all.size(); ++i)
      legend.emplace_back(curve_style(all[i].run, i), run_label(all[i].run));
  return legend;
}

/// The exact curve of the run that lasts longest.
const Curve& longest_exact(const std::vector<Energies>& all) {
  const auto last = [](const Energies& one) { return one.exact.times.empty() ? 0 : one.exact.times.back(); };
  return std::max_element(all.begin(), all.end(),
                          [&](const Energies& a, const Energies& b) { return last(a) < last(b); })
      ->exact;
}

double largest_of(const Curve& curve) {
  double largest = 0;
  for (const double value : curve.values) largest = std::max(largest, std::abs(value));
  return largest;
}

std::string question(const std::vector<Energies>& all) {
  const auto nearest = std::min_element(all.begin(), all.end(), [](const Energies& a, const Energies& b) {
    return largest_of(a.apart) < largest_of(b.apart);
  });
  return fmt::format("Do engines lose energy as they should? Nearest between impacts: {}, within {:.3g} J",
                     run_phrase(nearest->run), largest_of(nearest->apart));
}

}  // namespace

Drawing energy(const Comparison& comparison, const ComparedScene& scene) {
  const Shown shown = shown_runs(comparison, scene.name);
  std::vector<Energies> all;
  for (const Run& run : shown.engines)
    if (std::filesystem::exists(run.folder / "energy.csv"))
      all.push_back(read_energies(run, shown, scene.blocks, bins_for(3 * shown.engines.size())));
  if (all.empty()) return empty_sheet(heading(scene), "No engine run of this scene tells its energy.");
  const Curve& exact = longest_exact(all);
  const double end = exact.times.empty() ? 1 : std::max(exact.times.back(), 1e-9);
  std::vector<const Curve*> levels{&exact}, differences;
  Sheet sheet(heading(scene), legend_of(all), question(all));
  sheet.data(data_block("exact", exact));
  for (std::size_t i = 0; i < all.size(); ++i) {
    levels.push_back(&all[i].engine);
    differences.push_back(&all[i].apart);
    sheet.data(data_block(fmt::format("engine_{}", i), all[i].engine));
    sheet.data(data_block(fmt::format("apart_{}", i), all[i].apart));
  }
  const std::string across = fmt::format("set xrange [0:{}]\n", plain(end)) + grid_lines;
  constexpr double tall = 380, low = 260, gap = 20;
  sheet.panel(tall, 0,
              across + range_of(levels, tall) + without_horizontal_labels() +
                  "set ylabel 'energy above rest (J)' offset 0\n",
              level_plots(all));
  if (all.size() > most_series)
    add_small_panels(sheet, all, across + range_of(differences, multiple_height));
  else
    sheet.panel(low, gap,
                across + range_of(differences, low) +
                    "set xlabel 'time (s)'\nset ylabel 'engine − exact, median (J)' offset 0\n",
                apart_plots(all));
  return sheet.finish();
}

}  // namespace rockstack::plots
