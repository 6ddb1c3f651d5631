#pragma once

#include <filesystem>

#include "comparisons/studies/sweep/ensemble.hpp"

namespace rockstack {

inline constexpr double most_runs = 1e9;  ///< of an ensemble

/// One table [[vary]]; paths of records are relative to `folder`. @throws InputError with place, key, value
/// and range.
Variation read_variation(const Node& table, const std::filesystem::path& folder);

/// The first value of a variation, or the median where values are drawn.
Value typical_value(const Variation& variation);

}  // namespace rockstack
