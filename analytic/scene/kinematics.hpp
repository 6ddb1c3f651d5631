#pragma once

#include <Eigen/Core>
#include <bit>
#include <bitset>
#include <type_traits>

#include "analytic/scene/direction.hpp"
#include "analytic/scene/pattern.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// How many blocks the memory of a stack of N blocks is for. N is the number of blocks where the compiler is
/// to know it (short stacks are several times faster so), and Eigen::Dynamic for any number up to max_blocks.
constexpr int capacity(int blocks) {
  return blocks == Eigen::Dynamic ? max_blocks : blocks;
}

/// One entry a block, held without heap memory.
template <class Real, int N = Eigen::Dynamic>
using Vector = Eigen::Matrix<Real, N, 1, 0, capacity(N), 1>;
template <class Real, int N = Eigen::Dynamic>
using Matrix = Eigen::Matrix<Real, N, N, 0, capacity(N), capacity(N)>;
template <class Real, int N = Eigen::Dynamic>
Vector<Real, N> vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))
      .template cast<Real>();
}

/// One point or plane vector (x, y) a block, as columns.
template <class Real, int N = Eigen::Dynamic>
using Points = Eigen::Matrix<Real, 2, N, 0, 2, capacity(N)>;
template <class Real>
using Point = Eigen::Matrix<Real, 2, 1>;

/// A set of interfaces, by index from 0.
using Interfaces = std::bitset<max_blocks>;

/// Lowest interface of a set that has any.
inline int lowest(const Interfaces& interfaces) {
  return std::countr_zero(interfaces.to_ulong());
}

/// What a comparison of two numbers tells; of packs of numbers it is a truth of each.
template <class Real>
using Truth = decltype(std::declval<const Real&>() < std::declval<const Real&>());

/// The constants of a stack in the number type of a calculation. SI units, one entry a block, bottom to top.
template <class Real, int N = Eigen::Dynamic>
struct Stack {
  Vector<Real, N> half_width;  ///< of the interface under the block: w, not the block's own b
  Vector<Real, N> half_height;
  Vector<Real, N> mass;
  Vector<Real, N> inertia;                           ///< about the block's centre of mass
  Vector<Real, N> centre_x, centre_y;                ///< of mass, from the middle of the block's lower face
  std::array<Truth<Real>, capacity(N)> overhangs{};  ///< the block is wider than the one below
  bool small_angles = false;                         ///< as small_angle_stack() makes it

  int size() const { return static_cast<int>(mass.size()); }
};

template <class Real, int N = Eigen::Dynamic>
Stack<Real, N> make_stack(const Scene& scene) {
  const auto size = static_cast<Eigen::Index>(scene.blocks.size());
  const Vector<Real, N> zero = Vector<Real, N>::Zero(size);
  Stack<Real, N> stack{zero, zero, zero, zero, zero, zero, {}};
  for (int k = 0; k < stack.size(); ++k) {
    const Block& block = scene.blocks[k];
    stack.half_width[k] = Real(interface_half_width(scene, k));
    stack.half_height[k] = Real(block.half_height);
    stack.mass[k] = Real(block.mass);
    stack.inertia[k] = Real(block.inertia);
    stack.centre_x[k] = Real(block.offset_x);
    stack.centre_y[k] = Real(block.half_height) + Real(block.offset_y);
    stack.overhangs[k] = k > 0 && block.half_width > scene.blocks[k - 1].half_width;
  }
  return stack;
}

/// The stack of the usual linear equations. With a half diagonal R = √(w² + h²) and a slenderness α =
/// atan(w/h) of each block, w that of its lower interface, it has R in the place of h and Rα in that of w;
/// and its Lagrangian keeps what is of second order in all α, θ and θ̇ together, with ẍg/g of first order. So
/// kinetic energy is that of the upright stack without widths, and weight has the lever R(θ − α) in place of
/// −R sin(α − θ). For one block, with I₀ = I + mR²,
///
///     I₀ θ̈ = −mR (g + ÿg) (α sgn θ − θ) − mR ẍg
///
/// (Housner 1963; Yim, Chopra & Penzien 1980; Makris & Roussos 2000). It rests up to |ẍg| = α (g + ÿg).
template <class Real, int N>
Stack<Real, N> small_angle_stack(Stack<Real, N> stack) {
  for (int k = 0; k < stack.size(); ++k) {
    const Real radius = hypot(stack.half_width[k], stack.half_height[k]);
    stack.half_width[k] = radius * atan2(stack.half_width[k], stack.half_height[k]);
    stack.half_height[k] = stack.centre_y[k] = radius;
  }
  stack.small_angles = true;
  return stack;
}

/// The block whose face an interface's forces are measured along: the lower one, or the upper one where that
/// overhangs and rests on the lower one's corner; −1: the ground.
template <class Real, int N>
int face(const Stack<Real, N>& stack, int interface) {
  return stack.overhangs[interface] ? interface : interface - 1;
}

/// The side that an interface pivots about, 1 to the right, −1 to the left, 0 where it is closed; from a
/// pattern, or from the sides themselves.
template <class Real>
Real side(const Pattern& pattern, int interface) {
  return Real(sign(pattern[interface]));
}
template <class Real, std::size_t Blocks>
Real side(const std::array<Real, Blocks>& sides, int interface) {
  return sides[interface];
}

/// The stack as a chain of pivots: block k hangs between the pivot of interface k and that of interface k+1.
/// A closed interface has its reference point in its middle. m.
template <class Real, int N = Eigen::Dynamic>
struct Chain {
  Point<Real> foot;       ///< first pivot, from the middle of the lowest block's place at rest
  Points<Real, N> arms;   ///< from pivot k to the centre of block k
  Points<Real, N> links;  ///< from pivot k to pivot k+1 (for the top block: to the middle of its top)
};

