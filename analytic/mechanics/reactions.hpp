#pragma once

#include "analytic/mechanics/dynamics.hpp"

namespace rockstack {

/// What each interface carries from the block below to the block above, per interface: forces in N and
/// moments in N·m, or impulses in N·s and N·m·s.
template <class Real, int N = Eigen::Dynamic>
struct Reactions {
  Vector<Real, N> normal;      ///< along the normal of the face, pushing positive
  Vector<Real, N> tangential;  ///< along the face, to the right positive
  Vector<Real, N> moment;      ///< clockwise, about the pivot, or about the middle where closed
};

/// Newton–Euler from the top down: what has to act for the blocks to move by `change` more than they freely
/// would.
template <class Real, int N>
Reactions<Real, N> reactions(const Model<Real, N>& model, const Chain<Real, N>& chain,
                             const Directions<Real, N>& directions, const Motion<Real, N>& change) {
  const Stack<Real, N>& stack = model.stack;
  const int size = stack.size();
  const Vector<Real, N> zero = Vector<Real, N>::Zero(size);
  Reactions<Real, N> result{zero, zero, zero};
  Point<Real> force = Point<Real>::Zero();
  Real moment = 0;
  for (int k = size - 1; k >= 0; --k) {
    const Point<Real> own = stack.mass[k] * change.centre.col(k);
    moment += stack.inertia[k] * change.rotation[k] + quarter_turned<Real>(chain.arms.col(k)).dot(own) +
              quarter_turned<Real>(chain.links.col(k)).dot(force);
    force += own;
    const int along = face(stack, k);
    const Real cosine = along < 0 ? Real(1) : directions.cosine[along];
    const Real sine = along < 0 ? Real(0) : directions.sine[along];
    // Of small angles, what is of second order is left out.
    result.normal[k] = (stack.small_angles ? Real(0) : force.x() * sine) + force.y() * cosine;
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

template <class Real, int N>
Margins<Real> margins(const Stack<Real, N>& stack, const Reactions<Real, N>& reaction, int interface) {
  const Real push = reaction.normal[interface] * stack.half_width[interface];
  return {push + reaction.moment[interface], push - reaction.moment[interface]};
}

}  // namespace rockstack
