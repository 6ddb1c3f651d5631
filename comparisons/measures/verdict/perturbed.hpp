#pragma once

#include <string>
#include <vector>

#include "comparisons/measures/statistics/distributions.hpp"
#include "comparisons/measures/statistics/fits.hpp"

namespace rockstack {

/// How many of a scene's perturbed neighbours topple, exactly and with engines, in a sentence; empty where
/// that was not asked for, or none topples.
std::string toppling_sentence(const std::vector<DistributionDistance>& distances,
                              const std::vector<RunMetrics>& rows, const std::string& scene);

/// How fast the error of a scene's first impact falls with the step, in a sentence; empty where it was not
/// fitted.
std::string convergence_sentence(const std::vector<SeriesFit>& fits, const std::string& scene);

}  // namespace rockstack
