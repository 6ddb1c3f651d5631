#pragma once

#include "analytic/unilateral/contact/contact_laws.hpp"

namespace rockstack {

/// Where blocks are, how fast they move, and what they touch.
template <class Real>
struct ContactState {
  Bodies<Real> bodies;
  Joints<Real> joints;
};

/// Adds slip velocities to those of all that is above.
template <class Real>
void add_slips(const ContactModel<Real>& stack, const std::vector<double>& slip_velocities,
               ContactState<Real>& state) {
  using std::cos;
  using std::sin;
  Pose<Real> carried;
  for (std::size_t k = 0; k < slip_velocities.size(); ++k) {
    const Real slip = slip_velocities[k];
    Joint<Real>& joint = state.joints[k];
    joint.slip = (slip > 0) - (slip < 0);
    meet_face(stack, static_cast<int>(k), joint);
    const CornerOnFace<Real> point = stack.held_point(static_cast<int>(k), joint);
    const Real angle = pose_of(state.bodies.at, point.face).angle;
    carried.x += slip * cos(angle);
    carried.y -= slip * sin(angle);
    state.bodies.rate[k].x += carried.x;
    state.bodies.rate[k].y += carried.y;
  }
}

/// The initial state of a scene: blocks touch as they lean, or as they are about to.
template <class Real>
ContactState<Real> initial_contacts(const ContactModel<Real>& stack, const InitialState& initial) {
  const std::size_t size = stack.blocks.size();
  ContactState<Real> state{{Poses<Real>(size), Poses<Real>(size)}, Joints<Real>(size)};
  double below = 0;
  double below_rate = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const double angle = initial.angles[k];
    const double rate = initial.velocities[k];
    const double deciding = angle != below ? angle - below : rate - below_rate;
    Joint<Real>& joint = state.joints[k];
    joint.touch = deciding > 0 ? Touch::right : deciding < 0 ? Touch::left : Touch::flat;
    joint.corner_below = joint.pivots() && corner_is_below<Real>(stack, static_cast<int>(k), 0, joint.side());
    state.bodies.at[k].angle = below = angle;
    state.bodies.rate[k].angle = below_rate = rate;
  }
  place(stack, state.joints, state.bodies);
  std::vector<double> slips = initial.slip_velocities;
  slips.resize(size, 0);
  add_slips(stack, slips, state);
  return state;
}

}  // namespace rockstack
