#pragma once

#include "analytic/mechanics/dynamics.hpp"
#include "analytic/scene/lists.hpp"
#include "analytic/steps/block_series.hpp"

namespace rockstack {

/// A push, with its arm from the pivot of its block, in that one's frame, m.
template <class Real>
struct PushArm {
  std::size_t block;
  PlaneVector<Real> arm, direction;
};

/// Arms of a model's pushes; `sides`: signs of contacts.
template <class Real, int N>
std::vector<PushArm<Real>> push_arms(const Model<Real, N>& model, const PerBlock<Real, N>& sides) {
  const Stack<Real, N>& stack = model.stack;
  return mapped(model.pushes, [&](const PushPoint<Real>& push) {
    const int k = push.block;
    const Real pivot = sides[static_cast<std::size_t>(k)] * stack.half_width[k];
    return PushArm<Real>{static_cast<std::size_t>(k),
                         {push.arm.x() + stack.centre_x[k] - pivot, push.arm.y() + stack.centre_y[k]},
                         {push.direction.x(), push.direction.y()}};
  });
}

/// Order n of the moment of a force of that size and direction at the end of a vector (x, y) of a block's
/// frame about its beginning.
template <class Real>
Real moment_of(const BlockSeries<Real>& block, const Real& x, const Real& y, const Polynomial<Real>& size,
               const PlaneVector<Real>& direction, std::size_t n) {
  Real sum = 0;
  for (std::size_t m = 0; m < std::min(size.terms, n + 1); ++m)
    sum += size[m] * across(turned(block.direction[n - m], x, y), direction);
  return sum;
}

/// Takes order n of the moments of a push about all pivots from what the others leave.
template <class Real, int N, class Blocks>
void add_push_moments(const PushArm<Real>& push, const Polynomial<Real>& size,
                      const Linkage<Real, N>& linkage, const Blocks& blocks, std::size_t n,
                      PerBlock<Real, N>& moments) {
  Real sum = moment_of(blocks[push.block], push.arm.x, push.arm.y, size, push.direction, n);
  for (std::size_t k = push.block + 1; k-- > 0;) {
    if (k < push.block)
      sum += moment_of(blocks[k], linkage.link_x[k], linkage.link_y[k], size, push.direction, n);
    moments[k] -= sum;
  }
}

/// Takes order n of a push from the forces that blocks need of interfaces.
template <class Real, class Blocks>
void add_push_forces(const PushArm<Real>& push, const Polynomial<Real>& size, std::size_t n, Blocks& blocks) {
  for (std::size_t k = 0; k <= push.block; ++k)
    blocks[k].force[n] = blocks[k].force[n] + -coefficient(size, n) * push.direction;
}

}  // namespace rockstack
