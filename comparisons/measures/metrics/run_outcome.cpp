#include "comparisons/measures/metrics/run_outcome.hpp"

#include <array>

#include "analytic/scene/lists.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/metrics/ground.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/measures/metrics/leans.hpp"
#include "comparisons/measures/metrics/toppling.hpp"

namespace rockstack {
namespace {

// What interfaces do, as bits: joined ones are the modes in which some do the one and some the other.
constexpr unsigned some_slip = 1, some_open = 2, some_part = 4;

unsigned freedom(const Pattern& pattern) {
  unsigned bits = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(pattern.size); ++k) {
    if (pattern.slides[k] != 0) bits |= some_slip;
    if (pattern.contacts[k] == Contact::left || pattern.contacts[k] == Contact::right) bits |= some_open;
    if (pattern.contacts[k] == Contact::apart) bits |= some_part;
  }
  return bits;
}

/// Freedom of a scene's first state: blocks that lean or turn otherwise than those below, slip, or fall.
unsigned freedom(const InitialState& initial) {
  const auto differs = [](const std::vector<double>& values) {
    double below = 0;
    return std::ranges::any_of(values, [&](double value) { return value != std::exchange(below, value); });
  };
  return (largest_magnitude(initial.slip_velocities) > 0 ? some_slip : 0) |
         (differs(initial.angles) || differs(initial.velocities) ? some_open : 0) |
         (largest_magnitude(initial.gaps) > 0 ? some_part : 0);
}

/// Since when every interface has been closed and without slip; nothing where one is not in the end.
std::optional<double> rest_time(const Scene& scene, const History& history) {
  if (history.events.empty()) return freedom(scene.initial) == 0 ? std::optional(0.0) : std::nullopt;
  const Event& last = history.events.back();
  if (ends_motion(last.kind) || freedom(last.to) != 0) return std::nullopt;
  return last.time;
}

/// Where blocks are apart, whatever others do.
MotionMode mode_of(unsigned freedom) {
  return static_cast<MotionMode>(std::min(freedom, some_part));
}

}  // namespace

SolveOptions run_options(double tolerance) {
  return {.end = true,
          .events = EventsKept::summed,
          .validity = true,
          .peaks = true,
          .resolution = tolerance,
          .tolerance = tolerance};
}

RunOutcome run_outcome(const Scene& scene, const History& history) {
  RunOutcome outcome;
  outcome.peaks = peak_angles(history);
  for (std::size_t k = 0; k < scene.blocks.size(); ++k)
    outcome.peak_ratios.push_back(outcome.peaks[k] / slenderness(scene, static_cast<int>(k)));
  outcome.peak_ratio = largest_magnitude(outcome.peak_ratios);
  for (const Event& event : history.events) {
    outcome.events += event.count;
    if (is_impact(event.kind)) outcome.impacts += event.count;
  }
  if (!history.events.empty()) outcome.last_event_time = history.events.back().time;
  outcome.rest_time = rest_time(scene, history);
  if (const auto toppling = toppling_of(scene, history)) {
    outcome.toppled = toppling->block;
    outcome.topple_time = toppling->time;
  } else {
    outcome.ground_left = ground_left(scene);
  }
  if (!history.times.empty())
    if (const auto falling = falling_block(scene, history, history.size() - 1))
      outcome.falling = static_cast<int>(falling->block) + 1;
  outcome.onset = onset_mode(scene, history);
  outcome.motion = whole_mode(scene, history);
  outcome.force = worst_of(history.forces);
  outcome.impulse = worst_of(history.impulses);
  outcome.frictions = mapped(history.forces, &Demand::friction);
  outcome.slips = history.slips_left;
  outcome.lifts = history.lifts;
  outcome.uplifts = uplifts_of(scene, history);
  outcome.uplift = largest_magnitude(outcome.uplifts);
  outcome.largest_slips = history.largest_slips;
  if (!history.slips_left.empty()) outcome.slip = largest_magnitude(history.slips_left);
  if (!history.lifts.empty()) outcome.lift = largest_magnitude(history.lifts);
  if (!history.largest_slips.empty()) outcome.largest_slip = largest_magnitude(history.largest_slips);
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
  unsigned ever = freedom(scene.initial);
  for (const Event& event : history.events) ever |= freedom(event.to);
  return mode_of(ever);
}

}  // namespace rockstack
