#include "analytic/unilateral/contact_energy.hpp"

namespace rockstack {

double energy(const Scene& scene, const Bodies& bodies) {
  const Gravity gravity = gravity_of(scene);
  double sum = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const Block& block = scene.blocks[k];
    const BodyPlacement& rate = bodies.rate[k];
    sum += block.mass * (rate.x * rate.x + rate.y * rate.y) / 2 +
           block.inertia * rate.angle * rate.angle / 2 +
           block.mass * (gravity.across * bodies.at[k].y - gravity.along * bodies.at[k].x);
  }
  return sum;
}

}  // namespace rockstack
