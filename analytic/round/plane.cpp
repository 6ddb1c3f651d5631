#include "analytic/round/plane.hpp"

#include "analytic/solve.hpp"

namespace rockstack {
namespace {

/// The two amplitudes of one motion along x and y; none where these are two motions.
std::optional<std::pair<double, double>> common_motion(const GroundMotion& x, const GroundMotion& y) {
  if (x.pulse && y.pulse) {
    const auto shape = [](const Pulse& pulse) {
      return std::tuple(pulse.shape, pulse.period, pulse.start, pulse.cycles, pulse.phase);
    };
    if (shape(*x.pulse) != shape(*y.pulse)) return std::nullopt;
    return std::pair(x.pulse->amplitude, y.pulse->amplitude);
  }
  if (x.samples.empty() || x.interval != y.interval || x.samples.size() != y.samples.size())
    return std::nullopt;
  constexpr double rounding = 1e-14;
  const double along = peak(x), across = peak(y);
  const auto size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto at = std::ranges::max_element(x.samples, size) - x.samples.begin();
  const double ratio = y.samples[static_cast<std::size_t>(at)] / x.samples[static_cast<std::size_t>(at)];
  for (std::size_t i = 0; i < x.samples.size(); ++i)
    if (!(std::abs(y.samples[i] - ratio * x.samples[i]) <= rounding * std::max(along, across)))
      return std::nullopt;
  return std::pair(1.0, ratio);
}

GroundMotion scaled(GroundMotion motion, double factor) {
  for (double& sample : motion.samples) sample *= factor;
  if (motion.pulse) motion.pulse->amplitude *= factor;
  return motion;
}

RoundState state_of(const RoundScene& scene, double direction, double time, double angle, double velocity) {
  const bool leans_back = angle < 0 || (angle == 0 && velocity < 0);
  RoundState state{.time = time};
  state.rolling = {std::abs(angle), leans_back ? -velocity : velocity, 0, 0,
                   direction + (leans_back ? pi<double> : 0)};
  state.support = support(scene.body(), state.rolling, felt_at(scene, time));
  state.energy = energy(scene.body(), state.rolling);
  return state;
}

}  // namespace

std::optional<double> plane_of(const RoundScene& scene) {
  if (scene.room == RoundRoom::plane) return 0;
  if (scene.precession != 0 || scene.spin != 0 || scene.steady) return std::nullopt;
  if (scene.y.empty()) return 0;
  if (scene.tilt != 0) return std::nullopt;
  if (scene.x.empty()) return pi<double> / 2;
  const auto both = common_motion(scene.x, scene.y);
  if (!both) return std::nullopt;
  return std::atan(both->second / both->first);
}

Scene planar_scene(const RoundScene& scene, double direction) {
  const Cylinder body = scene.body();
  Scene planar;
  planar.title = scene.title;
  planar.duration = scene.duration;
  planar.gravity = scene.gravity;
  planar.blocks = {{body.radius, body.half_height, 1, body.A}};
  planar.initial = {{scene.tilt}, {scene.tilt_rate}};
  const double cosine = std::cos(direction);
  planar.horizontal = scene.x.empty() ? scene.y : scaled(scene.x, 1 / cosine);
  if (direction == 0) planar.horizontal = scene.x;
  planar.vertical = scene.z;
  return planar;
}

RoundMotion solve_in_plane(const RoundScene& scene, double direction, const std::vector<double>& times) {
  SolveOptions options;
  options.sample_times = times;
  options.validity = options.peaks = true;
  const History history = solve(planar_scene(scene, direction), options);
  RoundMotion motion;
  motion.largest_tilt = history.peaks[0];
  motion.demand = {history.forces[0].least_normal / scene.gravity, history.forces[0].friction};
  for (std::size_t i = 0; i < history.size(); ++i)
    motion.samples.push_back(
        state_of(scene, direction, history.times[i], history.angles[i], history.velocities[i]));
  for (const Event& event : history.events) {
    const RoundEvent kind = event.kind == EventKind::opening  ? RoundEvent::lift
                            : event.kind == EventKind::impact ? RoundEvent::impact
                            : event.kind == EventKind::topple ? RoundEvent::topple
                                                              : RoundEvent::rest;
    motion.events.emplace_back(kind, state_of(scene, direction, event.time, event.angles[0], event.after[0]));
    if (kind == RoundEvent::topple) motion.toppled = event.time;
  }
  return motion;
}

}  // namespace rockstack
