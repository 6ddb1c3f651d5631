#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "plots/data/run_files.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/series.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// Angular velocities of a block over its angles. A Curve's `times` are angles here, rad; its values rad/s.
/// At most 20,000 samples are looked at, of which those that bear the shape within a tolerance are kept.
Curve read_orbit(const Run& run, int block, double tolerance) {
  const auto history = history_of(run);
  const std::vector<double> angles = column_of(*history, &History::angles, block),
                            velocities = column_of(*history, &History::velocities, block);
  constexpr std::size_t most = 20'000;
  const std::size_t stride = std::max<std::size_t>(1, angles.size() / most);
  Curve curve;
  for (std::size_t i = 0; i < angles.size(); i += stride) {
    curve.times.push_back(angles[i]);
    curve.values.push_back(velocities[i]);
  }
  return simplified(curve, tolerance);
}

/// Edges with room, of the exact orbits where there are some, of either kind of equations: an engine's block
/// that falls must not shrink the rest.
Extent range(const std::vector<Run>& runs, const std::vector<Curve>& orbits,
             std::vector<double> Curve::*along) {
  Extent extent;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs.front().exact() && !runs[i].exact() && !has_other_equations(runs[i])) continue;
    for (const double value : orbits[i].*along)
      extent = {std::min(extent.low, value), std::max(extent.high, value)};
  }
  const double margin = std::max(0.12 * (extent.high - extent.low), 1e-6);
  return {extent.low - margin, extent.high + margin};
}

void add_block(Sheet& sheet, const std::vector<Run>& runs, int block, int blocks,
               const std::vector<Curve>& orbits) {
  std::vector<Series> series;
  std::vector<std::string> core;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::string name = fmt::format("orbit_{}_{}", i, block + 1);
    sheet.data(data_block(name, orbits[i]));
    if (orbits[i].size() == 0) continue;
    series.push_back(curve_series(runs[i], name, i));
    if (runs[i].exact()) core = {exact_core(name)};
  }
  const Extent across = range(runs, orbits, &Curve::times), up = range(runs, orbits, &Curve::values);
  const auto axes = [&](double width, double height) {
    return linear_range("x", across.low, across.high, width) + linear_range("y", up.low, up.high, height) +
           grid_lines;
  };
  constexpr double space = 78;
  const std::string angle = angle_name(block + 1), rate = fmt::format("d{}/dt (rad/s)", angle);
  add_series(sheet, {angle + " (rad)", rate, rate, true, axes, panel_height(blocks), space, {}, core}, series,
             are_many(runs));
}

/// The largest angle of any block, the exact motion's where there is one.
std::string answer(const std::vector<Run>& runs) {
  double largest = 0;
  for (const double angle : history_of(runs.front())->angles) largest = std::max(largest, std::abs(angle));
  return fmt::format("{} goes as far as {:.3g} rad",
                     runs.front().exact() ? "The exact motion" : run_phrase(runs.front()), largest);
}

}  // namespace

Drawing phase(const SceneSubject& subject) {
  const Comparison& comparison = subject.comparison;
  const ComparedScene& scene = subject.scene;
  const Shown shown = shown_runs(comparison, scene.name);
  std::vector<Run> runs = shown.exact;
  runs.insert(runs.end(), shown.engines.begin(), shown.engines.end());
  if (runs.empty()) return subject.nothing("No run of this scene was done.");
  const auto curves = static_cast<double>(shown.engines.size() + 1) * scene.blocks();
  constexpr double finest = 3e-4,
                   few = 8;  // curves, more of which must be coarser for the file to stay small
  const double tolerance = finest * std::max(1.0, curves / few);
  Sheet sheet = subject.sheet(legend_of(runs, curve_style), answer(runs));
  for (int k = 0; k < scene.blocks(); ++k) {
    std::vector<Curve> orbits;
    orbits.reserve(runs.size());
    for (const Run& run : runs) orbits.push_back(read_orbit(run, k, tolerance));
    add_block(sheet, runs, k, scene.blocks(), orbits);
  }
  return sheet.finish();
}

}  // namespace rockstack::plots
