#include "tests/analytic/reference/agreement.hpp"

#include <algorithm>
#include <cfenv>
#include <cmath>

#include "analytic/solve.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack::testing {
namespace {

template <class Real, class Other>
bool same(const BasicEvent<Real>& a, const BasicEvent<Other>& b) {
  return a.kind == b.kind && a.interface == b.interface && a.from == b.from && a.to == b.to &&
         a.consistency == b.consistency;
}

/// The size that each of a list of values has had so far.
class Sizes {
 public:
  void note(const std::vector<Quad>& values) {
    for (const Quad& value : values) largest_ = std::max<Quad>(largest_, abs(value));
  }

  template <class Real>
  double share(const std::vector<Real>& values, const std::vector<Quad>& others) const {
    Quad worst = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
      worst = std::max<Quad>(worst, abs(Quad(values[k]) - others[k]));
    return largest_ > 0 ? static_cast<double>(worst / largest_) : 0.0;
  }

 private:
  Quad largest_ = 0;
};

double shifted(double value, double units) {
  return value * (1 + units * std::numeric_limits<double>::epsilon());
}

void shift(std::vector<double>& samples, Draw& draw, int units) {
  for (double& sample : samples) sample = shifted(sample, draw.between(-units, units));
}

void shift(GroundMotion& motion, Draw& draw, int units) {
  shift(motion.samples, draw, units);
  if (!motion.pulse) return;
  Pulse& pulse = *motion.pulse;
  for (double* value : {&pulse.amplitude, &pulse.period, &pulse.start, &pulse.phase})
    *value = shifted(*value, draw.between(-units, units));
}

/// A scene with all that motion depends on changed at random by up to some units in the last place.
/// Interfaces that are closed stay so.
Scene rounded_anywhere(Scene scene, Draw& draw, int units) {
  const auto change = [&](double& value) { value = shifted(value, draw.between(-units, units)); };
  change(scene.gravity);
  for (Block& block : scene.blocks) {
    for (double* value : {&block.half_width, &block.half_height, &block.mass, &block.inertia}) change(*value);
  }
  const InitialState given = scene.initial;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    for (auto list : {&InitialState::angles, &InitialState::velocities}) {
      std::vector<double>& values = scene.initial.*list;
      const bool as_below = k > 0 && (given.*list)[k] == (given.*list)[k - 1];
      if (as_below) {
        values[k] = values[k - 1];
      } else {
        change(values[k]);
      }
    }
  }
  shift(scene.horizontal, draw, units);
  shift(scene.vertical, draw, units);
  return scene;
}

/// Scenes that differ from one by that many units in the last place of gravity or of a height, and `draws` by
/// up to that many in all numbers at once.
std::vector<Scene> roundings(const Scene& scene, int units, int draws) {
  std::vector<Scene> scenes;
  for (const int shift : {-units, units}) {
    scenes.push_back(scene);
    scenes.back().gravity = shifted(scene.gravity, shift);
    for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
      scenes.push_back(scene);
      scenes.back().blocks[k].half_height = shifted(scene.blocks[k].half_height, shift);
    }
  }
  Draw draw(scene.blocks.size());
  for (int i = 0; i < draws; ++i) scenes.push_back(rounded_anywhere(scene, draw, units));
  return scenes;
}

/// How far an event's impact throws an interface open, rad, from its speed and from when it closes again; the
/// flight of a constant acceleration.
template <class Real>
Quad excursion(const BasicHistory<Real>& history, std::size_t event, int interface) {
  const auto& start = history.events[event];
  const auto k = static_cast<std::size_t>(interface);
  const Quad below = k > 0 ? Quad(start.after[k - 1]) : Quad(0);
  const Quad speed = abs(Quad(start.after[k]) - below);
  for (std::size_t i = event + 1; i < history.events.size(); ++i) {
    const auto& next = history.events[i];
    if (next.interface == interface + 1 || next.to[interface] != start.to[interface])
      return speed * (Quad(next.time) - Quad(start.time)) / 4;
  }
  return std::numeric_limits<Quad>::infinity();
}

template <class Real>
bool is_impact(const BasicEvent<Real>& event) {
  return event.kind == EventKind::impact || event.kind == EventKind::closure || event.kind == EventKind::rest;
}

void take_larger(Deviation& deviation, const Deviation& other) {
  deviation.time = std::max(deviation.time, std::abs(other.time));
  deviation.state = std::max(deviation.state, other.state);
}

/// Whether a response, of all events that there are, parts no later than another history and has those of its
/// deviations up to there that are not small.
bool makes(const Agreement& response, const Agreement& wanted) {
  const bool parts = response.parts && (!wanted.parts || *response.parts <= *wanted.parts);
  if (wanted.parts && !parts) return false;
  const std::size_t count = std::min(wanted.events.size(), parts ? *response.parts : wanted.events.size());
  constexpr double small = 1e-10;  // s, or of the state
  constexpr double nearly = 1.01;  // what takes the same other guard is off by as much
  Deviation largest;
  for (std::size_t i = 0; i < count; ++i) {
    take_larger(largest, response.events[i]);
    const Deviation& deviation = wanted.events[i];
    if (std::abs(deviation.time) > std::max(small, nearly * largest.time) ||
        deviation.state > std::max(small, nearly * largest.state))
      return false;
  }
  return true;
}

