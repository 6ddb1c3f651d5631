#include "tests/analytic/unilateral/springs/random_springs.hpp"

#include <cmath>
#include <limits>

#include "tests/analytic/solver/stacks.hpp"

namespace rockstack::testing {

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
  CornerSprings& springs = scene.springs;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const double half_width = interface_half_width(scene, static_cast<int>(k));
    springs.bed_stiffness.push_back(springs.stiffness[k] / half_width);
    springs.bed_damping.push_back(springs.damping[k] / half_width);
  }
  springs.stiffness.clear();
  springs.damping.clear();
  return scene;
}

}  // namespace rockstack::testing
