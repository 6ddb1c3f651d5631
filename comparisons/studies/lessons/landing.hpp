#pragma once

#include "analytic/scene/scene.hpp"

namespace rockstack {

// Two blocks that turn as one body and land on the ground: pattern 3a becomes 1b. Spanos et al. 2001,
// Eqs. (126)–(140). The print has the base's inertias where the top block's belong, in Eqs. (137) and (138).

/// Which of the two misprints to keep.
struct Misprints {
  bool eq137 = false, eq138 = false;
};

/// Angular velocities after the landing over that before; and kinetic energy after over before.
struct Landing {
  double base = 0, top = 0, energy = 0;
};

/// Precondition: two blocks, the upper one not wider.
Landing land(const Scene& scene, const Misprints& misprints);

/// The two blocks welded into one: their mass, common centre and inertia, on the base's width.
Block welded(const Scene& scene);

}  // namespace rockstack
