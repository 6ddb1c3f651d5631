#pragma once

#include <filesystem>

#include "comparisons/studies/sweep/ensemble.hpp"

namespace rockstack {

/// Writes the summaries that an ensemble asks for, from DIR/runs.csv alone. Runs that failed are counted and
/// left out.
///
/// By intensity:
/// - fragility.csv: the share of runs that topple at each intensity, its confidence bounds, and the fitted
///   lognormal curve, whose parameters are in fragility-fit.csv (no row where there is no fit);
/// - incremental.csv: peak angle over slenderness against intensity, a curve for each choice of all other
///   values; incremental-fractiles.csv: 16, 50 and 84 % of the curves at each intensity, a toppled block
///   counting as infinitely far. Only where some curve has two points.
/// By intensity and period:
/// - overturning.csv: how many runs stay at rest, rock, topple after an impact and topple without one.
/// By intensity and friction:
/// - modes.csv: how many runs begin in each mode of motion, as columns onset_*, and how many are all in all
/// of
///   each.
///
/// Files of summaries that are not asked for are removed. @throws std::runtime_error where a file cannot be
/// written.
void write_summaries(const std::filesystem::path& folder, const SummaryKeys& keys);

}  // namespace rockstack
