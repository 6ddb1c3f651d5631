#pragma once

#include "comparisons/studies/sweep/ensemble.hpp"

namespace rockstack {

/// Writes overturning.csv or .npz: what became of the runs of a sweep at each period and intensity.
void write_overturning(const std::filesystem::path& runs, const SummaryKeys& keys,
                       const std::filesystem::path& file);

/// Writes modes.csv or .npz: how the runs at each intensity and friction begin to move, and how they move.
void write_modes(const std::filesystem::path& runs, const SummaryKeys& keys,
                 const std::filesystem::path& file);

}  // namespace rockstack
