#include "tests/analytic/extremes/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/analytic/solver/stacks.hpp"
#include "tests/analytic/unilateral/scenes.hpp"

namespace rockstack::testing {
namespace {

/// 10 to a power drawn evenly.
double decades(Draw& draw, double low, double high) {
  return std::pow(10, draw.between(low, high));
}

double drawn_slenderness(Draw& draw) {
  return 0.02 * std::pow(1.5 / 0.02, draw.between(0, 1));
}

int drawn_size(Draw& draw) {
  const int group = draw.below(40);
  return group < 10 ? 1 : group < 26 ? 2 : group < 39 ? 3 + draw.below(3) : 6 + draw.below(15);
}

/// Sizes within a decade of each other or anywhere; widths that come as they do or are all equal, or blocks
/// that are; masses by volume, or over six decades, or a million times the base's and by volume in turn.
std::vector<Block> drawn_blocks(Draw& draw, int size) {
  const int shapes = draw.below(4);
  const int masses = draw.below(4);
  const double scale = decades(draw, -3, 2) / 2;
  const double range = draw.below(3) == 0 ? 5 : 0.5;
  const double towards = draw.coin() ? 6 : -6;
  std::vector<Block> blocks;
  for (int k = 0; k < size; ++k) {
    if (shapes == 3 && k > 0) {
      blocks.push_back(blocks.front());
    } else {
      const double shape = std::tan(drawn_slenderness(draw));
      double height = std::clamp(scale * decades(draw, -range, range), 0.5e-3, 50.0);
      if (shapes == 0 && k > 0) height = blocks.front().half_width / shape;
      const double width = height * shape;
      blocks.push_back({width, height, 2500 * width * height, 0});
    }
    Block& block = blocks.back();
    if (masses == 1 && k > 0) block.mass = blocks.front().mass * decades(draw, 0, towards);
    if (masses == 2 && k > 0 && draw.coin()) block.mass = blocks.front().mass * std::pow(10, towards);
    block.inertia = rectangle_inertia(block.mass, block.half_width, block.half_height);
  }
  return blocks;
}

/// The angle at which a block's centre stands over its pivot, on the block below.
double unstable_balance(const Scene& scene, std::size_t block) {
  return std::atan2(interface_half_width(scene, static_cast<int>(block)), scene.blocks[block].half_height);
}

void release(Draw& draw, Scene& scene, double rate) {
  const std::size_t size = scene.blocks.size();
  scene.initial = {std::vector<double>(size, 0), std::vector<double>(size, 0)};
  const int kind = draw.below(6);
  if (kind == 0) return;
  const double side = draw.coin() ? 1 : -1;
  if (kind == 1) scene.initial.angles.assign(size, side * 1e-9);
  if (kind == 2) {
    const auto leaning = static_cast<std::size_t>(draw.below(static_cast<int>(size)));
    const double angle = side * (unstable_balance(scene, leaning) - 1e-9);
    for (std::size_t k = leaning; k < size; ++k)
      if (std::abs(angle) < toppling_angle(scene, static_cast<int>(k))) scene.initial.angles[k] = angle;
  }
  if (kind > 2) {
    double below = 0;
    for (std::size_t k = 0; k < size; ++k) {
      double angle = draw.below(3) == 0 ? below : draw.between(-0.95, 0.95) * unstable_balance(scene, k);
      if (std::abs(angle) >= toppling_angle(scene, static_cast<int>(k))) angle = 0;
      scene.initial.angles[k] = below = angle;
    }
  }
  if (kind > 3) {
    const double speed = rate * decades(draw, -6, 0);
    for (double& velocity : scene.initial.velocities) velocity = speed * draw.between(-1, 1);
  }
}

GroundMotion drawn_pulse(Draw& draw, double strength, double rate) {
  GroundMotion motion;
  motion.pulse = Pulse{.shape = static_cast<PulseShape>(draw.below(6)),
                       .amplitude = strength,
                       .period = decades(draw, -3, 2),
                       .start = draw.below(3) == 0 ? 0.0 : draw.between(0, 1) / rate,
                       .cycles = draw.between(1.1, 30),
                       .phase = draw.between(0, 2 * std::numbers::pi)};
  return motion;
}

/// Noise, steps, or a sine that the interval may sample badly.
GroundMotion drawn_record(Draw& draw, double strength) {
  GroundMotion motion;
  motion.interval = decades(draw, -5, -1);
  const int kind = draw.below(3);
  const int count = 2 + draw.below(400);
  const int hold = 1 + draw.below(20);
  const double turn = 2 * std::numbers::pi * motion.interval * decades(draw, -2, 3);
  double level = 0;
  for (int i = 0; i < count; ++i) {
    if (kind == 0) level = draw.between(-strength, strength);
    if (kind == 1 && i % hold == 0) level = strength * (draw.below(3) - 1);
    if (kind == 2) level = strength * std::sin(turn * i);
    motion.samples.push_back(level);
  }
  return motion;
}

GroundMotion drawn_motion(Draw& draw, double strength, double rate) {
  const int kind = draw.below(3);
  if (kind == 0) return {};
  return kind == 1 ? drawn_pulse(draw, strength, rate) : drawn_record(draw, strength);
}

}  // namespace

Scene extreme_scene(std::uint64_t seed) {
  Draw draw(seed);
  Scene scene;
  scene.blocks = drawn_blocks(draw, drawn_size(draw));
  scene.gravity = draw.coin() ? 9.81 : decades(draw, -2, 3);
  scene.law = draw.coin() ? Law::paper : Law::consistent;
  scene.equations = draw.below(8) == 0 ? Equations::linear : Equations::nonlinear;
  double height = 0;
  for (const Block& block : scene.blocks) height += 2 * block.half_height;
  const double rate = std::sqrt(scene.gravity / height);
  release(draw, scene, rate);
  if (draw.below(3) != 0) {
    scene.horizontal = drawn_motion(draw, scene.gravity * decades(draw, -6, 2), rate);
    scene.vertical =
        draw.coin() ? drawn_motion(draw, scene.gravity * decades(draw, -6, 2), rate) : GroundMotion{};
  }
  scene.duration = (draw.below(40) == 0 ? 100 : 5) * decades(draw, -1, 0) / rate;
  return scene;
}

Scene slippery_extreme_scene(std::uint64_t seed) {
  Scene scene = slippery(extreme_scene(seed), seed);
  scene.equations = Equations::nonlinear;
  return scene;
}

Scene unequal_column(std::uint64_t seed) {
  Draw draw(seed);
  Scene scene;
  const auto size = 2 + static_cast<std::size_t>(draw.below(19));
  const int widths = draw.below(3);
  double width = draw.between(0.8, 1.2), height = 0;
  for (std::size_t k = 0; k < size; ++k) {
    if (widths == 0 && draw.coin()) width *= draw.between(0.92, 1);
    if (widths == 1) width = draw.between(0.6, 1.2);
    if (widths == 2 && draw.coin()) width *= draw.between(0.95, 1.05);
    scene.blocks.push_back(make_block(width, draw.between(0.4, 1.2), 2500));
    height += 2 * scene.blocks.back().half_height;
  }
  scene.duration = draw.between(1, 4);
  scene = with_friction(std::move(scene), draw.between(0.1, 1.5));
  if (draw.below(3) == 0)
    for (double& friction : scene.friction) friction = draw.between(0.1, 1.5);
  const double balance = 2 * scene.blocks.front().half_width / height;
  const double angle = (draw.coin() ? 1 : -1) * draw.between(0.1, 0.9) * balance;
  const int lean = draw.below(4);
  scene.initial = {std::vector<double>(size, angle), std::vector<double>(size, 0)};
  const std::size_t upright = lean == 1 ? static_cast<std::size_t>(draw.below(static_cast<int>(size))) : 0;
  for (std::size_t k = 0; k < size; ++k) {
    double& own = scene.initial.angles[k];
    if (k < upright) own = 0;
    if (lean == 2) own = angle * draw.between(-1, 1);
    if (lean == 3 && k > 0) own = draw.coin() ? scene.initial.angles[k - 1] : angle * draw.between(-1, 1);
  }
  return scene;
}

std::string features(const Scene& scene) {
  const auto range = [&](auto value) {
    double least = value(scene.blocks.front());
    double most = least;
    for (const Block& block : scene.blocks) {
      least = std::min(least, value(block));
      most = std::max(most, value(block));
    }
    return std::pair{least, most};
  };
  const auto [light, heavy] = range([](const Block& block) { return block.mass; });
  const auto [low, high] = range([](const Block& block) { return 2 * block.half_height; });
  const auto [slender, squat] =
      range([](const Block& block) { return std::atan(block.half_width / block.half_height); });
  std::ostringstream text;
  text << scene.blocks.size() << " blocks, masses 1:" << heavy / light << ", heights " << low << "…" << high
       << " m, slenderness " << slender << "…" << squat << ", gravity " << scene.gravity << ", "
       << scene.duration << " s, " << name(scene.law) << ' '
       << (scene.equations == Equations::linear ? "linear" : "nonlinear") << ", ground ("
       << (scene.horizontal.pulse ? "pulse " : "record ") << peak(scene.horizontal) / scene.gravity << ", "
       << (scene.vertical.pulse ? "pulse " : "record ") << peak(scene.vertical) / scene.gravity << ") g";
  return text.str();
}

}  // namespace rockstack::testing
