#pragma once

#include <mutex>

#include "analytic/scene/scene.hpp"
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

/// Up to when histories of a suite's scene can be compared, found where it is first asked for. Keeps
/// references to the suite and the scene.
class Horizon {
 public:
  Horizon(const Suite& suite, const NamedScene& scene) : suite_(suite), scene_(scene) {}

  /// predictable_time(), s; the duration where the exact motion cannot be found, so that nothing is compared.
  double time() const;

 private:
  const Suite& suite_;
  const NamedScene& scene_;
  mutable std::once_flag found_;
  mutable double time_ = 0;
};

}  // namespace rockstack
