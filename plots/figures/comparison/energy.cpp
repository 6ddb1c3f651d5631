#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "comparisons/results/csv.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

/// The energy of one engine run beside the exact one at the same times, and how far it is from that with what
/// its contacts have stored, J.
struct Energies {
  Run run;
  Curve exact, engine, apart;
};

Energies read_energies(const Run& run, std::size_t bins) {
  const auto columns =
      read_columns(run.folder / "energy.csv", {"time", "exact", "engine", "input", "balance"});
  std::vector<double> apart;
  for (std::size_t i = 0; i < columns[0].size(); ++i)
    apart.push_back(columns[4][i] + columns[3][i] - columns[1][i]);
  return {run, thin({columns[0], columns[1]}, bins), thin({columns[0], columns[2]}, bins),
          thin({columns[0], apart}, bins)};
}

std::string range_of(const std::vector<const Curve*>& curves) {
  double low = 0, high = 0;
  for (const Curve* curve : curves)
    for (const double value : curve->values) low = std::min(low, value), high = std::max(high, value);
  const double margin = std::max(0.06 * (high - low), 1e-9);
  return fmt::format("set yrange [{}:{}]\n", plain(low - margin), plain(high + margin));
}

constexpr auto grid = "set grid lt 1 dt solid lw 1 lc rgb '#E4E4E4'\n";
constexpr auto core_style = "with lines lw 1 lc rgb '#000000'";

std::vector<std::string> level_plots(const std::vector<Energies>& all, const Styles& styles) {
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < all.size(); ++i)
    plots.push_back(fmt::format("$engine_{} using 1:2 {} notitle", i, curve_style(styles, all[i].run, i)));
  plots.push_back(fmt::format("$exact using 1:2 {} notitle", exact_style));
  plots.push_back(fmt::format("$exact using 1:2 {} notitle", core_style));
  return plots;
}

std::vector<std::string> apart_plots(const std::vector<Energies>& all, const Styles& styles) {
  std::vector<std::string> plots{"0 with lines lw 1.5 lc rgb '#000000' notitle"};
  for (std::size_t i = 0; i < all.size(); ++i)
    plots.push_back(fmt::format("$apart_{} using 1:2 {} notitle", i, curve_style(styles, all[i].run, i)));
  return plots;
}

Legend legend_of(const std::vector<Energies>& all, const Styles& styles) {
  Legend legend{{exact_style, "exact"}};
  for (std::size_t i = 0; i < all.size(); ++i)
    legend.emplace_back(curve_style(styles, all[i].run, i), run_label(all[i].run));
  return legend;
}

/// The exact curve of the run that lasts longest.
const Curve& longest_exact(const std::vector<Energies>& all) {
  const auto last = [](const Energies& one) { return one.exact.times.empty() ? 0 : one.exact.times.back(); };
  return std::max_element(all.begin(), all.end(),
                          [&](const Energies& a, const Energies& b) { return last(a) < last(b); })
      ->exact;
}

}  // namespace

Drawing energy(const Comparison& comparison, const ComparedScene& scene, const Styles& styles) {
  const std::vector<Run> runs = shown_runs(comparison, scene.name).engines;
  std::vector<Energies> all;
  for (const Run& run : runs)
    if (std::filesystem::exists(run.folder / "energy.csv"))
      all.push_back(read_energies(run, bins_for(3 * runs.size())));
  if (all.empty()) return empty_sheet(heading(scene), "No engine run of this scene tells its energy.");
  const Curve& exact = longest_exact(all);
  const double end = exact.times.empty() ? 1 : std::max(exact.times.back(), 1e-9);
  std::vector<const Curve*> levels{&exact}, differences;
  Sheet sheet(heading(scene), legend_of(all, styles));
  sheet.data(data_block("exact", exact));
  for (std::size_t i = 0; i < all.size(); ++i) {
    levels.push_back(&all[i].engine);
    differences.push_back(&all[i].apart);
    sheet.data(data_block(fmt::format("engine_{}", i), all[i].engine));
    sheet.data(data_block(fmt::format("apart_{}", i), all[i].apart));
  }
  const std::string across = fmt::format("set xrange [0:{}]\n", plain(end));
  constexpr double tall = 380, low = 260, gap = 20;
  sheet.panel(tall, 0,
              across + range_of(levels) + grid + without_horizontal_labels() +
                  "set format y '%.4g'\nset ylabel 'energy above rest (J)' offset 0\n",
              level_plots(all, styles));
  sheet.panel(low, gap,
              across + range_of(differences) + grid +
                  "set format y '%.5g'\nset format x '%g'\nset xlabel 'time (s)'\n"
                  "set ylabel 'engine with contacts − exact (J)' offset 0\n",
              apart_plots(all, styles));
  return sheet.finish();
}

}  // namespace rockstack::plots
