#include "plots/data/run_files.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// Angular velocities of a block over its angles. A Curve's `times` are angles here, rad; its values rad/s.
/// Up to an end, s. At most 20,000 samples are looked at, of which those that bear the shape within a
/// tolerance are kept.
Curve read_orbit(const Run& run, int block, double end, double tolerance) {
  const auto history = history_of(run);
  const std::vector<double> angles = column_of(*history, &History::angles, block),
                            velocities = column_of(*history, &History::velocities, block);
  constexpr std::size_t most = 20'000;
  const auto shown =
      static_cast<std::size_t>(std::ranges::upper_bound(history->times, end) - history->times.begin());
  const std::size_t stride = std::max<std::size_t>(1, shown / most);
  Curve curve;
  for (std::size_t i = 0; i < shown; i += stride) curve.add(angles[i], velocities[i]);
  return simplified(curve, tolerance);
}

/// Edges with room, of the exact orbits where there are some, of either kind of equations: an engine's block
/// that falls must not shrink the rest.
Extent reach_of(const std::vector<Run>& runs, const std::vector<Curve>& orbits,
                std::vector<double> Curve::*along) {
  Extent reach{0, 0};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs.front().exact() && !runs[i].exact() && !runs[i].has_other_equations()) continue;
    for (const double value : orbits[i].*along) reach.add(value);
  }
  return reach.wider(std::max(0.12 * (reach.high - reach.low), 1e-6));
}

void add_block(Sheet& sheet, const std::vector<Run>& runs, int block, double height,
               const std::vector<Curve>& orbits) {
  const Extent across = reach_of(runs, orbits, &Curve::times), up = reach_of(runs, orbits, &Curve::values);
  const auto axes = [&](double width, double tall) {
    return linear_range("x", across.low, across.high, width) + linear_range("y", up.low, up.high, tall) +
           grid_lines;
  };
  const std::string angle = angle_name(block + 1), rate = fmt::format("d{}/dt (rad/s)", angle);
  const std::string stem = fmt::format("orbit_{}", block + 1);
  SeriesPanel panel{angle + " (rad)", rate, rate, true, axes, height, 78};
  if (runs.front().exact() && orbits.front().size() > 0) panel.over = {exact_core(stem + "_0")};
  add_curves(sheet, panel, runs, orbits, stem);
}

}  // namespace

Drawing phase(const SceneSubject& subject) {
  const ComparedScene& scene = subject.scene;
  const RunSelection shown = subject.shown();
  const std::vector<Run> runs = all_runs(shown);
  if (runs.empty()) return subject.nothing("No run of this scene was done.");
  const auto curves = static_cast<double>(shown.engines.size() + 1) * scene.block_count();
  constexpr double finest = 3e-4, few = 8;  // more curves must be coarser for the file to stay small
  const double tolerance = finest * std::max(1.0, curves / few);
  const Run& first = runs.front();
  Sheet sheet = subject.sheet(
      legend_of(runs, curve_style),
      fmt::format("{} goes as far as {:.3g} rad", first.exact() ? "The exact motion" : run_phrase(first),
                  largest_magnitude(history_of(first)->angles)));
  const double usual = panel_height(scene.block_count()),
               height = subject.height(usual, scene.block_count() * usual);
  const double end = time_axis(scene, runs).end;
  for (int k = 0; k < scene.block_count(); ++k)
    add_block(sheet, runs, k, height,
              mapped(runs, [&](const Run& run) { return read_orbit(run, k, end, tolerance); }));
  return sheet.finish();
}

}  // namespace rockstack::plots
