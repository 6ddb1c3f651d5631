// What is said of Matter.js (engines/web/matter-js/page.md), by bare programs that share no code with its
// worker. No set was tuned on these scenes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engines/scene_setup.hpp"
#include "tests/engines/bare.hpp"
#include "tests/engines/findings/draws.hpp"
#include "tests/engines/findings/web_engines.hpp"

namespace rockstack {
namespace {

/// A block of 2 m height in Matter.js that falls back on its corner, before it lands. Its moment of inertia
/// is multiplied by `factor`, in the exact motion too.
struct FallInMatter {
  double width, factor;                  ///< m, -
  double start = 0.02, duration = 0.08;  ///< rad, s

  /// The largest error at a step, rad.
  double error(const WorkerEngine& engine, double dt, double passes = 6) const {
    Scene scene;
    scene.blocks = {make_block(width, 2, 500)};
    scene.blocks[0].inertia *= factor;
    scene.initial = {{start}, {0}};
    scene.friction.assign(scene.blocks.size(), 1000);
    scene.duration = duration;
    const Parameters parameters =
        with(engine.default_parameters(), {{"inertiaScale", 1}, {"positionIterations", passes}});
    return error_of({scene, dt}, bare_angles(engine.name, bare_question(engine, scene, dt, parameters)));
  }

