#include "analytic/unilateral/contact_laws.hpp"

#include <algorithm>
#include <utility>

namespace rockstack {
namespace {

/// What the joint of one interface can become.
std::vector<Joint> choices(const FrictionStack& stack, int interface, const Joint& joint, Sought sought) {
  if (!joint.touches()) return {joint};
  Joint apart = joint;
  apart.touch = Touch::apart;
  apart.slip = 0;
  std::vector<Joint> result{apart};
  for (const Touch touch : {Touch::left, Touch::flat, Touch::right}) {
    if (joint.pivots() && touch != joint.touch) continue;
    for (const int slip : {-1, 0, 1}) {
      if (slip_before(joint, sought) != 0 && slip != joint.slip) continue;
      Joint next = joint;
      next.touch = touch;
      next.slip = slip;
      if (joint.touch == Touch::flat && next.pivots())
        next.corner_below = corner_is_below(stack, interface, joint.offset, next.side());
      result.push_back(next);
    }
  }
  return result;
}

}  // namespace

bool obeys(const FrictionStack& stack, const std::vector<Joint>& joints, const std::vector<Joint>& mode,
           const Bodies& bodies, const FreeVector& free, Sought sought) {
  const ModeResponse response = respond(stack, mode, bodies, free, sought);
  double size = 0;
  for (const ContactForce& force : response.forces)
    size = std::max({size, std::abs(force.normal), std::abs(force.tangential)});
  const double motion_rounding = 1e-9 * free.lpNorm<Eigen::Infinity>();
  const double force_rounding = 1e-9 * size;
  for (const TouchingPoints& contact : touching_points(stack, joints, bodies, sought)) {
    const auto index = static_cast<std::size_t>(contact.interface);
    const Joint& joint = mode[index];
    const ContactForce& force = response.forces[index];
    for (std::size_t i = 0; i < contact.normals.size(); ++i)
      if (contact.normals[i].dot(response.motion) + contact.normal_biases[i] < -motion_rounding) return false;
    if (force.normal < -force_rounding) return false;
    if (std::abs(force.tangential) > contact.friction * force.normal + force_rounding) return false;
    if (joint.touch == Touch::flat) {
      const Overlap ends = overlap(stack, contact.interface, joint.offset);
      if (force.normal * ends.right + force.moment < -force_rounding * (ends.right - ends.left)) return false;
      if (-force.moment - force.normal * ends.left < -force_rounding * (ends.right - ends.left)) return false;
    }
    const double slip = contact.slip.dot(response.motion) + contact.slip_bias;
    if (joint.slip != 0 && slip_before(joints[index], sought) == 0 && slip * joint.slip < -motion_rounding)
      return false;
  }
  return true;
}

std::vector<std::vector<Joint>> modes_that_obey(const FrictionStack& stack, const std::vector<Joint>& joints,
                                                const Bodies& bodies, const FreeVector& free, Sought sought,
                                                std::size_t most) {
  std::vector<std::vector<Joint>> modes{{}};
  for (std::size_t k = 0; k < joints.size(); ++k) {
    std::vector<std::vector<Joint>> longer;
    for (const Joint& choice : choices(stack, static_cast<int>(k), joints[k], sought)) {
      for (const auto& mode : modes) {
        longer.push_back(mode);
        longer.back().push_back(choice);
      }
    }
    if (longer.size() > most) return {};
    modes = std::move(longer);
  }
  std::erase_if(modes, [&](const auto& mode) { return !obeys(stack, joints, mode, bodies, free, sought); });
  return modes;
}

}  // namespace rockstack
