#pragma once

#include <map>
#include <string>
#include <vector>

#include "comparisons/suite.hpp"

namespace rockstack {

/// What a results folder says about the program that made it: versions of program, compiler, libraries and
/// the engines of these series, compiler flags, processor.
std::map<std::string, std::string> environment(const std::vector<const EngineSeries*>& series);

}  // namespace rockstack