  /// What a pass takes of a corner's slip, at the start.
  double taken() const {
    const double sine = std::sin(std::atan(width / 2) - start);
    return (1 + 3 / factor) / (1 + 3 / factor * sine * sine);
  }
};

/// Matter.js corrects the slip of a corner by its effective mass along the normal, where that along the face
/// is meant, and its speed along the normal at once. Of what then is left a pass takes
/// (1 + (b² + h²)m/I)/(1 + b²m/I) for a corner b beside and h below the centre. Passes end where that is
/// below
/// 2. The library gives a body four times its moment of inertia: then it always is, and the motion that of
/// such a body, to the order of the step.
TEST(WebEngines, PassesOfMatterOvershootTheSlipOfASlenderBlock) {
  const WorkerEngine* engine = there("matter-js:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Matter.js is not there";
  const std::vector<double> steps{4e-3, 1e-3, 2.5e-4};
  for (const FallInMatter& block :
       {FallInMatter{0.4, 1}, {0.4, 2}, {0.8, 1}, {1.3, 1, 0.06}, {2, 1}, {2, 1, 0.3}, {2, 2}}) {
    SCOPED_TRACE(::testing::Message() << block.width << " m, " << block.factor << ", " << block.start);
    ASSERT_GT(std::abs(block.taken() - 2), 0.2);
    FallInMatter heavy = block;
    heavy.factor = 4;
    double coarser = 0;
    for (const double dt : steps) {
      const double good = heavy.error(*engine, dt), error = block.error(*engine, dt);
      if (coarser > 0) {
        EXPECT_NEAR(coarser / good, 4, 0.2);
      }
      coarser = good;
      if (block.taken() > 2) {
        EXPECT_GT(error, 4 * good) << dt;
      } else {
        EXPECT_LT(error, 2 * good) << dt;
      }
    }
  }
}

/// A pass over places takes 1.8 of what an overlap is above its slop. After an even number of passes it is
/// below that where a step's fall is large, and friction is counted by it: from 7 ms on a block slips.
TEST(WebEngines, EvenPassesOverPlacesTakeFrictionAwayInMatter) {
  const WorkerEngine* engine = there("matter-js:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Matter.js is not there";
  const FallInMatter block{1, 4, 0.2, 0.4};
  for (const double dt : {8e-3, 16e-3})
    for (const double even : {4, 6})
      EXPECT_GT(block.error(*engine, dt, even), 4 * block.error(*engine, dt, even + 1)) << dt;
  EXPECT_LT(block.error(*engine, 4e-3, 6), 1.1 * block.error(*engine, 4e-3, 7));
}

/// A step moves bodies before contacts take its pull back: what sticks creeps at a dt under a pull of a
/// through its centre.
TEST(WebEngines, WhatSticksInMatterCreeps) {
  const WorkerEngine* engine = there("matter-js:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Matter.js is not there";
  for (const Parameters& set : {engine->default_parameters(), engine->tuned_parameters()}) {
    for (const double pull : {2.0, 5.0}) {
      for (const double dt : {4e-3, 1e-3, 2.5e-4}) {
        Scene scene;
        scene.blocks = {make_block(2, 1, 500)};
        scene.initial = {{0}, {0}};
        scene.friction.assign(scene.blocks.size(), 1000);
        scene.duration = 200.5 * dt;
        scene.horizontal.interval = 10;
        scene.horizontal.samples = {-pull, -pull};
        const std::vector<double> places =
            bare_angles(engine->name, bare_question(*engine, scene, dt, set) + "along 1\n");
        EXPECT_NEAR((places.at(200) - places.at(100)) / (100 * dt), pull * dt, 0.01 * pull * dt) << dt;
      }
    }
  }
}

/// Each of two corners gives half of what one would alone, by its own effective mass: of a flat landing
/// (1 + e)/(1 + b²m/I) − 1 is left, where that is above 0.
TEST(WebEngines, FlatLandingsInMatterBounceByTheirShape) {
  const WorkerEngine* engine = there("matter-js:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Matter.js is not there";
  const Parameters set = with(engine->tuned_parameters(), {{"restitution", 0.8}});
  for (const double width : {0.4, 0.8, 1.6}) {
    const Block block = make_block(width, 1, 500);
    Scene scene;
    scene.blocks = {block};
    scene.law = Law::unilateral;
    scene.initial = {{0}, {0}};
    scene.initial.gaps = {0.2};
    scene.friction.assign(scene.blocks.size(), 1000);
    scene.duration = 0.3;
    const double inertia = set.at("inertiaScale") * block.inertia / block.mass;
    const double kept = 1.8 / (1 + width * width / 4 / inertia) - 1;
    double down = 0, up = 0;
    for (const BodyState& body : run(*engine, set_up(scene, 2.5e-4, set), set, true).bodies) {
      down = std::max(down, -body.velocity_y);
      if (down > 1.5) up = std::max(up, body.velocity_y);
    }
    // A step's share of the fall, 0.2 s.
    EXPECT_NEAR(up / down, std::max(kept, 0.0), 0.005) << width;
  }
}

/// A block of tonnes that slides is slowed by 2v/(m dt), m in kg: each of two points holds an impulse in kg
/// px that is bounded by the slip of a step in px. No coefficient of friction and no weight is in that.
TEST(WebEngines, FrictionOfWhatSlidesInMatterKnowsNoWeight) {
  const WorkerEngine* engine = there("matter-js:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Matter.js is not there";
  struct Sliding {
    double mass, friction, gravity;
  };
  for (const Sliding& block :
       {Sliding{1000, 0.2, 9.81}, {1000, 0.4, 9.81}, {1000, 0.4, 5}, {4000, 0.4, 9.81}}) {
    for (const double dt : {4e-3, 1e-3}) {
      Scene scene;
      scene.gravity = block.gravity;
      scene.blocks = {make_block(2, 1, block.mass / 2)};
      scene.law = Law::unilateral;
      scene.initial = {{0}, {0}};
      scene.initial.slip_velocities = {0.5};
      scene.friction.assign(scene.blocks.size(), block.friction);
      constexpr int steps = 100;
      scene.duration = (steps + 0.5) * dt;
      const std::vector<double> places = bare_angles(
          engine->name, moving_question(*engine, scene, dt, engine->default_parameters(), "along 1"));
      const double left = (places.at(steps) - places.at(steps - 1)) / dt / 0.5;
      // The impulses grow to their bounds in the first step.
      EXPECT_NEAR(left, std::pow(1 - 2 / block.mass, steps), 1.5 * 2 / block.mass) << block.mass << ' ' << dt;
    }
  }
}

}  // namespace
}  // namespace rockstack
