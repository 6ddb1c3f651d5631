#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "engines/worker/registry.hpp"

namespace rockstack {

/// Names in "bullet:ode".
inline std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> list;
  std::istringstream names(text);
  for (std::string name; std::getline(names, name, ':');) list.push_back(name);
  return list;
}

/// Names of the engines that are libraries of C++, but those left out. Those of npm are scripts, of which a
/// process takes a fifth of a second to start: check-engine has their tests (tests/engines/CMakeLists.txt).
inline std::vector<std::string> native_names(const std::vector<std::string>& left_out = {}) {
  std::vector<std::string> list = names_in(ROCKSTACK_NATIVE_ENGINES);
  std::erase_if(list, [&](const auto& name) { return std::ranges::find(left_out, name) != left_out.end(); });
  return list;
}

inline EngineList native_engines() {
  EngineList list;
  for (const std::string& name : native_names())
    std::ranges::copy(engines_called(name), std::back_inserter(list));
  return list;
}

/// Tests of an engine have its name, so that a program of tests starts without asking any worker.
class OfEngine : public ::testing::TestWithParam<std::string> {
 protected:
  static const WorkerEngine& first_solver() { return engines_called(GetParam()).front(); }
};

/// As GoogleTest has names.
inline std::string engine_test_name(const ::testing::TestParamInfo<std::string>& engine) {
  std::string name = engine.param;
  std::ranges::replace(name, '-', '_');
  return name;
}

}  // namespace rockstack
