#include "analytic/scene/spring_rates.hpp"

#include <cmath>

namespace rockstack {
namespace {

/// The springs of one interface, both corners or the bed, and what names them in a scene file.
struct Foundation {
  const char* stiffness_key;
  const char* damping_key;
  double stiffness = 0, damping = 0;  ///< as given
  double whole = 0;                   ///< what a unit of them comes to in all: 2 corners, or the bed's length
  double across = 0, along = 0;       ///< tr M⁻¹K of that, a unit of stiffness
};

double at(const std::vector<double>& values, std::size_t k, double standard) {
  return values.empty() ? standard : values[k];
}

Foundation foundation_of(const Scene& scene, std::size_t k) {
  const CornerSprings& springs = scene.springs;
  const double half_width = interface_half_width(scene, static_cast<int>(k));
  const bool bed = std::isfinite(at(springs.bed_stiffness, k, INFINITY));
  Foundation result =
      bed ? Foundation{"contact.bed_stiffness", "contact.bed_damping", springs.bed_stiffness[k],
                       at(springs.bed_damping, k, 0), 2 * half_width}
          : Foundation{"contact.stiffness", "contact.damping", at(springs.stiffness, k, INFINITY),
                       at(springs.damping, k, 0), 2};
  // A bed's turning stiffness is a third of that of springs at its ends.
  const double reach = bed ? half_width / std::sqrt(3.0) : half_width;
  for (const std::size_t block : {k, k - 1}) {
    if (block >= scene.blocks.size()) continue;  // the ground
    const double across = spring_compliance(scene.blocks[block], reach, 0);
    result.across += result.whole * across;
    result.along +=
        result.whole * (spring_compliance(scene.blocks[block], reach, springs.tangential) - across);
  }
  return result;
}

std::string key_at(const char* key, std::size_t interface) {
  return std::string(key) + "." + std::to_string(interface + 1);
}

}  // namespace

double spring_compliance(const Block& block, double half_width, double tangential) {
  const double reach = half_width + std::abs(block.offset_x);
  const double rise = block.half_height + std::abs(block.offset_y);
  const double across = 1 / block.mass + reach * reach / block.inertia;
  const double along = 1 / block.mass + rise * rise / block.inertia;
  return across + tangential * along;
}

SpringRate fastest_spring_rate(const Scene& scene) {
  const std::vector<double> friction = friction_of(scene);
  double square = 0;
  double damped = 0;
  SpringRate swinging, dying, relaxing;  // `rate` is that of one interface here
  double across = 0, along = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const Foundation soft = foundation_of(scene, k);
    if (std::isinf(soft.stiffness)) continue;
    const double sum = soft.across + soft.along;
    square += soft.stiffness * sum;
    damped += soft.damping * sum;
    across += soft.stiffness * soft.across;
    along += soft.stiffness * soft.along;
    if (soft.stiffness * sum > swinging.rate)
      swinging = {soft.stiffness * sum, key_at(soft.stiffness_key, k), soft.stiffness};
    if (soft.damping * sum > dying.rate)
      dying = {soft.damping * sum, key_at(soft.damping_key, k), soft.damping};
    const bool slides = friction[k] > 0 && friction[k] < largest_friction;
    if (slides && soft.damping > 0 && soft.stiffness / soft.damping > relaxing.rate)
      relaxing = {soft.stiffness / soft.damping, key_at(soft.damping_key, k), soft.damping};
  }
  swinging.rate = std::sqrt(square);
  dying.rate = damped;
  SpringRate& fastest = swinging.rate > dying.rate ? swinging : dying;
  if (along > across && scene.springs.tangential > 1) {
    fastest.key = "contact.tangential";
    fastest.value = scene.springs.tangential;
  }
  return relaxing.rate > fastest.rate ? relaxing : fastest;
}

}  // namespace rockstack
