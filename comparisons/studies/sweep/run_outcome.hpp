#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"
#include "analytic/scene/solve_options.hpp"
#include "comparisons/studies/sweep/motion_modes.hpp"

namespace rockstack {

/// What a sweep keeps of one run. SI units.
struct RunOutcome {
  std::vector<double> peaks;   ///< largest absolute angle of each block, rad
  double peak_ratio = 0;       ///< the largest of these over the block's slenderness
  int toppled = 0;             ///< number of the block that toppled or fell off first, from 1; 0: none
  double topple_time = 0;      ///< s, where one has
  std::size_t impacts = 0;     ///< with those that end chatter
  std::size_t events = 0;      ///< of any kind
  double last_event_time = 0;  ///< s, where there is an event
  MotionMode onset = MotionMode::rest, motion = MotionMode::rest;  ///< how it begins; all of it
  Demand force;    ///< on whichever interface bears the most, by forces
  Demand impulse;  ///< likewise, by impulses
  /// Under law unilateral: the largest slip that is left at the end, and the highest lift, of any interface,
  /// m.
  std::optional<double> slip, lift;
};

/// How the runs of a sweep are solved: exactly, or to a tolerance that also ends chatter.
SolveOptions run_options(double tolerance = 0);

/// Sums up the history of a scene that was solved with run_options().
RunOutcome run_outcome(const Scene& scene, const History& history);

}  // namespace rockstack
