#pragma once

#include <memory>

#include "engines/engine.hpp"

namespace rockstack {

/// Bullet in double precision with its default solver, sequential impulse (projected Gauss–Seidel).
std::unique_ptr<Engine> make_bullet();

}  // namespace rockstack
