#pragma once

#include "analytic/scene/scene.hpp"
#include "comparisons/suites/perturbations.hpp"

namespace rockstack {

/// Until when a scene can be predicted, s: the first time at which the exact motion of one of its draws,
/// which hardly differ, is further than `tolerance` rad from its own, seen every sample_interval; its
/// duration where none ever is. Later only distributions can be compared.
/// @throws as solve().
double predictable_time(const Scene& scene, const Draws& draws, double tolerance);

}  // namespace rockstack
