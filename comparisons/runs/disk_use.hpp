#pragma once

#include <vector>

#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// About how large the histories of a comparison are, bytes: samples × columns × runs. An upper bound where
/// blocks topple.
double history_bytes(const std::vector<Suite>& suites);

}  // namespace rockstack
