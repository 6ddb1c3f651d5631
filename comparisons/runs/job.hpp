#pragma once

#include "comparisons/measures/results/run_metrics.hpp"
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
};

/// True for the variant with Runge–Kutta steps, the one that has a time step.
bool is_baseline(const Job& job);

/// The row of a run before it is made: what is run, without results.
RunMetrics describe(const Job& job);

}  // namespace rockstack
