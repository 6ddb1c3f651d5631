#include "analytic/scene/scene.hpp"

#include <algorithm>
#include <numbers>

namespace rockstack {

Block make_block(double width, double height, double density) {
  const double mass = density * width * height;
  return {width / 2, height / 2, mass, rectangle_inertia(mass, width / 2, height / 2)};
}

double interface_half_width(const Scene& scene, int interface) {
  const auto k = static_cast<std::size_t>(interface);
  const double own = scene.blocks[k].half_width;
  return k == 0 ? own : std::min(own, scene.blocks[k - 1].half_width);
}

double corner_rise(const Scene& scene, int interface, double angle) {
  const double own = scene.blocks[static_cast<std::size_t>(interface)].half_width;
  return (own + interface_half_width(scene, interface)) *
         std::sin(std::min(std::abs(angle), 0.5 * std::numbers::pi));
}

double stack_height(const Scene& scene) {
  double height = 0;
  for (const Block& block : scene.blocks) height += 2 * block.half_height;
  return height;
}

double slenderness(const Scene& scene, int block) {
  return std::max(balance_angle(scene, block, 1), balance_angle(scene, block, -1));
}

double balance_angle(const Scene& scene, int block, int side) {
  const Block& own = scene.blocks[block];
  return std::atan2(interface_half_width(scene, block) - side * own.offset_x, own.half_height + own.offset_y);
}

double toppling_angle(const Scene& scene, int block) {
  constexpr double on_its_side = 0.5 * std::numbers::pi, before = 0.02;
  const double level = slenderness(scene, block);
  const double uphill = std::min(level + std::abs(scene.inclination), on_its_side - before);
  return 0.5 * (std::max(level, uphill) + on_its_side);
}

}  // namespace rockstack
