#pragma once

#include <map>
#include <string>

namespace rockstack {

/// What a results folder says about the program that made it: versions of program, compiler, libraries and
/// engines, compiler flags, processor.
std::map<std::string, std::string> environment();

}  // namespace rockstack
