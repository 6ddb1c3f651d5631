#include "analytic/scene/wall.hpp"

#include <algorithm>

namespace rockstack {

double wall_restitution(const Scene& scene) {
  if (scene.wall.restitution) return *scene.wall.restitution;
  const Block& block = scene.blocks.front();
  const double wide = block.half_width * block.half_width, high = block.half_height * block.half_height;
  const double about_corner = block.inertia + block.mass * (wide + high);
  const double at_ground = (block.inertia + block.mass * (high - wide)) / about_corner;
  const double at_wall = (block.inertia + block.mass * (wide - high)) / about_corner;
  return at_ground * at_ground * std::max(0.0, -at_wall);
}

}  // namespace rockstack
