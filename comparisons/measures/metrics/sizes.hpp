#pragma once

#include "analytic/scene/scene.hpp"

namespace rockstack {

/// Lines on sizes beyond those of any stack, as of lengths in mm.
std::vector<std::string> size_warnings(const Scene& scene);

}  // namespace rockstack
