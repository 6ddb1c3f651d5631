#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/analytic/extremes/laws.hpp"

namespace rockstack::testing {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

bool all_finite(const Bodies<>& bodies) {
  return vector_of(bodies.pose).allFinite() && vector_of(bodies.velocity).allFinite();
}

double kinetic(Scene scene, const Poses<>& rates) {
  scene.gravity = 0;
  return energy(scene, {rates, rates});
}

/// How deep a block is in the one below, in shares of the largest length in the scene. Blocks that lie on
/// each other's sides have no gap.
double depth(const Scene& scene, const Sample& sample) {
  double length = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k)
    length = std::max({length, std::abs(sample.bodies.pose[k].x), std::abs(sample.bodies.pose[k].y),
                       scene.blocks[k].half_width, scene.blocks[k].half_height});
  double least = 0;
  double below = 0;
  for (std::size_t k = 0; k < sample.gaps.size(); ++k) {
    const double angle = sample.bodies.pose[k].angle;
    if (std::abs(angle - below) < std::numbers::pi / 2) least = std::min(least, sample.gaps[k]);
    below = angle;
  }
  return -least / length;
}

std::string broken_contact(const Scene& scene, const History& history) {
  double time = 0;
  for (const Event& event : history.events) {
    if (!std::isfinite(event.time) || !all_finite(bodies_before(event)) || !all_finite(bodies_after(event)))
      return "an event holds a number that is none";
    if (event.time < time) return "an event lies before the one it follows";
    time = event.time;
  }
  if (time > scene.duration * (1 + 1e-12)) return "an event lies after the end";
  if (!ends_early(history) && history.times.back() < scene.duration * (1 - 1e-12))
    return "the motion ends before its duration";
  for (const auto& sample : samples_of(history)) {
    if (!all_finite(sample.bodies)) return "a sample is no number";
    if (depth(scene, sample) > 1e-9) return "a block sinks into the one below";
  }
  return {};
}

}  // namespace

Breaches contact_breaches(const Scene& scene, const History& history) {
  Breaches found;
  found.fault = broken_contact(scene, history);
  found.events = history.events.size();
  const bool still = scene.horizontal.empty() && scene.vertical.empty();
  double left = std::numeric_limits<double>::infinity();
  for (const Event& event : history.events) {
    const double before = kinetic(scene, bodies_before(event).velocity);
    const double total = energy(scene, bodies_before(event));
    found.impact_gain = std::max(found.impact_gain, (kinetic(scene, bodies_after(event).velocity) - before) /
                                                        (epsilon * before + 1e-300));
    if (still)
      found.flight_drift = std::max(found.flight_drift, (total - left) / (epsilon * std::abs(total)));
    left = energy(scene, bodies_after(event));
  }
  return found;
}

}  // namespace rockstack::testing
