#pragma once

#include <exception>
#include <functional>
#include <vector>

namespace rockstack {

/// What makes the steps between events.
enum class Integrator {
  taylor,  ///< Taylor series to rounding
  rk4,     ///< the classical Runge–Kutta method at a fixed step: the baseline
};

/// What a history tells of its events.
enum class EventsKept {
  all,  ///< every one, with the state on both sides
  /// No states, and of impacts in a row that throw one interface to and fro their number. Chatter of
  /// one interface alone ends in the closure that stands for all its impacts to come as soon as these neither
  /// move the motion by more than the resolution, nor hold anything else that is asked for. Of resolutions
  /// below 1e-10, and not of small-angle equations.
  summed,
};

/// What ends a motion that nobody wants any more.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped: not wanted any more"; }
};

/// How to solve, and what to keep.
struct SolveOptions {
  Integrator integrator = Integrator::taylor;
  /// When to sample the motion, s, ascending from ≥ 0; none: events alone.
  std::vector<double> sample_times = {};
  /// Whether to keep, behind all others, a sample of the end of the scene, where the motion comes to it.
  bool end = false;
  EventsKept events = EventsKept::all;
  /// Whether to keep the demands on each interface, along whole steps; of rk4 at their starts.
  bool validity = false;
  /// Whether to keep the largest angle of each block, and under laws that leave pivots its slip and its lift.
  bool peaks = false;
  /// Chatter ends where a flight would stay below it, rad, ≥ 0; 0: the rounding of 1.
  double resolution = 0;
  /// Look-ahead of laws that leave pivots: modes are chosen from the state this long after an event, √(H/g),
  /// ≥ 0; 0: 6.7 √ε.
  double look_ahead = 0;
  /// Tolerance of taylor: the share of the velocity that a step may leave out, ≥ 0; 0: rounding.
  double tolerance = 0;
  /// Longest step of rk4, s, > 0.
  double step = 2e-4;
  /// Asked before every step: true ends the motion, which throws Stopped; null: none.
  const std::function<bool()>* cancelled = nullptr;
};

/// @throws Stopped where it is so.
inline void stop_if_cancelled(const std::function<bool()>* cancelled) {
  if (cancelled != nullptr && (*cancelled)()) throw Stopped();
}

/// @throws std::invalid_argument with name, value and range; times must be finite, ≥ 0 and ascending.
void validate(const SolveOptions& options);

}  // namespace rockstack
