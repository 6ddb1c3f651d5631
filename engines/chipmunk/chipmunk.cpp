// Chipmunk beside the exact model. README.md in this folder says what its contacts are, what is set in both
// sets, what the tuned set changes, and why.
//
// A step moves bodies by the velocities that they have, then finds contacts, then changes velocities. So
// smooth motion is half a step late where other engines' is half a step early, and an impact comes when the
// overlap is found. A ground that really moves has its next step's velocity when contacts are solved, which
// is what blocks must follow. With collisionPersistence = 0 the library frees what it is using.

#include <chipmunk/chipmunk.h>
#include <fmt/format.h>

#include <cmath>

#include "engines/chipmunk/simulation.hpp"

namespace rockstack {

std::vector<Engine> make_chipmunk() {
  const double bias = std::pow(1 - 0.1F, 60);
  return {{{.name = "chipmunk",
            .solver = "sequential-impulse",
            .version = fmt::format("{}, double precision", cpVersionString),
            .licence = "MIT",
            .capabilities = {.planar = true, .lead = -0.5},
            .settings =
                {{.name = "iterations", .standard = 10, .tuned = 50, .least = 1, .most = 1e6, .whole = true},
                 {.name = "collisionSlop", .unit = "m", .standard = 0.1F, .tuned = 1e-4},
                 {.name = "collisionBias", .standard = bias, .most = 1},
                 {.name = "collisionPersistence", .standard = 3, .least = 1, .most = 1e6, .whole = true},
                 {.name = "elasticity", .most = 1},
                 shaking_setting()}},
           start_chipmunk}};
}

}  // namespace rockstack
