#pragma once

#include <memory>

#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/runs/predictability.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// One run to be made: of a series at one step, of a variant, or with neither the exact one that all others
/// are compared with.
struct Job {
  const Suite& suite;
  const NamedScene& scene;
  double dt;  ///< of a series or of the variant rk4, s
  const EngineSeries* series = nullptr;
  const Variant* variant = nullptr;
  std::shared_ptr<const Horizon> horizon =
      nullptr;  ///< of the scene, one for all its jobs; null: its duration
};

/// True for the variant with Runge–Kutta steps, the one that has a time step.
bool is_baseline(const Job& job);

/// Up to when the job's histories are compared, s.
double horizon_of(const Job& job);

/// The replicates behind the job's numbers: those of its suite, or as many as it has at the finest step.
Draws draws_of(const Job& job);

/// The row of a run before it is made: what is run, without results.
RunMetrics describe(const Job& job);

}  // namespace rockstack
