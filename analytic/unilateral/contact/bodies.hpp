#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "analytic/scene/kinematics.hpp"

namespace rockstack {

/// What roundings make of numbers, in a number type, from what it is in double.
template <class Real>
Real tolerance(double in_double) {
  return Real(in_double) *
         (std::numeric_limits<Real>::epsilon() / Real(std::numeric_limits<double>::epsilon()));
}

/// What goes with the root of roundings: the time over which a force or a gap comes to be told from them.
template <class Real>
Real root_tolerance(double in_double) {
  using std::sqrt;
  return Real(in_double) *
         sqrt(std::numeric_limits<Real>::epsilon() / Real(std::numeric_limits<double>::epsilon()));
}

/// Where the block above an interface touches what is below: nowhere, at the left or right end of their
/// overlap, or along all of it.
enum class Touch : std::int8_t { left = -1, flat = 0, right = 1, apart = 2 };

/// The contact of one interface under Coulomb friction.
///
/// The offset s is how far the middle of the block above has slipped to the right along the face below. After
/// it the faces overlap on [max(−b, −b' − s), min(b, b' − s)] from the middle of the block above, b and b'
/// the half-widths above and below. A pivot is an end of that overlap: a corner of the block above on the
/// face below, or a corner of the block below under the face above; the face gives the normal.
template <class Real>
struct BasicJoint {
  Touch touch = Touch::flat;
  int slip = 0;               ///< the way the upper block slides: −1 left, 1 right; 0: it sticks
  bool corner_below = false;  ///< the pivot is a corner of the block below
  Real offset = 0;            ///< s, m, while it touches

  bool touches() const { return touch != Touch::apart; }
  bool sticks() const { return touches() && slip == 0; }
  bool pivots() const { return touch == Touch::left || touch == Touch::right; }
  /// The end that the pivot is at, −1 or 1; 0 where there is no pivot.
  int side() const { return pivots() ? static_cast<int>(touch) : 0; }
  /// The same contact, wherever it has slipped to.
  bool same_mode(const BasicJoint& other) const {
    return touch == other.touch && slip == other.slip && (corner_below == other.corner_below || !pivots());
  }
};

using Joint = BasicJoint<double>;

/// The joints of all interfaces, from the ground up: a mode.
template <class Real>
using Joints = std::vector<BasicJoint<Real>>;

/// One letter an interface from the ground up, L, C or R, and "-" where it is apart; an arrow after it shows
/// the way that the block above slides.
template <class Real>
std::string name(const Joints<Real>& joints) {
  std::string text;
  for (const BasicJoint<Real>& joint : joints) {
    text += joint.touch == Touch::apart ? '-' : "LCR"[static_cast<int>(joint.touch) + 1];
    if (joint.touches() && joint.slip != 0) text += joint.slip > 0 ? '>' : '<';
  }
  return text;
}

/// A block as a free body in the frame of the ground: its centre of mass from the middle of the ground's
/// interface, and its angle, clockwise positive; or the rates of the three. SI units.
template <class Real>
struct BasicBodyPlacement {
  Real x = 0, y = 0, angle = 0;
};

/// Of all blocks, bottom to top.
template <class Real>
using Placements = std::vector<BasicBodyPlacement<Real>>;

/// Positions and velocities of all blocks.
template <class Real>
struct BasicBodies {
  Placements<Real> at, rate;
};

/// Three numbers a block: x, y and angle.
template <class Real>
using BasicFreeVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
/// A gradient: what multiplies them.
template <class Real>
using FreeRow = Eigen::Matrix<Real, 1, Eigen::Dynamic>;

using BodyPlacement = BasicBodyPlacement<double>;
using Bodies = BasicBodies<double>;
using FreeVector = BasicFreeVector<double>;

template <class Real>
BasicFreeVector<Real> vector_of(const Placements<Real>& placements) {
  BasicFreeVector<Real> vector(3 * static_cast<Eigen::Index>(placements.size()));
  for (std::size_t k = 0; k < placements.size(); ++k)
    vector.template segment<3>(3 * static_cast<Eigen::Index>(k)) << placements[k].x, placements[k].y,
        placements[k].angle;
  return vector;
}

template <class Real>
Placements<Real> placements_of(const BasicFreeVector<Real>& vector) {
  Placements<Real> placements(static_cast<std::size_t>(vector.size() / 3));
  for (std::size_t k = 0; k < placements.size(); ++k) {
    const auto first = 3 * static_cast<Eigen::Index>(k);
    placements[k] = {vector[first], vector[first + 1], vector[first + 2]};
  }
  return placements;
}

/// The placement of a body, or of the ground, −1.
template <class Real>
BasicBodyPlacement<Real> placement(const Placements<Real>& placements, int body) {
  return body < 0 ? BasicBodyPlacement<Real>{} : placements[static_cast<std::size_t>(body)];
}

/// The angle between an interface's upper and lower block, or its rate.
template <class Real>
Real relative_angle(const Placements<Real>& placements, std::size_t interface) {
  return placements[interface].angle - (interface > 0 ? placements[interface - 1].angle : Real(0));
}

/// Half-sizes with the ground, −1, endless and without height; its centre of mass is its middle.
template <class Real>
Real half_width_of(const std::vector<Block>& blocks, int body) {
  return body < 0 ? std::numeric_limits<Real>::infinity()
                  : Real(blocks[static_cast<std::size_t>(body)].half_width);
}

template <class Real>
Real half_height_of(const std::vector<Block>& blocks, int body) {
  return body < 0 ? Real(0) : Real(blocks[static_cast<std::size_t>(body)].half_height);
}

/// The centre of mass of a body from its middle, m.
template <class Real>
Point<Real> centre_of(const std::vector<Block>& blocks, int body) {
  if (body < 0) return {Real(0), Real(0)};
  const Block& block = blocks[static_cast<std::size_t>(body)];
  return {Real(block.offset_x), Real(block.offset_y)};
}

/// A point of one body over the face of another; −1 is the ground.
template <class Real>
struct CornerOnFace {
  int face = -1;  ///< the body that has the face
  int body = 0;   ///< the body that has the point
  Real x = 0;     ///< the point from the middle of its body, in that body's frame, m
  Real y = 0;
  int upward = 1;  ///< 1 for the top face of the lower body, −1 for the bottom face of the upper one
};

/// The corner of the upper block of interface k (from 0) at an end.
template <class Real>
CornerOnFace<Real> upper_corner(const std::vector<Block>& blocks, int interface, int side) {
  return {interface - 1, interface, side * half_width_of<Real>(blocks, interface),
          -half_height_of<Real>(blocks, interface), 1};
}

/// The corner of the lower block, under the face of the upper one.
template <class Real>
CornerOnFace<Real> lower_corner(const std::vector<Block>& blocks, int interface, int side) {
  const int lower = interface - 1;
  return {interface, lower, side * half_width_of<Real>(blocks, lower), half_height_of<Real>(blocks, lower),
          -1};
}

/// The point whose gap and slip a joint holds: its pivot, or the middle of the upper block's face.
template <class Real>
CornerOnFace<Real> held_point(const std::vector<Block>& blocks, int interface,
                              const BasicJoint<Real>& joint) {
  if (joint.pivots() && joint.corner_below) return lower_corner<Real>(blocks, interface, joint.side());
  return upper_corner<Real>(blocks, interface, joint.side());
}

}  // namespace rockstack
