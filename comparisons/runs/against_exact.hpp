#pragma once

#include <optional>
#include <vector>

#include "analytic/scene/history.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/runs/run_files.hpp"
#include "comparisons/suites/suite.hpp"
#include "engines/body_record.hpp"

namespace rockstack {

/// A motion that is compared with the exact one of a scene.
struct CandidateMotion {
  const History& history;
  double interval = 0;                ///< between its samples, s
  std::vector<ImpactTime> impacts;    ///< at the chatter speed or more
  bool topples = false;               ///< within the scene
  std::optional<BodyRecord> bodies;   ///< of an engine
  std::vector<double> friction = {};  ///< that acts in an engine, of each interface
};

/// Sets a candidate beside the exact solution at its own times: fills in the columns that the suite wants, of
/// histories up to `horizon` s (job.hpp), and adds history.csv, difference.csv, impacts.csv,
/// contact_impacts.csv, patterns.csv, energy.csv and parts.csv as far as it wants them, patterns.csv up to
/// the horizon and the others whole.
/// @throws std::runtime_error where the scene cannot be solved.
void compare_with_exact(const Scene& scene, const Suite& suite, const CandidateMotion& candidate,
                        double horizon, RunMetrics& row, RunFiles& files);

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

/// Splits the difference of an engine's motion from the exact one, at its own times, into contact model,
/// softness and step: solves the scene on rigid contacts and on springs as well. Fills in the columns of the
/// split, up to `horizon` s, and, where `histories`, parts.csv. Where a motion cannot be solved the row says
/// why.
void add_parts(const Scene& scene, const History& exact, const CandidateMotion& candidate, double horizon,
               bool histories, RunMetrics& row, RunFiles& files);

}  // namespace rockstack
