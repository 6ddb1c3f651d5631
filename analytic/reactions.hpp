#pragma once

#include "analytic/dynamics.hpp"

namespace rockstack {

/// What each interface carries from the block below to the block above, per interface: forces in N and
/// moments in N·m, or impulses in N·s and N·m·s.
template <class Real>
struct Reactions {
  Vector<Real> normal;      ///< along the normal of the face, pushing positive
  Vector<Real> tangential;  ///< along the face, to the right positive
  Vector<Real> moment;      ///< clockwise, about the pivot, or about the middle where closed
};

/// Newton–Euler from the top down: what has to act for the blocks to move by `change` more than they freely
/// would.
template <class Real>
Reactions<Real> reactions(const Model<Real>& model, const Chain<Real>& chain,
                          const Vector<Real>& relative_angles, const Motion<Real>& change) {
  using std::cos;
  using std::sin;
  const Stack<Real>& stack = model.stack;
  const int size = stack.size();
  const bool upright = model.equations == Equations::linear;
  const Vector<Real> angles = absolute<Real>(relative_angles);
  Reactions<Real> result{Vector<Real>(size), Vector<Real>(size), Vector<Real>(size)};
  Point<Real> force = Point<Real>::Zero();
  Real moment = 0;
  for (int k = size - 1; k >= 0; --k) {
    const Point<Real> own = stack.mass[k] * change.centre.col(k);
    moment += stack.inertia[k] * change.rotation[k] + quarter_turned<Real>(chain.arms.col(k)).dot(own) +
              quarter_turned<Real>(chain.links.col(k)).dot(force);
    force += own;
    // The face is the lower block's, or the upper one's where that overhangs and rests on the lower one's
    // corner.
    const int face = stack.overhangs[static_cast<std::size_t>(k)] ? k : k - 1;
    const Real tilt = upright || face < 0 ? Real(0) : angles[face];
    const Real cosine = cos(tilt);
    const Real sine = sin(tilt);
    result.normal[k] = force.x() * sine + force.y() * cosine;
    result.tangential[k] = force.x() * cosine - force.y() * sine;
    result.moment[k] = moment;
  }
  return result;
}

/// How far the centre of pressure of a closed interface is from either end, times the normal force: N (w − x)
/// and N (w + x), N·m. The interface opens about an end where the value for that end turns negative; so it
/// does where it would have to pull.
template <class Real>
struct Margins {
  Real right;
  Real left;
};

template <class Real>
Margins<Real> margins(const Stack<Real>& stack, const Reactions<Real>& reaction, int interface) {
  const Real push = reaction.normal[interface] * stack.half_width[interface];
  return {push + reaction.moment[interface], push - reaction.moment[interface]};
}

}  // namespace rockstack
