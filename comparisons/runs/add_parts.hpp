#pragma once

#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/runs/other_answer.hpp"
#include "comparisons/runs/run_files.hpp"

namespace rockstack {

/// The most steps that a compliant motion beside an engine's run takes, about.
inline constexpr double most_spring_steps = 1e5;

/// The scene's exact motion on springs.
struct SoftMotion {
  History history;    ///< of an extrapolation angles alone
  double factor = 1;  ///< by which springs are softer than asked for, spring_factor()
};

/// Where that motion would take more steps, angles are extrapolated from springs softer by that factor and by
/// twice as much, as if in proportion to it. What that leaves is a tenth to a fifth of what softer springs
/// are off, measured in one scene (comparisons/README.md).
/// @throws as solve().
SoftMotion soft_motion(const Scene& scene, const std::vector<double>& friction, CornerSpring spring,
                       const std::vector<double>& times, double most_steps = most_spring_steps);

/// Splits the difference of an engine's answer from the exact motion, at the answer's times, into contact
/// model, softness and step: solves the scene on rigid contacts and on springs as well. Fills in the columns
/// of the split, up to `horizon` s, and, where `histories`, parts.csv. Where a motion cannot be solved the
/// row says why.
void add_parts(const Scene& scene, const History& exact, const OtherAnswer& answer, double horizon,
               bool histories, RunMetrics& row, RunFiles& files);

}  // namespace rockstack
