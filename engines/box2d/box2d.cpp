// Box2D beside the exact model. README.md in this folder says what its contacts are, what is set in both
// sets, what the tuned set changes, and why.
//
// Box2D's tolerances are lengths fixed when it is compiled, in units that are meant to be metres:
// b2_linearSlop, b2_polygonRadius, b2_maxTranslation. lengthUnit says how many metres that unit is, by which
// no angle changes but for these lengths. polygonRadius is the skin, in that unit; the library takes it from
// each shape.

#include <box2d/box2d.h>

#include "engines/box2d/simulation.hpp"

namespace rockstack {

std::vector<Engine> make_box2d() {
  return {
      {{.name = "box2d",
        .solver = "sequential-impulse",
        .version = BOX2D_VERSION ", single precision",
        .licence = "MIT",
        .capabilities = {.single_precision = true, .planar = true},
        .settings =
            {{.name = "velocityIterations",
              .standard = 8,
              .tuned = 50,
              .least = 1,
              .most = 1e6,
              .whole = true},
             {.name = "positionIterations", .standard = 3, .most = 1e6, .whole = true},
             switch_setting("warmStarting", true, true),
             switch_setting("continuousPhysics", true, false),
             {.name = "polygonRadius", .standard = b2_polygonRadius, .tuned = 0, .most = 1e3},
             {.name = "restitution", .most = 1},
             {.name = "restitutionThreshold", .standard = 1},
             {.name = "lengthUnit", .unit = "m", .standard = 1, .tuned = 0.02, .least = 1e-6, .most = 1e6},
             shaking_setting()}},
       start_box2d}};
}

}  // namespace rockstack
