#pragma once

#include <memory>
#include <vector>

#include "engines/engine.hpp"

namespace rockstack {

/// Bullet with each of its constraint solvers: "sequential-impulse" (projected Gauss–Seidel, the default),
/// "nncg" (nonsmooth nonlinear conjugate gradient), and "mlcp-…", which put all contacts into one mixed
/// linear complementarity problem and solve it by Dantzig's or Lemke's algorithm or by projected
/// Gauss–Seidel. The engine is "bullet" in double precision, "bullet-single" in single: two builds of the
/// same adapter, never both in one program, because the libraries share their symbols' names.
std::vector<std::unique_ptr<Engine>> make_bullet();

}  // namespace rockstack
