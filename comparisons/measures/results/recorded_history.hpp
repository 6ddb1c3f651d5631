#pragma once

#include <filesystem>
#include <vector>

#include "analytic/scene/history.hpp"
#include "comparisons/measures/metrics/alignment.hpp"

namespace rockstack {

// What tables.hpp writes of a run, read back. All throw InputError with file and line of what is missing or
// malformed.

/// FOLDER/history.csv, and FOLDER/events.csv where it is there.
History read_history(const std::filesystem::path& folder);

/// A file that impacts_csv() has written, but for the sides.
std::vector<AlignedImpact> read_impacts(const std::filesystem::path& file);

}  // namespace rockstack
