// dWorldStep finds normal forces without friction first, and takes the limits of friction from those. Where a
// block pushes its neighbour sideways they are too small, whatever the coefficient.

#include <gtest/gtest.h>

#include "engines/scene_setup.hpp"
#include "tests/engines/linked_engines.hpp"

namespace rockstack {
namespace {

/// The base of a stack that leans lands while the ground pushes: 12 ms of rocking about both pivots, in which
/// friction of 0.9 is needed.
Scene landing() {
  Scene scene;
  scene.duration = 0.012;
  scene.blocks = {make_block(1.25, 1.25, 2500), make_block(1, 2.5, 2500)};
  scene.initial = {{3.4e-5, 1.612e-3}, {-0.1188, -0.0442}};
  scene.horizontal.pulse = Pulse{PulseShape::rectangle, 2.77, 1, 0, 1, 0};
  return scene;
}

double slip(const Engine& engine, double coefficient) {
  Parameters parameters = engine.tuned_parameters();
  parameters["contactApprox1"] = coefficient;
  return simulate(engine, landing(), 1e-5, parameters, true).bodies->slip;
}

TEST(OdeFriction, LimitsFromNormalsFoundWithoutFrictionLetAStackSlipThatForceLimitsHold) {
  for (const auto& engine : linked_engines()) {
    if (engine->name != "ode") continue;
    // The corner of a block that turns by 1e-3 rad moves along its face by 1e-6 of a metre.
    EXPECT_LT(slip(*engine, 0), 1e-6) << engine->solver;
    if (engine->solver == "step") {
      EXPECT_GT(slip(*engine, 1), 1e-4);
    } else {
      EXPECT_LT(slip(*engine, 1), 1e-6) << engine->solver;
    }
  }
}

}  // namespace
}  // namespace rockstack
