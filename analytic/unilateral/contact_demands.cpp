#include "analytic/unilateral/contact_demands.hpp"

#include <algorithm>
#include <cmath>

#include "analytic/polynomials/maximum.hpp"

namespace rockstack {
namespace {

/// Takes what one interface bears at one time into account. Where the normal force is `rounding` or less, it
/// is zero, and nothing rubs.
void note_bearing(Demand& demand, double normal, double tangential, double rounding, double time) {
  const bool bears = normal > rounding;
  if (const double pushed = bears ? normal : 0; pushed < demand.least_normal) {
    demand.least_normal = pushed;
    demand.least_normal_time = time;
  }
  if (const double ratio = bears ? std::abs(tangential) / normal : 0; ratio > demand.friction) {
    demand.friction = ratio;
    demand.friction_time = time;
  }
}

}  // namespace

ContactDemands::ContactDemands(const Scene& scene, std::size_t interfaces)
    : forces_(interfaces), impulses_(interfaces) {
  double mass = 0;
  double height = 0;
  for (const Block& block : scene.blocks) {
    mass += block.mass;
    height += 2 * block.half_height;
  }
  rounding_ = 1024 * std::numeric_limits<double>::epsilon() * mass * scene.gravity;
  negligible_impulse_ = 1e-6 * mass * std::sqrt(scene.gravity * height);
}

void ContactDemands::note_step(const std::vector<Joint>& joints, const ModeSeries& series, double end,
                               double start) {
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (!joints[k].touches()) {
      note_bearing(forces_[k], 0, 0, rounding_, start);
      continue;
    }
    ForceSeries force = series.forces[k];
    for (Series* part : {&force.normal, &force.tangential})
      for (double& coefficient : *part) coefficient *= series.force_unit;
    note_along(forces_[k], force, end, start, series.length);
  }
}

/// To rounding: where the normal force is least, and where ±T/N is largest. The latter is the ratio μ at
/// which the maximum of ±T − μN comes down to zero (Dinkelbach 1967, Management Science 13, 492–498).
void ContactDemands::note_along(Demand& demand, const ForceSeries& force, double end, double start,
                                double length) const {
  const auto note_at = [&](double s) {
    note_bearing(demand, value(force.normal, s), value(force.tangential, s), rounding_, start + s * length);
  };
  // Where normal · N + tangential · T passes `least` most.
  const auto note_maximum = [&](double normal, double tangential, double least, double slack) {
    Series sum;
    add(force.normal, normal, sum);
    add(force.tangential, tangential, sum);
    rescale(sum, end);
    if (const auto top = maximum(sum, least, slack)) note_at(top->s * end);
  };
  note_maximum(-1, 0, rounding_ - demand.least_normal, rounding_);
  for (const double side : {1.0, -1.0}) {
    for (double before = -1; demand.friction > before;) {
      before = demand.friction;
      const double negligible = rounding_ * (1 + before);
      note_maximum(-before, side, negligible, negligible);
    }
  }
}

void ContactDemands::note_impact(const std::vector<ContactForce>& impulses, double time) {
  for (std::size_t k = 0; k < impulses_.size(); ++k) {
    const ContactForce& impulse = impulses[k];
    if (impulse.normal > negligible_impulse_)
      note_bearing(impulses_[k], impulse.normal, impulse.tangential, negligible_impulse_, time);
  }
}

}  // namespace rockstack
