#pragma once

#include "analytic/unilateral/contact/contact_laws.hpp"

namespace rockstack {

/// Adds slip velocities of blocks that touch to those of all that is above.
template <class Real>
void add_slips(const ContactModel<Real>& stack, const std::vector<double>& slip_velocities,
               ContactState<Real>& state) {
  Pose<Real> carried;
  for (std::size_t k = 0; k < slip_velocities.size(); ++k) {
    Joint<Real>& joint = state.joints[k];
    const Real slip = joint.touches() ? slip_velocities[k] : 0;
    joint.slip = (slip > 0) - (slip < 0);
    meet_face(stack, k, joint);
    const Real angle = pose_of(state.bodies.pose, stack.held_point(k, joint).face).angle;
    carried.x += slip * cos(angle);
    carried.y -= slip * sin(angle);
    state.bodies.velocity[k].x += carried.x;
    state.bodies.velocity[k].y += carried.y;
  }
}

/// Moves a block off its face, and gives its centre a velocity in a frame that goes with what is below.
template <class Real>
void lift(const ContactModel<Real>& stack, int block, const Real& gap, const Point<Real>& velocity,
          ContactState<Real>& state) {
  const CornerOnFace<Real> held = stack.held_point(block, state.joints[block]);
  const Point<Real> off = turned<Real>({Real(0), gap}, pose_of(state.bodies.pose, held.face).angle);
  const Pose<Real> below = pose_of(state.bodies.pose, block - 1);
  const Pose<Real> below_rate = pose_of(state.bodies.velocity, block - 1);
  Pose<Real>& at = state.bodies.pose[block];
  Pose<Real>& rate = state.bodies.velocity[block];
  at.x += off.x();
  at.y += off.y();
  const Point<Real> change = quarter_turned<Real>({at.x - below.x, at.y - below.y}) * below_rate.angle +
                             turned<Real>(velocity, below.angle);
  rate.x = below_rate.x + change.x();
  rate.y = below_rate.y + change.y();
  state.joints[block] = {.touch = Contact::apart, .offset = state.joints[block].offset};
}

/// The initial state of a scene: blocks touch as they lean, or as they are about to, or start above.
template <class Real>
ContactState<Real> initial_contacts(const ContactModel<Real>& stack, const InitialState& initial) {
  const std::size_t size = stack.blocks.size();
  const auto given = [&](std::vector<double> values) {
    values.resize(size, 0);
    return values;
  };
  const std::vector<double> offsets = given(initial.offsets), gaps = given(initial.gaps);
  const std::vector<double> slips = given(initial.slip_velocities), rises = given(initial.gap_velocities);
  ContactState<Real> state{{Poses<Real>(size), Poses<Real>(size)}, Joints<Real>(size)};
  double below = 0, below_rate = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const double angle = initial.angles[k], rate = initial.velocities[k];
    // What falls flat may turn as it does.
    const double deciding = angle != below || gaps[k] > 0 ? angle - below : rate - below_rate;
    Joint<Real>& joint = state.joints[k];
    joint.touch = contact_of((deciding > 0) - (deciding < 0));
    joint.offset = offsets[k];
    joint.corner_below = joint.pivots() && corner_is_below<Real>(stack, k, joint.offset, joint.side());
    state.bodies.pose[k].angle = below = angle;
    state.bodies.velocity[k].angle = below_rate = rate;
  }
  for (int k = 0; k < stack.size(); ++k) {
    place_upper<Real>(stack, state.joints[k], k, 0, state.bodies);
    if (gaps[k] == 0) continue;
    state.bodies.velocity[k].angle = initial.velocities[k];
    lift<Real>(stack, k, gaps[k], {Real(slips[k]), Real(rises[k])}, state);
  }
  add_slips(stack, slips, state);
  return state;
}

}  // namespace rockstack
