// What is said of Box2D 3 (engines/web/box2d3/page.md), by bare programs that share no code with its worker.
// No set was tuned on these scenes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engines/scene_setup.hpp"
#include "tests/engines/bare.hpp"
#include "tests/engines/findings/draws.hpp"
#include "tests/engines/findings/impact_laws.hpp"
#include "tests/engines/findings/web_engines.hpp"

namespace rockstack {
namespace {

using std::numbers::pi;

/// The angle that the library makes of one, rad: quotients in the place of sine and cosine, and the turn that
/// they are of.
double as_the_library_turns(double angle) {
  const double sine =
      16 * angle * (pi - angle) / (5 * pi * pi - 4 * angle * (pi - angle));  // Bhaskara's, about 629
  const double cosine = (pi * pi - 4 * angle * angle) / (pi * pi + angle * angle);
  return std::atan2(sine, cosine);
}

Scene released_at(double angle) {
  Scene scene = slender_block(0.7);
  scene.initial.angles = {angle};
  return scene;
}

/// What a block does that is turned by the library's own sine and cosine, or by exact ones.
std::vector<double> turned(const WorkerEngine& engine, const Draw& draw, bool by_library) {
  std::string question = bare_question(engine, draw.scene, draw.dt, engine.default_parameters());
  if (by_library) question += "angleByLibrary 1\n";
  return bare_angles(engine.name, question);
}

/// A body that is given its angle by the library's own call starts turned further. Error of single precision
/// in the quotients: a few units in the last place of 1.
TEST(WebEngines, Box2D3TurnsABodyTooFar) {
  const WorkerEngine* engine = there("box2d3:soft-step");
  if (engine == nullptr) GTEST_SKIP() << "Box2D 3 is not there";
  for (const double angle : {0.02, 0.05, 0.1, 0.15}) {
    SCOPED_TRACE(angle);
    const Draw draw{released_at(angle), 1e-3};
    EXPECT_NEAR(turned(*engine, draw, false).front(), angle, 1e-6);
    EXPECT_NEAR(turned(*engine, draw, true).front(), as_the_library_turns(angle), 1e-6);
    EXPECT_GT(as_the_library_turns(angle), 1.01 * angle);
  }
  for (const Draw& draw : replicates(released_at(0.1), 1e-3, 5))
    EXPECT_GT(error_of(draw, turned(*engine, draw, true)), 3 * error_of(draw, turned(*engine, draw, false)));
}

/// How far a block of this height sinks in at rest, m.
double sinking_in_box2d3(const WorkerEngine& engine, double height, double dt, const Parameters& parameters) {
  Scene scene;
  scene.blocks = {make_block(1, height, 2500)};
  scene.initial = {{0}, {0}};
  scene.friction = {0.5};
  scene.duration = 2;
  const Trajectory motion = run(engine, set_up(scene, dt, parameters), parameters, true);
  return height / 2 - motion.bodies.back().y;
}

/// A contact of the ground is a spring of twice contactHertz that knows no mass and no step: each of two
/// corners, r from the middle, carries half the weight on its own effective mass, and with
/// ω = 2π · 2 contactHertz the block sinks by g/ω² · (1 + m r²/I)/2. Corners of the ground are 40 m away,
/// where places are rounded to 3.8e-6 m; the rest decays below a hundredth in 2 s.
TEST(WebEngines, Box2D3SinksByWeightOverASpringOfItsMass) {
  const WorkerEngine* engine = there("box2d3:soft-step");
  if (engine == nullptr) GTEST_SKIP() << "Box2D 3 is not there";
  for (const double hertz : {20.0, 30.0}) {
    const double omega = 4 * pi * hertz;
    for (const auto& [height, dt] : {std::pair{0.5, 1e-3}, {1.5, 1e-3}, {1.0, 4e-3}}) {
      SCOPED_TRACE(::testing::Message() << hertz << " Hz, " << height << " m, " << dt << " s");
      const double corner = 12 * 0.25 / (1 + height * height);  // m r²/I
      const double expected = 9.81 / (omega * omega) * (1 + corner) / 2;
      const Parameters parameters = with(engine->default_parameters(), {{"contactHertz", hertz}});
      EXPECT_NEAR(sinking_in_box2d3(*engine, height, dt, parameters), expected, 4e-6 + 0.01 * expected);
    }
  }
}

/// By how much what the ground bears of a rocking block is off the momentum that the block gains, at most, as
/// a share of weight and force.
double unbalance_in_box2d3(const WorkerEngine& engine, double substeps) {
  constexpr double dt = 1e-3;
  const Parameters parameters = with(engine.default_parameters(), {{"subStepCount", substeps}});
  const Scene scene = released_at(0.1);
  const Trajectory motion = run(engine, set_up(scene, dt, parameters), parameters, true, {}, 0, true);
  double most = 0;
  for (std::size_t i = 0; i + 1 < motion.bodies.size(); ++i) {
    const auto &from = motion.bodies[i], &to = motion.bodies[i + 1];
    const double mass = scene.blocks[0].mass, weight = mass * scene.gravity;
    const double normal = motion.reactions.at(i).normal, tangential = motion.reactions[i].tangential;
    const double off = std::hypot(mass * (to.velocity_x - from.velocity_x) / dt - tangential,
                                  mass * (to.velocity_y - from.velocity_y) / dt + weight - normal);
    most = std::max(most, off / (weight + std::hypot(normal, tangential)));
  }
  return most;
}

/// What is left of a step are its last substep's impulses: with a single one they are the step's, in single
/// precision, and with four an impact in one of the others is missed.
TEST(WebEngines, Box2D3TellsTheForceOfItsLastSubstep) {
  const WorkerEngine* engine = there("box2d3:soft-step");
  if (engine == nullptr) GTEST_SKIP() << "Box2D 3 is not there";
  EXPECT_LT(unbalance_in_box2d3(*engine, 1), 0.01);
  EXPECT_GT(unbalance_in_box2d3(*engine, 4), 0.1);
}

/// The angular velocity that a landing leaves of 1 rad/s, for a block of height over width r without weight.
double left_in_box2d3(const WorkerEngine& engine, double r, double friction, const Parameters& parameters) {
  constexpr double dt = 1e-4;
  Scene scene;
  scene.gravity = 1e-9;
  scene.duration = 60.5 * dt;
  scene.blocks = {make_block(1, r, 500)};
  scene.initial = {{1e-9}, {-1}};
  scene.friction = {friction};
  const std::vector<double> angles = bare_angles(engine.name, moving_question(engine, scene, dt, parameters));
  return (angles.at(40) - angles.at(60)) / (20 * dt);
}

/// Substeps with two passes of friction after normals come to Coulomb's law, where Rapier's one does not.
TEST(WebEngines, Box2D3HasCoulombsFrictionAtAnImpact) {
  const WorkerEngine* engine = there("box2d3:soft-step");
  if (engine == nullptr) GTEST_SKIP() << "Box2D 3 is not there";
  for (const Parameters& set : {engine->default_parameters(), engine->tuned_parameters()})
    for (const auto& [r, friction] : {std::pair{1.5, 0.2}, {2.0, 0.3}, {2.0, 0.0}, {3.0, 0.1}, {2.0, 1.0}})
      EXPECT_NEAR(left_in_box2d3(*engine, r, friction, set), left_by_coulomb(r, friction), 1e-3)
          << r << ' ' << friction;
}

}  // namespace
}  // namespace rockstack
