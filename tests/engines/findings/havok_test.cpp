// What is said of Havok (engines/web/havok/page.md). No set was tuned on these scenes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engines/scene_setup.hpp"
#include "tests/engines/bare.hpp"
#include "tests/engines/findings/draws.hpp"
#include "tests/engines/findings/web_engines.hpp"

namespace rockstack {
namespace {

/// What a block lacks of the upward velocity that `pull` m/s² give it from `start` m/s on, in Havok, m/s, and
/// after how long, s.
struct Lack {
  double velocity, time;
};
Lack lack_in_havok(const WorkerEngine& engine, Scene scene, double start, double pull, double dt) {
  scene.vertical.interval = 10;
  scene.vertical.samples = {-scene.gravity - pull, -scene.gravity - pull};
  const Parameters parameters = engine.tuned_parameters();
  const std::vector<BodyState> bodies = run(engine, set_up(scene, dt, parameters), parameters, true).bodies;
  const double time = dt * static_cast<double>(bodies.size() - 1);
  return {start + pull * time - bodies.back().velocity_y, time};
}

/// Below 0.1 m/s Havok brakes a body by 1/32 of what pulls it. One that starts at rest lacks 0.1/31 m/s when
/// it gets there, whatever pulls it; one that comes to rest against the pull stops sooner.
TEST(WebEngines, HavokBrakesWhatIsSlow) {
  const WorkerEngine* engine = there("havok:own");
  if (engine == nullptr) GTEST_SKIP() << "Havok is not there";
  for (const double pull : {1.0, 2.0, 5.0}) {
    for (const double dt : {4e-3, 1e-3, 2.5e-4}) {
      SCOPED_TRACE(::testing::Message() << pull << " m/s², " << dt << " s");
      Scene starts = slender_block(0.3);
      starts.initial = {{0}, {0}};
      // The speed is read off motions, to a tenth; and a step's share.
      EXPECT_NEAR(lack_in_havok(*engine, starts, 0, pull, dt).velocity, 0.1 / 31, 0.01 / 31 + pull * dt / 32);
      Scene stops = starts;
      stops.law = Law::unilateral;
      stops.initial.gaps = {0.5};
      stops.initial.gap_velocities = {0.09};
      stops.duration = 0.08 / pull;
      const auto [velocity, time] = lack_in_havok(*engine, stops, 0.09, -pull, dt);
      EXPECT_NEAR(velocity, pull * time / 32, 0.1 * pull * time / 32 + pull * dt / 32);
    }
  }
}

/// In free space, without gravity, the brake is that of 9.81 m/s²; what is faster than 0.1 m/s is let be, and
/// so is a turn. Shapes do not matter. By a bare program.
TEST(WebEngines, HavokBrakesWhatIsSlowInFreeSpace) {
  const WorkerEngine* engine = there("havok:own");
  if (engine == nullptr) GTEST_SKIP() << "Havok is not there";
  struct Flight {
    double width, height, speed, spin;
  };
  for (const auto& [width, height, speed, spin] : {Flight{0.5, 2.5, 0.09, 0},
                                                   {0.5, 2.5, 0.06, 0.5},
                                                   {0.1, 0.2, 0.06, 0},
                                                   {0.5, 2.5, 0.2, 0},
                                                   {2, 1, 0.12, 0.5}}) {
    for (const double dt : {4e-3, 1e-3}) {
      const int steps = static_cast<int>(std::lround(0.12 / dt));
      const std::string question = fmt::format(
          "gravity 0 friction 0 reach 10 dt {} steps {} block {} {} 1 100 10 10 10 0 9 0 moving {} 0 {} along 1\n",
          dt, steps, width, height, speed, spin);
      const std::vector<double> places = bare_angles(engine->name, question);
      const auto at = [&](int step) { return places.at(static_cast<std::size_t>(step)); };
      const double brake = (at(1) - at(0) - at(steps) + at(steps - 1)) / (dt * dt * (steps - 1));
      // Places have 24 bits, and the difference of two velocities is over 0.1 s.
      EXPECT_NEAR(brake, speed < 0.1 ? 9.81 / 32 : 0, 0.02 * 9.81 / 32) << speed << ' ' << spin << ' ' << dt;
    }
  }
}

/// Havok rounds corners, by 15 mm whatever the size: a block that starts tilted by θ drops by
/// r (cos θ + sin θ − 1) before it turns on its corner. So small blocks land late and large ones do not.
TEST(WebEngines, HavokRoundsCornersOfAnySizeByAsMuch) {
  const WorkerEngine* engine = there("havok:own");
  if (engine == nullptr) GTEST_SKIP() << "Havok is not there";
  for (const double width : {0.5, 1.0, 4.0}) {
    SCOPED_TRACE(width);
    Scene scene;
    scene.blocks = {make_block(width, 2 * width, 2500)};
    scene.initial = {{0.3}, {0}};
    scene.friction.assign(scene.blocks.size(), 5);
    scene.duration = 0.1;
    const Parameters parameters = engine->tuned_parameters();
    const Trajectory motion = run(*engine, set_up(scene, 1e-3, parameters), parameters, true);
    const double angle = motion.angles.back();
    const double drop = width * std::cos(angle) + width / 2 * std::sin(angle) - motion.bodies.back().y;
    EXPECT_NEAR(drop / (std::cos(angle) + std::sin(angle) - 1), 0.015, 0.0015);
  }
}

}  // namespace
}  // namespace rockstack
