#include "comparisons/studies/sweep/run_outcome.hpp"

#include <algorithm>
#include <cmath>

namespace rockstack {
namespace {

/// The worst of all interfaces.
Demand worst(const std::vector<Demand>& demands) {
  Demand result;
  for (const Demand& demand : demands) {
    result.least_normal = std::min(result.least_normal, demand.least_normal);
    result.friction = std::max(result.friction, demand.friction);
  }
  return result;
}

/// Nothing where there are none.
std::optional<double> largest(const std::vector<double>& sizes) {
  if (sizes.empty()) return std::nullopt;
  double most = 0;
  for (const double size : sizes) most = std::max(most, std::abs(size));
  return most;
}

bool is_impact(const Event& event) {
  return event.kind == EventKind::impact || event.kind == EventKind::closure || event.kind == EventKind::rest;
}

}  // namespace

SolveOptions run_options(double tolerance) {
  return {.events = EventsKept::summed,
          .validity = true,
          .peaks = true,
          .resolution = tolerance,
          .tolerance = tolerance};
}

RunOutcome run_outcome(const Scene& scene, const History& history) {
  RunOutcome outcome;
  outcome.peaks = history.peaks;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    outcome.peak_ratio =
        std::max(outcome.peak_ratio, outcome.peaks[k] / slenderness(scene, static_cast<int>(k)));
  }
  for (const Event& event : history.events) {
    outcome.events += event.count;
    if (is_impact(event)) outcome.impacts += event.count;
  }
  if (!history.events.empty()) {
    const Event& last = history.events.back();
    outcome.last_event_time = last.time;
    if (ends_motion(last.kind)) {
      outcome.toppled = last.interface;
      outcome.topple_time = last.time;
    }
  }
  outcome.onset = onset_mode(scene, history);
  outcome.motion = whole_mode(scene, history);
  outcome.force = worst(history.forces);
  outcome.impulse = worst(history.impulses);
  outcome.slip = largest(history.slips_left);
  outcome.lift = largest(history.lifts);
  return outcome;
}

}  // namespace rockstack
