#pragma once

#include <vector>

#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// About how large the histories of a comparison are, bytes: samples × columns × runs, each number as long as
/// one that reads back to the same double. An upper bound where blocks topple.
double history_bytes(const std::vector<Suite>& suites);

}  // namespace rockstack
