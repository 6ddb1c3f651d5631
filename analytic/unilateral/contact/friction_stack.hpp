#pragma once

#include <algorithm>
#include <utility>

#include "analytic/unilateral/contact/bodies.hpp"

namespace rockstack {

/// The stack that contacts hold, with the friction coefficient of each interface.
template <class Real>
struct BasicFrictionStack {
  std::vector<Block> blocks;
  std::vector<Real> friction;
  BasicFreeVector<Real> inverse_mass;  ///< three a block

  BasicFrictionStack(std::vector<Block> stacked, const std::vector<double>& coefficients)
      : blocks(std::move(stacked)),
        friction(coefficients.begin(), coefficients.end()),
        inverse_mass(3 * static_cast<Eigen::Index>(blocks.size())) {
    for (int k = 0; k < size(); ++k) {
      const Block& block = blocks[static_cast<std::size_t>(k)];
      const Real lightness = 1 / Real(block.mass);
      inverse_mass.template segment<3>(Eigen::Index{3} * k) << lightness, lightness, 1 / Real(block.inertia);
    }
  }

  int size() const { return static_cast<int>(blocks.size()); }
};

using FrictionStack = BasicFrictionStack<double>;

/// The overlap of a flat contact from the middle of the block above, m.
template <class Real>
struct Overlap {
  Real left, right;
};

template <class Real>
Overlap<Real> overlap(const BasicFrictionStack<Real>& stack, int interface, const Real& offset) {
  const Real upper = half_width_of<Real>(stack.blocks, interface);
  const Real lower = half_width_of<Real>(stack.blocks, interface - 1);
  return {std::max<Real>(-upper, -lower - offset), std::min<Real>(upper, lower - offset)};
}

/// A pivot at an end of a flat contact: which block has the corner. Even ends: the upper one.
template <class Real>
bool corner_is_below(const BasicFrictionStack<Real>& stack, int interface, const Real& offset, int side) {
  return half_width_of<Real>(stack.blocks, interface - 1) - side * offset <
         half_width_of<Real>(stack.blocks, interface);
}

}  // namespace rockstack
