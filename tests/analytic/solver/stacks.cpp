#include "tests/analytic/solver/stacks.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

namespace rockstack::testing {
namespace {

GroundMotion random_motion(Draw& draw, double strength) {
  GroundMotion motion;
  const int kind = draw.below(3);
  if (kind == 1) {
    motion.interval = draw.between(0.005, 0.02);
    for (int i = 0; i < 50; ++i) motion.samples.push_back(draw.between(-strength, strength));
  } else if (kind == 2) {
    motion.pulse = Pulse{.shape = static_cast<PulseShape>(draw.below(6)),
                         .amplitude = draw.between(-strength, strength),
                         .period = draw.between(0.05, 0.6),
                         .start = draw.between(0, 0.2),
                         .cycles = draw.between(1.1, 3),
                         .phase = draw.between(0, 2 * std::numbers::pi)};
  }
  return motion;
}

}  // namespace

Block block(double width, double height) {
  const double mass = 2500 * width * height;
  return {width / 2, height / 2, mass, rectangle_inertia(mass, width / 2, height / 2)};
}

Scene released(std::vector<Block> blocks, std::vector<double> angles, double duration) {
  Scene scene;
  scene.duration = duration;
  scene.initial.velocities.assign(blocks.size(), 0);
  scene.blocks = std::move(blocks);
  scene.initial.angles = std::move(angles);
  return scene;
}

Scene paper_example() {
  return released({block(1.25, 1.25), block(1.0, 2.5)}, {0.15, 0.15}, 5);
}

Scene random_stack(Draw& draw, int size) {
  std::vector<Block> blocks;
  for (int k = 0; k < size; ++k) {
    const double height = std::exp(draw.between(-1, 1));
    const double width = height * draw.between(0.1, 1.2);
    const double mass = std::pow(10, draw.between(-1.5, 1.5));
    blocks.push_back({width, height, mass, rectangle_inertia(mass, width, height)});
  }
  return released(std::move(blocks), std::vector<double>(static_cast<std::size_t>(size), 0), 1);
}

Scene random_scene(Draw& draw, int size, bool shaken) {
  Scene scene = random_stack(draw, size);
  scene.duration = draw.between(0.3, 0.9);
  scene.law = draw.coin() ? Law::paper : Law::consistent;
  double below = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const double balance = std::atan(scene.blocks[k].half_width / scene.blocks[k].half_height);
    double angle = draw.below(3) == 0 ? below : draw.between(-0.8, 0.8) * balance;
    if (std::abs(angle) >= 0.9 * toppling_angle(scene, static_cast<int>(k))) angle = 0;
    scene.initial.angles[k] = below = angle;
    if (draw.below(3) == 0) scene.initial.velocities[k] = draw.between(-1, 1);
  }
  if (!shaken) return scene;
  const double strength = 9.81 * draw.between(0.1, 2);
  scene.horizontal.interval = 0.01;
  for (int i = 0; i < 60; ++i) scene.horizontal.samples.push_back(draw.between(-strength, strength));
  if (draw.coin()) return scene;
  scene.vertical.interval = 0.013;
  for (int i = 0; i < 50; ++i) scene.vertical.samples.push_back(draw.between(-strength, strength) / 3);
  return scene;
}

void shake(Draw& draw, Scene& scene) {
  const double strength = scene.gravity * draw.between(0.1, 2);
  scene.horizontal = random_motion(draw, strength);
  scene.vertical = random_motion(draw, strength / 3);
}

std::string listing(const History& history) {
  std::ostringstream text;
  text.precision(17);
  for (const Event& event : history.events) {
    text << event.time << ' ' << name(event.kind) << ' ' << event.interface << ' ' << name(event.from) << "->"
         << name(event.to) << '\n';
  }
  return text.str();
}

Scene seeded_scene(std::uint64_t seed) {
  Draw draw(seed);
  Scene scene = random_scene(draw, 1 + draw.below(4), false);
  if (seed % 4 != 0) shake(draw, scene);
  return scene;
}

}  // namespace rockstack::testing
