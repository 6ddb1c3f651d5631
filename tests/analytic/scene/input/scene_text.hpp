#pragma once

#include <string>
#include <vector>

#include "tests/temporary_folder.hpp"

namespace rockstack {

/// A scene of two blocks. Lines: 1 duration, 2–5 first block, 6–9 second block, 10–12 initial state.
std::string two_blocks();

/// The error's text for a scene file of that text, without the folder before "scene.toml"; empty where there
/// is no error.
std::string error_of(const std::string& text, const std::vector<std::string>& overrides = {});

}  // namespace rockstack
