#include "comparisons/measures/metrics/contact/corner_springs.hpp"

#include <algorithm>
#include <cmath>

#include "analytic/scene/spring_checks.hpp"

namespace rockstack {
namespace {

/// tr M⁻¹K for unit springs at both ends of each interface.
double unit_trace(const Scene& scene) {
  double sum = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const double half_width = interface_half_width(scene, static_cast<int>(k));
    sum += 2 * spring_compliance(scene.blocks[k], half_width, scene.springs.tangential);
    if (k > 0) sum += 2 * spring_compliance(scene.blocks[k - 1], half_width, scene.springs.tangential);
  }
  return sum;
}

}  // namespace

double damping_ratio(const CornerSpring& spring, const Block& block) {
  const double inverse_mass = 1 / block.mass + block.half_width * block.half_width / block.inertia;
  return spring.damping / 2 * std::sqrt(inverse_mass / spring.stiffness);
}

double restitution_of(double damping_ratio) {
  const double z = damping_ratio, under = 1 - z * z;
  if (std::abs(under) < 1e-9) return std::exp(-2.0);
  const double s = std::sqrt(std::abs(under));
  const double time = under > 0 ? std::acos(-1.0) - std::atan2(2 * z * s, 1 - 2 * z * z)
                                : 2 * std::log(z + s);  // (ζ + s)/(ζ − s) = (ζ + s)², without cancelling
  return std::exp(-z / s * time);
}

Scene with_rigid_contacts(Scene scene, const std::vector<double>& friction) {
  scene.law = Law::unilateral;
  scene.equations = Equations::nonlinear;
  scene.friction = friction;
  scene.springs = {};
  scene.initial.preloaded = true;
  return scene;
}

Scene with_springs(Scene scene, const std::vector<double>& friction, const CornerSpring& spring) {
  const double tangential = scene.springs.tangential;
  scene = with_rigid_contacts(std::move(scene), friction);
  scene.law = Law::compliant;
  scene.springs.stiffness.assign(scene.blocks.size(), spring.stiffness);
  scene.springs.damping.assign(scene.blocks.size(), spring.damping);
  scene.springs.tangential = tangential;
  scene.initial.preloaded = false;
  return scene;
}

double spring_factor(const Scene& scene, const CornerSpring& spring, double most) {
  const double per_rate = scene.duration / steps_per_rate / most, trace = unit_trace(scene);
  const double damped = trace * spring.damping * per_rate;
  const double swinging = trace * spring.stiffness * per_rate * per_rate;
  return std::max({1.0, damped, swinging});
}

}  // namespace rockstack
