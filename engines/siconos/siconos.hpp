#pragma once

#include <memory>
#include <vector>

#include "engines/engine.hpp"

namespace rockstack {

/// Siconos: Moreau–Jean time stepping with "nsgs", a nonsmooth Gauss–Seidel iteration over contacts with
/// friction.
std::vector<std::unique_ptr<Engine>> make_siconos();

}  // namespace rockstack
