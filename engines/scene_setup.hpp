#pragma once

#include "analytic/scene/scene.hpp"
#include "engines/parameters.hpp"
#include "engines/setup.hpp"

namespace rockstack {

/// A scene, shaken in the way that the setting `shaking` asks for, as an engine is told it; dt in s.
/// @throws std::invalid_argument as check_step(); std::runtime_error as place().
Setup set_up(const Scene& scene, double dt, const Parameters& parameters);

/// @throws std::invalid_argument for a time step that a duration holds less than once, or more than 10⁹
/// times. Both in s.
void check_step(double dt, double duration);

}  // namespace rockstack
