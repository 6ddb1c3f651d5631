#pragma once

#include <algorithm>
#include <utility>

#include "analytic/unilateral/contact/bodies.hpp"

namespace rockstack {

/// A spring and a dashpot at each corner of an interface, or a bed along it, or rigid faces. SI units.
template <class Real>
struct BasicSpringLaw {
  Real stiffness = std::numeric_limits<Real>::infinity();  ///< N/m, across the face; infinite: rigid
  Real damping = 0;                                        ///< N·s/m, likewise
  Real tangential = 1;  ///< stiffness and damping along the face over those across it
  bool bed = false;     ///< stiffness and damping are those of a whole bed

  bool soft() const { return stiffness < std::numeric_limits<Real>::infinity(); }
};

/// The stack that contacts hold, with the friction coefficient of each interface.
template <class Real>
struct BasicFrictionStack {
  std::vector<Block> blocks;
  std::vector<Real> friction;
  std::vector<BasicSpringLaw<Real>> springs;  ///< of each interface; empty where all are rigid
  BasicFreeVector<Real> inverse_mass;         ///< three a block

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
  /// Whether springs hold an interface. Its joint is `apart`, as rigid contacts see it.
  bool soft(std::size_t interface) const { return !springs.empty() && springs[interface].soft(); }
};

using FrictionStack = BasicFrictionStack<double>;

/// The stack of a scene.
template <class Real>
BasicFrictionStack<Real> friction_stack_of(const Scene& scene) {
  BasicFrictionStack<Real> stack(scene.blocks, friction_of(scene));
  const CornerSprings& springs = scene.springs;
  if (springs.stiffness.empty() && springs.bed_stiffness.empty()) return stack;
  const auto of = [](const std::vector<double>& values, std::size_t k, double standard) {
    return Real(values.empty() ? standard : values[k]);
  };
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    constexpr double rigid = std::numeric_limits<double>::infinity();
    BasicSpringLaw<Real> law{of(springs.stiffness, k, rigid), of(springs.damping, k, 0),
                             Real(springs.tangential)};
    const Real bed = of(springs.bed_stiffness, k, rigid);
    if (bed < std::numeric_limits<Real>::infinity()) {
      const Real width = 2 * Real(interface_half_width(scene, static_cast<int>(k)));
      law = {width * bed, width * of(springs.bed_damping, k, 0), law.tangential, true};
    }
    stack.springs.push_back(law);
  }
  return stack;
}

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

/// How far the end of the lower face is beyond that of the upper one, m; zero where roundings alone part
/// them.
template <class Real>
Real overhang(const BasicFrictionStack<Real>& stack, int interface, const Real& offset, int side) {
  using std::abs;
  const Real upper = half_width_of<Real>(stack.blocks, interface);
  const Real beyond = half_width_of<Real>(stack.blocks, interface - 1) - side * offset - upper;
  return abs(beyond) <= tolerance<Real>(1e-13) * upper ? Real(0) : beyond;
}

/// A pivot at an end of a flat contact: which block has the corner. Even ends: the one whose corner stays on
/// the other's face in the slip, the upper one where nothing slips.
template <class Real>
bool corner_is_below(const BasicFrictionStack<Real>& stack, int interface, const Real& offset, int side,
                     int slip = 0) {
  const Real beyond = overhang(stack, interface, offset, side);
  return beyond < 0 || (beyond == 0 && slip * side > 0);
}

}  // namespace rockstack
