// What is said of ammo.js (engines/web/ammo/page.md) beside the compiled Bullet.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/engines/bare.hpp"
#include "tests/engines/findings/draws.hpp"
#include "tests/engines/findings/web_engines.hpp"

namespace rockstack {
namespace {

/// A scene, and the same with one number moved to the next of 32 bits.
struct LastBit {
  Scene scene, next;
};

void to_next(double& value) {
  value = std::nextafter(static_cast<float>(value), 100.0F);
}

/// A block whose corner slides as it rocks; three that slide on each other, on ground that jerks; and a squat
/// block that falls back on one at rest, where friction is more than Bullet has.
std::vector<LastBit> last_bits() {
  Scene rocks = slender_block(0.4);
  rocks.law = Law::unilateral;
  rocks.blocks = {make_block(1, 2, 2500)};
  rocks.friction = {0.2};
  Scene slides = rocks;
  slides.blocks.assign(3, make_block(1, 0.5, 2500));
  slides.initial = {{0, 0, 0}, {0, 0, 0}};
  slides.friction = {0.3, 0.2, 0.11};
  slides.horizontal.pulse = Pulse{PulseShape::sine, 5, 0.3, 0, 1, 0};
  Scene falls = slender_block(0.4);
  falls.blocks = {make_block(1, 1, 2500), make_block(1, 0.8, 2500)};
  falls.initial = {{0, 0.2}, {0, 0}};
  std::vector<LastBit> list{{rocks, rocks}, {slides, slides}, {falls, falls}};
  to_next(list[0].next.friction.back());
  to_next(list[1].next.friction.back());
  to_next(list[2].next.initial.angles.back());
  return list;
}

/// Bullet in single precision, compiled in version 3.24 and as WebAssembly in 3.26, with the same
/// settings.
struct BothBullets {
  const WorkerEngine* compiled = there("bullet-single:sequential-impulse");
  const WorkerEngine* web = there("ammo:sequential-impulse");

  bool there_are() const { return compiled != nullptr && web != nullptr; }

  void expect_the_same(const Scene& scene, double dt) const {
    const auto velocities = [&](const WorkerEngine& engine, const Parameters& parameters) {
      return simulate(engine, scene, dt, parameters).history.velocities;
    };
    EXPECT_EQ(velocities(*web, web->default_parameters()),
              velocities(*compiled, compiled->default_parameters()));
    EXPECT_EQ(velocities(*web, web->tuned_parameters()),
              velocities(*compiled, with(compiled->tuned_parameters(), {{"warmstartingFactor", 0.85}})));
  }
};

/// What compiles them, and the version, change no bit.
TEST(WebEngines, AmmoHasTheBitsOfCompiledBullet) {
  const BothBullets bullets;
  if (!bullets.there_are()) GTEST_SKIP() << "one of them is not there";
  Scene pair = slender_block(1);
  pair.blocks = {make_block(1.25, 1.25, 2500), make_block(1, 2.5, 2500)};
  pair.initial = {{0.15, 0.15}, {0, 0}};
  std::vector<Scene> scenes{slender_block(1), pair};
  for (const LastBit& one : last_bits()) scenes.push_back(one.scene);
  for (const Scene& scene : scenes)
    for (const double dt : {1e-3, 2.5e-4}) bullets.expect_the_same(scene, dt);
}

/// So the scenes above tell whether both are told the same coefficients and the same start.
TEST(WebEngines, BulletTellsTheLastBitOfWhatItIsTold) {
  const WorkerEngine* engine = BothBullets{}.compiled;
  if (engine == nullptr) GTEST_SKIP() << "Bullet is not there";
  for (const auto& [scene, next] : last_bits()) {
    const auto velocities = [&](const Scene& one) {
      return simulate(*engine, one, 1e-3, engine->default_parameters()).history.velocities;
    };
    EXPECT_NE(velocities(scene), velocities(next));
  }
}

/// Neither is the square of its root, as both are rounded to 32 bits.
TEST(WebEngines, AmmoHasAnyCoefficientToTheBit) {
  const BothBullets bullets;
  if (!bullets.there_are()) GTEST_SKIP() << "one of them is not there";
  for (const double friction : {0.5, 0.2}) {
    const auto square = [](float root) { return root * root; };
    const auto wanted = static_cast<float>(friction);
    EXPECT_NE(square(std::sqrt(wanted)), wanted);
    for (const std::size_t blocks : {1U, 3U}) {
      Scene scene = last_bits()[1].scene;
      scene.blocks.resize(blocks);
      scene.initial = {std::vector<double>(blocks), std::vector<double>(blocks)};
      scene.friction.assign(blocks, friction);
      bullets.expect_the_same(scene, 1e-3);
    }
  }
}

/// Its points have a call for the impulse that presses, and none for the two of friction, which Bullet's own
/// have as m_appliedImpulseLateral1 and 2.
TEST(WebEngines, AmmoTellsWhatPressesAndHasNoCallForWhatRubs) {
  const WorkerEngine* engine = BothBullets{}.web;
  if (engine == nullptr) GTEST_SKIP() << "ammo.js is not there";
  const Scene scene = block_held_by_friction();
  const double weight = scene.blocks[0].mass * scene.gravity;
  const std::vector<double> pressed = borne(*engine, scene, pressing);
  const std::size_t half = pressed.size() / 2;
  double mean = 0;
  for (std::size_t i = half; i < pressed.size(); ++i)
    mean += pressed[i] / static_cast<double>(pressed.size() - half);
  EXPECT_NEAR(mean, weight, 1e-2 * weight);
  EXPECT_EQ(borne(*engine, scene, rubbing).back(), 0);
}

}  // namespace
}  // namespace rockstack