/// A body vector (a, c) turned clockwise by an angle with the given cosine and sine.
template <class Real>
Point<Real> turned(Real a, Real c, Real cosine, Real sine) {
  return {a * cosine + c * sine, c * cosine - a * sine};
}

/// Velocity of a point at `arm` from a pivot at unit clockwise angular velocity.
template <class Real>
Point<Real> quarter_turned(const Point<Real>& arm) {
  return {arm.y(), -arm.x()};
}

/// Cosines and sines of angles.
template <class Real, int N = Eigen::Dynamic>
struct Directions {
  Vector<Real, N> cosine, sine;
};

template <class Real, int N>
Directions<Real, N> directions(const Vector<Real, N>& angles) {
  Directions<Real, N> result{angles, angles};
  for (Eigen::Index k = 0; k < angles.size(); ++k) {
    const PlaneDirection<Real> direction = direction_of(angles[k]);
    result.cosine[k] = direction.cosine;
    result.sine[k] = direction.sine;
  }
  return result;
}

/// Arms rₖ = (−σₖwₖ, hₖ), plus the centre's offset, and links Lₖ = (σₖ₊₁wₖ₊₁ − σₖwₖ, 2hₖ), both turned by θₖ;
/// of a small-angle stack upright and without widths. `pattern` as side() takes it. Asked for so often that
/// calls count.
template <class Real, int N, class Sides>
[[gnu::always_inline]] inline Chain<Real, N> make_chain(const Stack<Real, N>& stack, const Sides& pattern,
                                                        const Directions<Real, N>& directions) {
  const int size = stack.size();
  const auto pivot = [&](int k) { return k < size ? side<Real>(pattern, k) * stack.half_width[k] : Real(0); };
  Chain<Real, N> chain{{pivot(0), Real(0)}, Points<Real, N>::Zero(2, size), Points<Real, N>::Zero(2, size)};
  for (int k = 0; k < size; ++k) {
    const Real cosine = directions.cosine[k];
    const Real sine = directions.sine[k];
    const Real height = stack.half_height[k];
    if (stack.small_angles) {
      chain.arms.col(k) = Point<Real>{0, height};
      chain.links.col(k) = Point<Real>{0, 2 * height};
      continue;
    }
    chain.arms.col(k) = turned<Real>(stack.centre_x[k] - pivot(k), stack.centre_y[k], cosine, sine);
    chain.links.col(k) = turned<Real>(pivot(k + 1) - pivot(k), 2 * height, cosine, sine);
  }
  return chain;
}

template <class Real, int N>
Chain<Real, N> make_chain(const Stack<Real, N>& stack, const Pattern& pattern,
                          const std::type_identity_t<Vector<Real, N>>& angles) {
  return make_chain(stack, pattern, directions<Real, N>(angles));
}

/// Centres of mass, m.
template <class Real, int N>
Points<Real, N> centres(const Chain<Real, N>& chain) {
  Points<Real, N> result = Points<Real, N>::Zero(2, chain.arms.cols());
  Point<Real> pivot = chain.foot;
  for (Eigen::Index k = 0; k < chain.arms.cols(); ++k) {
    result.col(k) = pivot + chain.arms.col(k);
    pivot += chain.links.col(k);
  }
  return result;
}

/// Velocities of the centres of mass, m/s, from angular velocities in rad/s, clockwise positive.
template <class Real, int N>
Points<Real, N> centre_velocities(const Chain<Real, N>& chain,
                                  const std::type_identity_t<Vector<Real, N>>& angular_velocities) {
  Points<Real, N> result = Points<Real, N>::Zero(2, chain.arms.cols());
  Point<Real> pivot = Point<Real>::Zero();
  for (Eigen::Index k = 0; k < chain.arms.cols(); ++k) {
    result.col(k) = pivot + angular_velocities[k] * quarter_turned<Real>(chain.arms.col(k));
    pivot += angular_velocities[k] * quarter_turned<Real>(chain.links.col(k));
  }
  return result;
}

/// The pattern that relative angles have, and where they are zero, relative angular velocities.
template <class Angles, class Velocities>
Pattern pattern_of(const Eigen::MatrixBase<Angles>& relative_angles,
                   const Eigen::MatrixBase<Velocities>& relative_velocities) {
  Pattern pattern;
  pattern.size = static_cast<int>(relative_angles.size());
  for (int k = 0; k < pattern.size; ++k) {
    const auto deciding = relative_angles[k] != 0 ? relative_angles[k] : relative_velocities[k];
    pattern[k] = contact_of((deciding > 0) - (deciding < 0));
  }
  return pattern;
}

/// Differences from the block below: φₖ = θₖ − θₖ₋₁, θ₀ = 0.
template <class Derived>
typename Derived::PlainObject relative(const Eigen::MatrixBase<Derived>& absolute) {
  typename Derived::PlainObject result = absolute;
  for (Eigen::Index k = 1; k < absolute.size(); ++k) result[k] = absolute[k] - absolute[k - 1];
  return result;
}

/// Sums from the ground up, the inverse of relative().
template <class Derived>
typename Derived::PlainObject absolute(const Eigen::MatrixBase<Derived>& relative_values) {
  typename Derived::PlainObject result = relative_values;
  for (Eigen::Index k = 1; k < result.size(); ++k) result[k] += result[k - 1];
  return result;
}

}  // namespace rockstack
