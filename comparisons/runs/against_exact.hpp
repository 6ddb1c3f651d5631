#pragma once

#include <optional>
#include <vector>

#include "analytic/scene/history.hpp"
#include "comparisons/metrics/impacts.hpp"
#include "comparisons/results/run_metrics.hpp"
#include "comparisons/runs/run_files.hpp"
#include "comparisons/suites/suite.hpp"
#include "engines/body_record.hpp"

namespace rockstack {

/// Another answer to a scene than the exact one.
struct OtherAnswer {
  const History& history;
  double interval = 0;                ///< between its samples, s
  std::vector<ImpactTime> impacts;    ///< at the chatter speed or more
  bool topples = false;               ///< within the scene
  std::optional<BodyRecord> bodies;   ///< of an engine
  std::vector<double> friction = {};  ///< that acts in an engine, of each interface
};

/// Sets an answer beside the exact solution at its own times: fills in the columns that the suite wants, and
/// adds history.csv, difference.csv, impacts.csv, contact_impacts.csv, patterns.csv, energy.csv and parts.csv
/// as far as it wants them.
/// @throws std::runtime_error where the scene cannot be solved.
void compare_with_exact(const Scene& scene, const Suite& suite, const OtherAnswer& answer, RunMetrics& row,
                        RunFiles& files);

}  // namespace rockstack
