#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
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

/// A rounding of places over what it makes of the smallest half-size, in shares of that.
template <class Real>
Real fineness(const BasicFrictionStack<Real>& stack) {
  Real height = 0;
  Real smallest = std::numeric_limits<Real>::infinity();
  for (const Block& block : stack.blocks) {
    height += 2 * block.half_height;
    smallest = std::min<Real>(smallest, std::min(block.half_width, block.half_height));
  }
  return smallest / height;
}

/// Whether contact forces and sizes keep so many digits of a number type.
template <class Real>
bool keeps_digits(const BasicFrictionStack<Real>& stack, int digits) {
  using std::pow;
  return std::min(conditioning(stack), fineness(stack)) >=
         pow(Real(10), digits) * std::numeric_limits<Real>::epsilon();
}

/// @throws std::domain_error where masses or sizes are so far apart that contact forces or sizes keep fewer
/// than six digits.
template <class Real>
void require_digits(const BasicFrictionStack<Real>& stack) {
  if (!keeps_digits(stack, 6))
    throw std::domain_error(
        "block masses or sizes are too far apart: rounding would leave contact forces fewer than six digits");
}

}  // namespace rockstack
