#pragma once

#include <cstdint>

#include "analytic/scene/scene.hpp"

namespace rockstack {

/// Many scenes that hardly differ from a given one: where histories part by nature, only their distributions
/// can be compared.
struct Perturbations {
  int runs = 0;        ///< 0: none asked for
  double size = 1e-6;  ///< the largest relative change, > 0
  std::uint64_t seed = 1;
};

/// The scene of one run (from 0): each block's width and height, all initial angles and velocities together,
/// and each ground motion are multiplied by 1 + size · u, u uniform between −1 and 1. Masses stay, and so
/// does what is closed. The same on every call.
Scene perturbed(const Scene& scene, const Perturbations& perturbations, int run);

}  // namespace rockstack
