#pragma once

#include <sstream>
#include <string>

#include "engines/worker/registry.hpp"

namespace rockstack {

/// The engines that are libraries of C++. Those of npm are scripts, of which a process takes a fifth of a
/// second to start: check-engine has their tests (tests/engines/CMakeLists.txt).
inline EngineList native_engines() {
  EngineList list;
  std::istringstream names(ROCKSTACK_NATIVE_ENGINES);
  for (std::string name; std::getline(names, name, ':');) {
    const EngineList own = engines_called(name);
    list.insert(list.end(), own.begin(), own.end());
  }
  return list;
}

}  // namespace rockstack