/// The last event within a few roundings of a time.
template <class Real>
const BasicEvent<Real>& last_of_instant(const BasicHistory<Real>& history, std::size_t event) {
  constexpr double roundings = 8;
  const Real time = history.events[event].time;
  const Real end = time * (1 + roundings * std::numeric_limits<double>::epsilon());
  while (event + 1 < history.events.size() && history.events[event + 1].time <= end) ++event;
  return history.events[event];
}

}  // namespace

template <class Real>
Agreement compare(const BasicHistory<Real>& history, const QuadHistory& other) {
  Agreement agreement;
  Sizes angles;
  Sizes velocities;
  const std::size_t count = std::max(history.events.size(), other.events.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (i >= history.events.size() || i >= other.events.size() || !same(history.events[i], other.events[i])) {
      agreement.parts = i;
      break;
    }
    const auto& event = history.events[i];
    const auto& expected = other.events[i];
    angles.note(expected.angles);
    velocities.note(expected.before);
    agreement.events.push_back({static_cast<double>(Quad(event.time) - expected.time),
                                std::max({angles.share(event.angles, expected.angles),
                                          velocities.share(event.before, expected.before),
                                          velocities.share(event.after, expected.after)})});
  }
  return agreement;
}

template Agreement compare(const BasicHistory<double>&, const QuadHistory&);
template Agreement compare(const BasicHistory<Quad>&, const QuadHistory&);

Agreement response_to_rounding(const Scene& scene, const QuadHistory& history, int units, int draws,
                               const std::optional<Agreement>& wanted) {
  Agreement response;
  response.events.resize(history.events.size());
  for (const Scene& rounded : roundings(scene, units, draws)) {
    const Agreement agreement = compare(reference(rounded), history);
    if (agreement.parts)
      response.parts = std::min(*agreement.parts, response.parts.value_or(*agreement.parts));
    for (std::size_t i = 0; i < agreement.events.size(); ++i)
      take_larger(response.events[i], agreement.events[i]);
    if (wanted && makes(response, *wanted)) break;
  }
  response.events.resize(response.parts.value_or(response.events.size()));
  for (std::size_t i = 1; i < response.events.size(); ++i)
    take_larger(response.events[i], response.events[i - 1]);
  return response;
}

bool parts_at_resolution(const History& history, const QuadHistory& other, std::size_t event) {
  if (event >= history.events.size() || event >= other.events.size()) return false;
  const auto& found = history.events[event];
  const auto& expected = other.events[event];
  if (!is_impact(found) || !is_impact(expected) || found.interface != expected.interface ||
      !(found.from == expected.from) || found.consistency != expected.consistency)
    return false;
  const Quad resolution = std::numeric_limits<double>::epsilon();
  for (int k = 0; k < found.to.size; ++k) {
    if (found.to[k] == expected.to[k]) continue;
    const bool flies = expected.to[k] == Contact::closed;
    if (!flies && found.to[k] != Contact::closed) return false;
    if ((flies ? excursion(history, event, k) : excursion(other, event, k)) > 2 * resolution) return false;
  }
  return true;
}

bool parts_within_an_instant(const History& history, const QuadHistory& other, std::size_t event) {
  if (event >= history.events.size() || event >= other.events.size()) return false;
  const Event& found = last_of_instant(history, event);
  const BasicEvent<Quad>& expected = last_of_instant(other, event);
  if (!(found.to == expected.to)) return false;
  Sizes velocities;
  velocities.note(expected.before);
  velocities.note(expected.after);
  constexpr double small = 1e-9;
  return velocities.share(found.after, expected.after) < small;
}

bool parts_at_decision(const Scene& scene, const History& history, std::size_t event) {
  if (!leaves_pivots(scene.law)) return false;
  constexpr double look_ahead_of_double = 1e-7;
  const Agreement agreement = compare(history, reference(scene, {}, look_ahead_of_double));
  return !agreement.parts || *agreement.parts > event;
}

bool parts_from_itself(const Scene& scene, const History& history, std::size_t event, int units, int draws) {
  const std::vector<Scene> scenes = roundings(scene, units, draws);
  const int nearest = std::fegetround();
  bool parts = false;
  for (const int direction : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, nearest}) {
    std::fesetround(direction);
    for (const Scene& rounded : scenes) {
      const History other = solve(rounded);
      const std::size_t count = std::min(history.events.size(), other.events.size());
      std::size_t same_events = 0;
      while (same_events < count && same(history.events[same_events], other.events[same_events]))
        ++same_events;
      parts = parts ||
              (same_events <= event && same_events < std::max(history.events.size(), other.events.size()));
      if (parts) break;
    }
  }
  std::fesetround(nearest);
  return parts;
}

}  // namespace rockstack::testing
