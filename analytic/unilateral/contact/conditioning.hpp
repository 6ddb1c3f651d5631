#pragma once

#include <Eigen/LU>
#include <stdexcept>

#include "analytic/unilateral/contact/mode_response.hpp"

namespace rockstack {

/// A rounding over what it makes of contact forces, in shares of them, of a stack that stands and sticks: the
/// reciprocal condition number, by largest rows' sums, of what forces do, each in the unit of its own effect.
template <class Real>
Real conditioning(const BasicFrictionStack<Real>& stack) {
  Joints<Real> joints(stack.blocks.size());
  BasicBodies<Real> bodies{Placements<Real>(joints.size()), Placements<Real>(joints.size())};
  place(stack.blocks, joints, bodies);
  const SquareMatrix<Real> effects = held_by(stack, joints, bodies, Sought::velocities).matrix(stack);
  const BasicFreeVector<Real> units = effects.diagonal().cwiseSqrt().cwiseInverse();
  const SquareMatrix<Real> scaled = units.asDiagonal() * effects * units.asDiagonal();
  const SquareMatrix<Real> inverse = Eigen::PartialPivLU<SquareMatrix<Real>>(scaled).inverse();
  const auto size = [](const SquareMatrix<Real>& matrix) {
    return matrix.cwiseAbs().rowwise().sum().maxCoeff();
  };
  return 1 / (size(scaled) * size(inverse));
}

/// @throws std::domain_error where masses or sizes are so far apart that contact forces keep fewer than six
/// digits.
template <class Real>
void require_digits(const BasicFrictionStack<Real>& stack) {
  if (!(conditioning(stack) >= 1'000'000 * std::numeric_limits<Real>::epsilon()))
    throw std::domain_error(
        "block masses or sizes are too far apart: rounding would leave contact forces fewer than six digits");
}

}  // namespace rockstack
