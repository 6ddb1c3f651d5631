// What is said of Rapier (engines/web/rapier/page.md), by bare programs that share no code with its worker.
// No set was tuned on these scenes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engines/scene_setup.hpp"
#include "tests/engines/bare.hpp"
#include "tests/engines/findings/draws.hpp"
#include "tests/engines/findings/impact_laws.hpp"
#include "tests/engines/findings/web_engines.hpp"

namespace rockstack {
namespace {

/// What a landing leaves of 1 rad/s in Rapier, for a block of height over width r without weight.
double left_in_rapier(const WorkerEngine& engine, double r, double friction, double dt,
                      const Parameters& parameters, const std::string& more) {
  Scene scene;
  scene.gravity = 1e-9;
  scene.duration = 40.5 * dt;
  scene.blocks = {make_block(1, r, 500)};
  scene.initial = {{1e-9}, {-1}};
  scene.friction.assign(scene.blocks.size(), friction);
  const std::vector<double> angles =
      bare_angles(engine.name, moving_question(engine, scene, dt, parameters, more));
  return (angles.at(20) - angles.at(40)) / (20 * dt);
}

/// Normal impulses are found without friction, N₀, and then friction from them, once a substep. That friction
/// pushes the corner down by the share q = 3μr/(4 + r²) of what N₀ stopped. The next substep applies it once
/// more from its warm start, finds 2qN₀ for both, and then cuts friction to μ2qN₀. So N₀(1 + 2q) it is, where
/// Coulomb's law has N₀/(1 − q). More passes of a substep, or no warm start, give Coulomb's.
TEST(WebEngines, RapierFindsFrictionOnceInASubstep) {
  const WorkerEngine* engine = there("rapier:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Rapier is not there";
  struct Shape {
    double r, friction, dt;
    Parameters set;
  };
  const Parameters standard = engine->default_parameters();
  for (const auto& [r, friction, dt, set] : {Shape{1.5, 0.2, 1e-3, standard},
                                             {2, 0.3, 3e-4, standard},
                                             {2, 0.3, 3e-4, engine->tuned_parameters()},
                                             {1.5, 0.05, 1e-3, standard},
                                             {1.5, 0.3, 1e-3, standard},
                                             {3, 0.1, 1e-4, standard},
                                             {4, 0.1, 1e-4, standard}}) {
    const double q = 3 * friction * r / (4 + r * r);
    const double once = 1 - 6 * (1 - friction * r) / (4 + r * r) * (1 + 2 * q);
    const auto left = [&, r = r, friction = friction, dt = dt, set = set](const std::string& more) {
      return left_in_rapier(*engine, r, friction, dt, set, more);
    };
    SCOPED_TRACE(r);
    // Error of gaps that close within a substep, 1e-9 m over 2e-5 s, and of angles of 2e-3 rad, rounded to
    // 1e-7 of that.
    EXPECT_NEAR(left(""), once, 1e-3);
    EXPECT_NEAR(left("set num_internal_stabilization_iterations 16"), left_by_coulomb(r, friction), 1e-3);
    EXPECT_NEAR(left("set warmstart_coefficient 0"), left_by_coulomb(r, friction), 1e-3);
    EXPECT_GT(std::abs(once - left_by_coulomb(r, friction)), 0.01);
  }
}

/// Where a block sticks, the same order leaves less than Housner's ratio, whatever the coefficient.
TEST(WebEngines, RapierLeavesLessWhereBlocksStick) {
  const WorkerEngine* engine = there("rapier:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Rapier is not there";
  const Parameters standard = engine->default_parameters();
  for (const double r : {1.5, 2.0, 3.0, 4.0}) {
    const double threshold = 3 * r / (1 + 4 * r * r), housner = left_by_coulomb(r, 1);
    const auto left = [&](double friction, const std::string& more) {
      return left_in_rapier(*engine, r, friction, 3e-4, standard, more);
    };
    SCOPED_TRACE(r);
    EXPECT_LT(left(threshold + 0.1, ""), housner - 0.005);
    EXPECT_NEAR(left(threshold + 0.1, ""), left(threshold + 0.3, ""), 1e-3);
    EXPECT_NEAR(left(threshold + 0.1, "set num_internal_stabilization_iterations 16"), housner, 1e-3);
  }
}

/// A block of 1 m by 2 m, tilted by 0.3 rad, whose lowest corner comes down at 1 m/s and slides at ±3 m/s,
/// for a kilogram.
struct TiltedDrop {
  static constexpr double inertia = 5. / 12;
  double slip, friction;
  double across = 0.5 * std::cos(0.3) - std::sin(0.3), down = 0.5 * std::sin(0.3) + std::cos(0.3);
  double frictionless = 1 / (1 + across * across / inertia);  ///< normal impulse, N·s
  /// The share of what that stopped by which friction presses the corner down, or lifts it where it is below
  /// 0.
  double pressed = std::copysign(friction, slip) * across * down / inertia * frictionless;

  /// rad/s clockwise
  double spin(double normal) const {
    return (std::copysign(friction, slip) * down - across) * normal / inertia;
  }
};

/// The second scene: where friction lifts, the frictionless impulse is left as it is.
TEST(WebEngines, RapierDropsACornerByTheSameLaw) {
  const WorkerEngine* engine = there("rapier:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Rapier is not there";
  constexpr double dt = 1e-4;
  for (const TiltedDrop& drop : {TiltedDrop{3, 0.3}, {-3, 0.3}, {3, 0.1}}) {
    Scene scene;
    scene.gravity = 1e-9;
    scene.duration = 25.5 * dt;
    scene.blocks = {make_block(1, 2, 500)};
    scene.initial = {{0.3}, {0}};
    scene.friction.assign(scene.blocks.size(), drop.friction);
    const auto spin = [&](const std::string& more) {
      const std::string question = bare_question(*engine, scene, dt, engine->default_parameters()) +
                                   fmt::format("moving {} -1 0\n{}\n", drop.slip, more);
      const std::vector<double> angles = bare_angles(engine->name, question);
      return (angles.at(25) - angles.at(5)) / (20 * dt);
    };
    SCOPED_TRACE(drop.slip);
    const double normal = drop.frictionless * (1 + 2 * std::max(0.0, drop.pressed));
    // In 2.5 ms a corner that slides goes on by a hundredth of what the block measures.
    EXPECT_NEAR(spin(""), drop.spin(normal), 0.01);
    EXPECT_NEAR(spin("set num_internal_stabilization_iterations 16"),
                drop.spin(drop.frictionless / (1 - drop.pressed)), 0.01);
  }
}

/// How far the top one of some blocks at rest stands too low in Rapier, m.
double sinking_in_rapier(const WorkerEngine& engine, std::size_t blocks, double frequency) {
  Scene scene = slender_block(0.1);
  scene.blocks.assign(blocks, make_block(1, 1, 2500));
  scene.initial = {std::vector<double>(blocks), std::vector<double>(blocks)};
  const Parameters parameters = with(engine.default_parameters(), {{"contact_natural_frequency", frequency}});
  const Trajectory motion = run(engine, set_up(scene, 1e-3, parameters), parameters, true);
  return static_cast<double>(blocks) - 0.5 - motion.bodies.back().y;
}

/// Contacts of the ground have their own.
TEST(WebEngines, RapierHasAnotherFrequencyOnTheGround) {
  const WorkerEngine* engine = there("rapier:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Rapier is not there";
  EXPECT_EQ(sinking_in_rapier(*engine, 1, 5), sinking_in_rapier(*engine, 1, 300));
  EXPECT_GT(sinking_in_rapier(*engine, 2, 5), 1.5 * sinking_in_rapier(*engine, 2, 300));
}

}  // namespace
}  // namespace rockstack
