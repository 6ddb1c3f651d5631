#include <fmt/core.h>

#include <algorithm>

#include "comparisons/results/csv.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

/// Angle against angular velocity of each block. A Curve's `times` are angles here, rad; its values rad/s.
struct Orbit {
  Run run;
  std::vector<Curve> blocks;
};

/// At most 20,000 samples are looked at, of which those that bear the shape are kept.
Orbit read_orbit(const Run& run, int blocks) {
  std::vector<std::string> names = numbered("theta_", blocks);
  for (const std::string& name : numbered("omega_", blocks)) names.push_back(name);
  const auto columns = read_columns(run.folder / "history.csv", names);
  constexpr std::size_t most = 20'000;
  constexpr double tolerance = 2e-3;
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

/// Edges with room, of the exact orbit where there is one: an engine's block that falls must not shrink the
/// rest.
std::string range(const std::vector<Orbit>& orbits, std::size_t block, bool across) {
  double low = 0, high = 0;
  for (const Orbit& orbit : orbits) {
    if (orbits.front().run.exact() && !orbit.run.exact()) continue;
    for (const double value : across ? orbit.blocks[block].times : orbit.blocks[block].values)
      low = std::min(low, value), high = std::max(high, value);
  }
  const double margin = std::max(0.12 * (high - low), 1e-6);
  return fmt::format("set {}range [{}:{}]\n", across ? "x" : "y", plain(low - margin), plain(high + margin));
}

std::string name_of(std::size_t run, std::size_t block) {
  return fmt::format("orbit_{}_{}", run, block + 1);
}

std::vector<std::string> panel_plots(const std::vector<Orbit>& orbits, const Styles& styles,
                                     std::size_t block) {
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < orbits.size(); ++i)
    if (!orbits[i].blocks[block].times.empty())
      plots.push_back(
          fmt::format("${} using 1:2 {} notitle", name_of(i, block), curve_style(styles, orbits[i].run, i)));
  if (orbits.front().run.exact() && !orbits.front().blocks[block].times.empty())
    plots.push_back(fmt::format("${} using 1:2 with lines lw 1 lc rgb '#000000' notitle", name_of(0, block)));
  return plots;
}

}  // namespace

Drawing phase(const Comparison& comparison, const ComparedScene& scene, const Styles& styles) {
  const Shown shown = shown_runs(comparison, scene.name);
  std::vector<Run> runs = shown.exact;
  runs.insert(runs.end(), shown.engines.begin(), shown.engines.end());
  if (runs.empty()) return empty_sheet(heading(scene), "No run of this scene was done.");
  const auto blocks = static_cast<std::size_t>(scene.blocks);
  std::vector<Orbit> orbits;
  Legend legend;
  for (const Run& run : runs) {
    legend.emplace_back(curve_style(styles, run, orbits.size()), run_label(run));
    orbits.push_back(read_orbit(run, scene.blocks));
  }
  Sheet sheet(heading(scene), legend);
  constexpr double gap = 78;
  for (std::size_t k = 0; k < blocks; ++k) {
    for (std::size_t i = 0; i < orbits.size(); ++i)
      sheet.data(data_block(name_of(i, k), orbits[i].blocks[k]));
    const std::string angle = angle_name(static_cast<int>(k) + 1);
    sheet.panel(
        panel_height(scene.blocks), gap,
        range(orbits, k, true) + range(orbits, k, false) +
            "set grid lt 1 dt solid lw 1 lc rgb '#E4E4E4'\nset format x '%g'\n" +
            fmt::format("set xlabel '{0} (rad)' offset 0,0.4\nset ylabel 'rate of {0} (rad/s)' offset 0\n",
                        angle),
        panel_plots(orbits, styles, k));
  }
  return sheet.finish();
}

}  // namespace rockstack::plots
