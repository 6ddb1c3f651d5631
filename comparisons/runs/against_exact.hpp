#pragma once

#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/runs/other_answer.hpp"
#include "comparisons/runs/run_files.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// Sets an answer beside the exact solution at its own times: fills in the columns that the suite wants, of
/// histories up to `horizon` s (predictability.hpp), and adds history.csv, difference.csv, impacts.csv,
/// contact_impacts.csv, patterns.csv, energy.csv and parts.csv as far as it wants them, patterns.csv up to
/// the horizon and the others whole.
/// @throws std::runtime_error where the scene cannot be solved.
void compare_with_exact(const Scene& scene, const Suite& suite, const OtherAnswer& answer, double horizon,
                        RunMetrics& row, RunFiles& files);

}  // namespace rockstack
