#pragma once

#include "analytic/scene/branching.hpp"
#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"
#include "analytic/scene/solve_options.hpp"

namespace rockstack {

/// As solve() of solve.hpp, led through its forks, which `branching` comes to hold; null: led nowhere.
History solve_led(const Scene& scene, const SolveOptions& options, Branching* branching);

}  // namespace rockstack
