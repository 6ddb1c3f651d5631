#pragma once

#include <vector>

namespace rockstack {

/// What makes the steps between events.
enum class Integrator {
  taylor,  ///< Taylor series to rounding
  rk4,     ///< the classical Runge–Kutta method at a fixed step: the baseline
};

/// How to solve, and what to keep.
struct SolveOptions {
  Integrator integrator = Integrator::taylor;
  std::vector<double> sample_times =
      {};                    ///< when to sample the motion, s, ascending from ≥ 0; none: events alone
  bool event_states = true;  ///< whether events tell the state on both sides
  bool validity =
      false;  ///< whether to keep the demands on each interface, along whole steps; of rk4 at their starts
  bool peaks = false;     ///< whether to keep the largest angle of each block
  double resolution = 0;  ///< rad, ≥ 0: chatter ends where a flight would stay below it; 0: the rounding of 1
  double tolerance = 0;  ///< of taylor: the share of the velocity that a step may leave out, ≥ 0; 0: rounding
  double step = 2e-4;    ///< of rk4: the longest step, s, > 0
};

}  // namespace rockstack
