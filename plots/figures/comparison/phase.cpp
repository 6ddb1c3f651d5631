#include <fmt/core.h>

#include <algorithm>

#include "comparisons/measures/results/csv.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

/// Angle against angular velocity of each block. A Curve's `times` are angles here, rad; its values rad/s.
struct Orbit {
  Run run;
  std::vector<Curve> blocks;
};

/// At most 20,000 samples are looked at, of which those that bear the shape within a tolerance are kept.
Orbit read_orbit(const Run& run, int blocks, double tolerance) {
  std::vector<std::string> names = numbered("theta_", blocks);
  for (const std::string& name : numbered("omega_", blocks)) names.push_back(name);
  const auto columns = read_columns(run.folder / "history.csv", names);
  constexpr std::size_t most = 20'000;
  const std::size_t stride = std::max<std::size_t>(1, columns[0].size() / most);
  Orbit orbit{run, {}};
  for (std::size_t k = 0; k < static_cast<std::size_t>(blocks); ++k) {
    Curve curve;
    for (std::size_t i = 0; i < columns[0].size(); i += stride) {
      curve.times.push_back(columns[k][i]);
      curve.values.push_back(columns[static_cast<std::size_t>(blocks) + k][i]);
    }
    orbit.blocks.push_back(simplified(curve, tolerance));
  }
  return orbit;
}

/// Edges with room, of the exact orbits where there are some, of either kind of equations: an engine's block
/// that falls must not shrink the rest.
std::string range(const std::vector<Orbit>& orbits, std::size_t block, bool across, double pixels) {
  double low = 0, high = 0;
  for (const Orbit& orbit : orbits) {
    if (orbits.front().run.exact() && !orbit.run.exact() && !has_other_equations(orbit.run)) continue;
    for (const double value : across ? orbit.blocks[block].times : orbit.blocks[block].values)
      low = std::min(low, value), high = std::max(high, value);
  }
  const double margin = std::max(0.12 * (high - low), 1e-6);
  low -= margin, high += margin;
  return fmt::format("set {}range [{}:{}]\n", across ? "x" : "y", plain(low), plain(high)) +
         linear_tics(across ? "x" : "y", low, high, pixels);
}

std::string name_of(std::size_t run, std::size_t block) {
  return fmt::format("orbit_{}_{}", run, block + 1);
}

bool has_exact(const std::vector<Orbit>& orbits, std::size_t block) {
  return orbits.front().run.exact() && !orbits.front().blocks[block].times.empty();
}

std::vector<std::string> panel_plots(const std::vector<Orbit>& orbits, std::size_t block) {
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < orbits.size(); ++i)
    if (!orbits[i].blocks[block].times.empty())
      plots.push_back(
          fmt::format("${} using 1:2 {} notitle", name_of(i, block), curve_style(orbits[i].run, i)));
  if (has_exact(orbits, block))
    plots.push_back(fmt::format("${} using 1:2 with lines lw 1 lc rgb '#000000' notitle", name_of(0, block)));
  return plots;
}

/// A panel a run, over the exact orbit.
void add_small_panels(Sheet& sheet, const std::vector<Orbit>& orbits, std::size_t block,
                      const std::string& settings, const std::string& angle) {
  std::vector<std::string> context;
  if (has_exact(orbits, block))
    context.push_back(
        fmt::format("${} using 1:2 with lines lw 3 lc rgb '#BDBDBD' notitle", name_of(0, block)));
  std::vector<Multiple> series;
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    if (orbits[i].run.exact()) continue;
    const std::string colour = style_of(orbits[i].run).colour;
    series.push_back(
        {line_label(orbits[i].run),
         colour,
         {fmt::format("${} using 1:2 with lines lw 1.5 lc rgb '{}' notitle", name_of(i, block), colour)}});
  }
  add_multiples(sheet, series, context, settings, angle + " (rad)", fmt::format("d{}/dt (rad/s)", angle));
}

Legend legend_of(const std::vector<Orbit>& orbits) {
  Legend legend;
  for (std::size_t i = 0; i < orbits.size(); ++i)
    if (orbits.size() <= most_series + 1 || orbits[i].run.exact())
      legend.emplace_back(curve_style(orbits[i].run, i), run_label(orbits[i].run));
  return legend;
}

/// The largest angle of any block, the exact motion's where there is one.
std::string question(const std::vector<Orbit>& orbits) {
  double largest = 0;
  for (const Curve& curve : orbits.front().blocks)
    for (const double angle : curve.times) largest = std::max(largest, std::abs(angle));
  return fmt::format("Which path does each block take? {} goes as far as {:.3g} rad",
                     orbits.front().run.exact() ? "The exact motion" : run_phrase(orbits.front().run),
                     largest);
}

}  // namespace

Drawing phase(const Comparison& comparison, const ComparedScene& scene) {
  const Shown shown = shown_runs(comparison, scene.name);
  std::vector<Orbit> orbits;
  const auto curves = static_cast<double>(shown.engines.size() + 1) * scene.blocks;
  constexpr double finest = 3e-4,
                   few = 8;  // curves, more of which must be coarser for the file to stay small
  const double tolerance = finest * std::max(1.0, curves / few);
  for (const std::vector<Run>& runs : {shown.exact, shown.engines})
    for (const Run& run : runs) orbits.push_back(read_orbit(run, scene.blocks, tolerance));
  if (orbits.empty()) return empty_sheet(heading(scene), "No run of this scene was done.");
  Sheet sheet(heading(scene), legend_of(orbits), question(orbits));
  constexpr double gap = 78;
  const bool many = orbits.size() > most_series + 1;
  constexpr double whole_width = 1056;
  const double height = many ? multiple_height : panel_height(scene.blocks);
  const double width = many ? multiple_width : whole_width;
  for (std::size_t k = 0; k < static_cast<std::size_t>(scene.blocks); ++k) {
    for (std::size_t i = 0; i < orbits.size(); ++i)
      sheet.data(data_block(name_of(i, k), orbits[i].blocks[k]));
    const std::string angle = angle_name(static_cast<int>(k) + 1);
    const std::string settings = range(orbits, k, true, width) + range(orbits, k, false, height) + grid_lines;
    if (many)
      add_small_panels(sheet, orbits, k, settings, angle);
    else
      sheet.panel(
          panel_height(scene.blocks), gap,
          settings +
              fmt::format("set xlabel '{0} (rad)' offset 0,0.4\nset ylabel 'd{0}/dt (rad/s)'\n", angle),
          panel_plots(orbits, k));
  }
  return sheet.finish();
}

}  // namespace rockstack::plots
