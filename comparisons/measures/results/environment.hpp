#pragma once

#include <map>
#include <string>
#include <vector>

#include "engines/worker/worker_engine.hpp"

namespace rockstack {

/// What a results folder says about the program that made it: versions of program, compiler, libraries and
/// these engines, compiler flags, processor.
std::map<std::string, std::string> environment(const std::vector<const WorkerEngine*>& engines);

}  // namespace rockstack
