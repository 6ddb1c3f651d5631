#pragma once

#include <memory>
#include <vector>

#include "engines/engine.hpp"

namespace rockstack {

/// The Open Dynamics Engine with each of its solvers: "step", the direct dWorldStep (Dantzig's algorithm),
/// and "quickstep", the iterative dWorldQuickStep (projected successive over-relaxation).
std::vector<std::unique_ptr<Engine>> make_ode();

}  // namespace rockstack
