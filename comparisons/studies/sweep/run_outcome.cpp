#include "comparisons/studies/sweep/run_outcome.hpp"

#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {
namespace {

/// What interfaces do, at a time or ever.
struct Freedom {
  bool slips = false, opens = false, parts = false;
};

/// Of a pattern, and of what was `before`.
Freedom freedom(const Pattern& pattern, const Freedom& before = {}) {
  Freedom result = before;
  for (std::size_t k = 0; k < static_cast<std::size_t>(pattern.size); ++k) {
    result.slips |= pattern.slides[k] != 0;
    result.opens |= pattern.contacts[k] == Contact::left || pattern.contacts[k] == Contact::right;
    result.parts |= pattern.contacts[k] == Contact::apart;
  }
  return result;
}

/// Of the state that a scene begins with: blocks that lean or turn otherwise than those below, slip, or fall.
Freedom freedom(const InitialState& initial) {
  const auto differs = [](const std::vector<double>& values) {
    double below = 0;
    return std::ranges::any_of(values, [&](double value) {
      const bool other = value != below;
      below = value;
      return other;
    });
  };
  return {.slips = largest_magnitude(initial.slip_velocities) > 0,
          .opens = differs(initial.angles) || differs(initial.velocities),
          .parts = largest_magnitude(initial.gaps) > 0};
}

MotionMode mode_of(const Freedom& freedom) {
  if (freedom.parts) return MotionMode::free_flight;
  if (freedom.opens) return freedom.slips ? MotionMode::slide_rock : MotionMode::rock;
  return freedom.slips ? MotionMode::slide : MotionMode::rest;
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
  for (std::size_t k = 0; k < scene.blocks.size(); ++k)
    outcome.peak_ratio =
        std::max(outcome.peak_ratio, outcome.peaks[k] / slenderness(scene, static_cast<int>(k)));
  for (const Event& event : history.events) {
    outcome.events += event.count;
    if (is_impact(event.kind)) outcome.impacts += event.count;
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
  outcome.force = worst_of(history.forces);
  outcome.impulse = worst_of(history.impulses);
  if (!history.slips_left.empty()) outcome.slip = largest_magnitude(history.slips_left);
  if (!history.lifts.empty()) outcome.lift = largest_magnitude(history.lifts);
  return outcome;
}

std::string name(MotionMode mode) {
  constexpr std::array names{"rest", "slide", "rock", "slide-rock", "free flight", "topple", "fall"};
  return names.at(static_cast<std::size_t>(mode));
}

MotionMode onset_mode(const Scene& scene, const History& history) {
  MotionMode mode = mode_of(freedom(scene.initial));
  for (auto event = history.events.begin(); mode == MotionMode::rest && event != history.events.end();
       ++event)
    mode = mode_of(freedom(event->to));
  return mode;
}

MotionMode whole_mode(const Scene& scene, const History& history) {
  if (!history.events.empty()) {
    const EventKind last = history.events.back().kind;
    if (last == EventKind::topple) return MotionMode::topple;
    if (last == EventKind::fall || last == EventKind::strike) return MotionMode::fall;
  }
  Freedom ever = freedom(scene.initial);
  for (const Event& event : history.events) ever = freedom(event.to, ever);
  return mode_of(ever);
}

}  // namespace rockstack
