#pragma once

#include <future>
#include <vector>

#include "analytic/scene/scene.hpp"
#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// Between samples of histories that have no step of their own, s.
inline constexpr double sample_interval = 1e-3;

/// Until when a scene can be predicted, s: the first time at which the exact motion of one of its draws,
/// which hardly differ, is further than `tolerance` rad from its own, seen every sample_interval; its
/// duration where none ever is. Later only distributions can be compared.
/// @throws as solve().
double predictable_time(const Scene& scene, const Draws& draws, double tolerance);

/// How many scenes that hardly differ tell the horizon of one, itself included: of a suite's size and seed,
/// but as many whatever its number of draws, so that a scene has one horizon.
inline constexpr int horizon_scenes = 21;

/// Up to when histories of a suite's scene can be compared, s: predictable_time(), found where it is first
/// asked for; the duration where the exact motion cannot be found. Keeps references to the suite and the
/// scene.
std::shared_future<double> horizon_of(const Suite& suite, const NamedScene& scene);

/// One run to be made: of a series at one step, of a variant, or with neither the exact one that all others
/// are compared with.
struct Job {
  const Suite& suite;
  const NamedScene& scene;
  double dt;  ///< of a series or of the variant rk4, s
  const EngineSeries* series = nullptr;
  const Variant* variant = nullptr;
  std::shared_future<double> horizon = {};  ///< of the scene, one for all its jobs; none: its duration
};

/// True for the variant with Runge–Kutta steps, the one that has a time step.
bool is_baseline(const Job& job);

/// Up to when the job's histories are compared, s.
double horizon_of(const Job& job);

/// The replicates behind the job's numbers: those of its suite, or as many as it has at the finest step.
Draws draws_of(const Job& job);

/// The row of a run before it is made: what is run, without results.
RunMetrics describe(const Job& job);

/// Every scene on the exact solver, on its variants and on every series at each step. Keeps references to the
/// suites.
std::vector<Job> jobs_of(const std::vector<Suite>& suites);

/// About how large the histories of a comparison are, bytes: samples × columns × runs. An upper bound where
/// blocks topple.
double history_bytes(const std::vector<Suite>& suites);

}  // namespace rockstack
