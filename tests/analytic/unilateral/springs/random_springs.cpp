#include "tests/analytic/unilateral/springs/random_springs.hpp"

#include <cmath>
#include <limits>

#include "tests/analytic/solver/stacks.hpp"

namespace rockstack::testing {
namespace {

/// Makes beds that are as stiff in all as the two springs of an interface.
void put_on_beds(Scene& scene) {
  CornerSprings& springs = scene.springs;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const double half_width = interface_half_width(scene, static_cast<int>(k));
    springs.bed_stiffness.push_back(springs.stiffness[k] / half_width);
    springs.bed_damping.push_back(springs.damping[k] / half_width);
  }
  springs.stiffness.clear();
  springs.damping.clear();
}

}  // namespace

Scene springy_scene(std::uint64_t seed) {
  Scene scene = seeded_scene(seed);
  scene.law = Law::compliant;
  Draw draw(seed + 91000);
  double mass = 0;
  for (const Block& block : scene.blocks) mass += block.mass;
  const auto size = static_cast<int>(scene.blocks.size());
  const int soft = draw.below(size);
  const bool slips = draw.below(3) > 0;
  for (int k = 0; k < size; ++k) {
    const bool rigid = k != soft && draw.below(3) == 0;
    const double stiffness = mass / 1000 * std::pow(10, draw.between(5, 9));
    const double ratio = std::pow(10, draw.between(-2, 0));
    scene.springs.stiffness.push_back(rigid ? std::numeric_limits<double>::infinity() : stiffness);
    scene.springs.damping.push_back(draw.below(4) == 0 ? 0 : 2 * ratio * std::sqrt(stiffness * mass));
    if (slips) scene.friction.push_back(draw.between(0.2, 1));
  }
  scene.springs.tangential = draw.between(0.3, 1);
  scene.duration = std::min(scene.duration, 3.0);
  return scene;
}

Scene bedded_scene(std::uint64_t seed) {
  Scene scene = springy_scene(seed);
  put_on_beds(scene);
  return scene;
}

Scene soft_scene(std::uint64_t seed, bool beds) {
  Draw draw(seed + 4000);
  Scene scene = random_scene(draw, 1 + draw.below(3), false);
  scene.law = Law::compliant;
  double mass = 0;
  for (const Block& block : scene.blocks) mass += block.mass;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const double stiffness = mass * std::pow(10, draw.between(2.5, 3.5));
    scene.springs.stiffness.push_back(stiffness);
    scene.springs.damping.push_back(draw.coin() ? 0 : draw.between(0.02, 0.5) * std::sqrt(stiffness * mass));
    scene.friction.push_back(draw.between(0.2, 0.8));
  }
  scene.springs.tangential = draw.between(0.4, 1);
  scene.initial.preloaded = false;
  scene.duration = 0.3;
  if (!beds) return scene;
  put_on_beds(scene);
  // What lies flat on a bed without load may not turn.
  const std::vector<double>& angles = scene.initial.angles;
  std::vector<double>& velocities = scene.initial.velocities;
  for (std::size_t k = 0; k < angles.size(); ++k)
    if (angles[k] == (k == 0 ? 0 : angles[k - 1])) velocities[k] = k == 0 ? 0 : velocities[k - 1];
  return scene;
}

double energy_with_losses(const Scene& scene, const Sample& sample) {
  double sum = energy(scene, sample.bodies);
  for (const auto& springs : sample.springs) sum += springs.elastic + springs.damped + springs.rubbed;
  return sum;
}

double weight_times_height(const Scene& scene) {
  double below = 0;
  double sum = 0;
  for (const Block& block : scene.blocks) {
    sum += block.mass * scene.gravity * (below + block.half_height);
    below += 2 * block.half_height;
  }
  return sum;
}

}  // namespace rockstack::testing
