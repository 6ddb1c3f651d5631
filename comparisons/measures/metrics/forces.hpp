#pragma once

#include <optional>

#include "analytic/scene/scene.hpp"
#include "comparisons/measures/metrics/alignment.hpp"

namespace rockstack {

/// What interfaces bear in an engine beside the exact motion, in N as shares of the weight above each.
struct ForceDifference {
  // Root mean squares over steps and interfaces.
  std::optional<double> normal = {}, tangential = {};
  std::optional<double> peak = {}, exact_peak = {};  ///< largest normal forces
};

/// Impulses at the interface of an impact that both motions have.
struct ImpactImpulse {
  int number = 0;                          ///< of the exact impact, from 1
  int interface = 0;                       ///< from 1
  double exact_time = 0, engine_time = 0;  ///< s
  Reaction exact = {}, engine = {};        ///< N·s; without centres
};

struct ForceComparison {
  ForceDifference forces;
  std::vector<ImpactImpulse> impulses;  ///< in order of time
};

/// Sets an engine's reactions, means of steps, beside the exact ones: the mean of those at both ends of a
/// step. Forces are of the steps further than settling_duration() from every impact, the exact ones at any
/// speed and those of `alignment`. An impact's impulse is what its interface bears for so long before and
/// after it, and not beyond half way to another one of `alignment`: in the exact motion from all impacts, in
/// the engine above the exact forces, moved by the difference of both times.
/// Preconditions: `exact` is a solver's, at the engine's times; all are up to the time that is compared.
ForceComparison compare_forces(const Scene& scene, const History& exact, const History& engine,
                               const std::vector<AlignedImpact>& alignment);

/// Root of the mean square difference of normal impulses over that of the exact ones; nothing without any.
std::optional<double> impulse_error(const std::vector<ImpactImpulse>& impulses);

}  // namespace rockstack
