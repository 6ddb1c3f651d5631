#pragma once

#include "analytic/scene/applied_forces.hpp"
#include "analytic/scene/restraint_law.hpp"
#include "analytic/unilateral/contact/short_vector.hpp"

namespace rockstack {

// Functions of built-in numbers; other types have them in their own namespaces.
using std::abs, std::copysign, std::cos, std::pow, std::sin, std::sqrt;

/// What roundings make of numbers, in a number type, from what it is in double.
template <class Real>
Real tolerance(double in_double) {
  return Real(in_double) *
         (std::numeric_limits<Real>::epsilon() / Real(std::numeric_limits<double>::epsilon()));
}

/// What goes with the root of roundings: the time over which a force or a gap comes to be told from them.
template <class Real>
Real root_tolerance(double in_double) {
  return Real(in_double) *
         sqrt(std::numeric_limits<Real>::epsilon() / Real(std::numeric_limits<double>::epsilon()));
}

/// The contact of one interface under Coulomb friction.
///
/// The offset s is how far the middle of the block above has slipped to the right along the face below. After
/// it the faces overlap on [max(−b, −b' − s), min(b, b' − s)] from the middle of the block above, b and b'
/// the half-widths above and below. A pivot is an end of that overlap: a corner of the block above on the
/// face below, or a corner of the block below under the face above; the face gives the normal.
template <class Real = double>
struct Joint {
  Contact touch = Contact::closed;  ///< at an end of the faces' overlap, or along all of it
  int slip = 0;                     ///< the way the upper block slides: −1 left, 1 right; 0: it sticks
  bool corner_below = false;        ///< the pivot is a corner of the block below
  bool settled = false;  ///< of a pair of corners that sticks: on this face, whatever the other would do
  Real offset = 0;       ///< s, m, while it touches

  bool touches() const { return touch != Contact::apart; }
  bool sticks() const { return touches() && slip == 0; }
  bool pivots() const { return touch == Contact::left || touch == Contact::right; }
  /// The end that the pivot is at, −1 or 1; 0 where there is no pivot.
  int side() const { return pivots() ? static_cast<int>(touch) : 0; }
  /// Whether it is the same contact, wherever it has slipped to.
  bool same_mode(const Joint& other) const {
    return touch == other.touch && slip == other.slip && (corner_below == other.corner_below || !pivots());
  }
};

/// The joints of all interfaces, from the ground up: a mode.
template <class Real>
using Joints = ShortVector<Joint<Real>>;

template <class Real>
Pattern pattern_of(const Joints<Real>& joints) {
  Pattern pattern = closed_pattern(static_cast<int>(joints.size()));
  for (std::size_t k = 0; k < joints.size(); ++k) {
    pattern.contacts[k] = joints[k].touch;
    if (joints[k].touches()) pattern.slides[k] = static_cast<std::int8_t>(joints[k].slip);
  }
  return pattern;
}

/// A block as a free body in the frame of the ground: its centre of mass from the middle of the ground's
/// interface, and its angle, clockwise positive; or the rates of the three. SI units.
template <class Real = double>
struct Pose {
  Real x = 0, y = 0, angle = 0;
};

/// Poses of all blocks, bottom to top.
template <class Real = double>
using Poses = ShortVector<Pose<Real>>;

/// Positions and velocities of all blocks.
template <class Real = double>
struct Bodies {
  Poses<Real> pose, velocity;
};

/// Three numbers a block: x, y and angle.
template <class Real = double>
using FreeVector = Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, 3 * max_blocks, 1>;
/// A row of a Jacobian: what multiplies them.
template <class Real>
using FreeRow = Eigen::Matrix<Real, 1, Eigen::Dynamic, Eigen::RowMajor, 1, 3 * max_blocks>;

template <class Real>
FreeVector<Real> vector_of(const Poses<Real>& poses) {
  FreeVector<Real> vector(3 * poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k)
    vector.template segment<3>(3 * k) << poses[k].x, poses[k].y, poses[k].angle;
  return vector;
}

/// Vector of one x and y for so many blocks, no angle.
template <class Real>
FreeVector<Real> uniform(int blocks, const Real& x, const Real& y) {
  return Eigen::Matrix<Real, 3, 1>(x, y, Real(0)).replicate(blocks, 1);
}

template <class Real>
Poses<Real> poses_of(const FreeVector<Real>& vector) {
  Poses<Real> poses(vector.size() / 3);
  for (std::size_t k = 0; k < poses.size(); ++k)
    poses[k] = {vector[3 * k], vector[3 * k + 1], vector[3 * k + 2]};
  return poses;
}

/// The pose of a body, or of the ground, −1.
template <class Real>
Pose<Real> pose_of(const Poses<Real>& poses, int body) {
  return body < 0 ? Pose<Real>{} : poses[body];
}

/// The angle between an interface's upper and lower block, or its rate.
template <class Real>
Real relative_angle(const Poses<Real>& poses, std::size_t interface) {
  return poses[interface].angle - (interface > 0 ? poses[interface - 1].angle : Real(0));
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

/// A spring and a dashpot at each corner of an interface, or a bed along it, or rigid faces; its friction.
template <class Real>
struct SpringLaw {
  Real stiffness, damping;                        ///< across the face, N/m, infinite: rigid; N·s/m
  Real tangential_stiffness, tangential_damping;  ///< along it
  Real friction;
  bool bed;  ///< stiffness and damping are those of a whole bed

  bool soft() const { return stiffness < std::numeric_limits<Real>::infinity(); }
};

/// The stack that contacts hold, with the friction coefficients of each interface. Bodies count from 0; −1 is
/// the ground, endless and without height, whose centre of mass is its middle.
template <class Real = double>
struct ContactModel {
  std::vector<Block> blocks;
  std::vector<Real> friction;          ///< where it sticks
  std::vector<Real> kinetic_friction;  ///< where it slides, and of impulses
  Real restitution = 0;                ///< of all points
  RestitutionLaw restitution_law = RestitutionLaw::newton;
  std::vector<SpringLaw<Real>> springs;  ///< of each interface; empty where all are rigid
  std::vector<PushPoint<Real>> pushes;
  std::vector<RestraintLaw<Real>> restraints;  ///< as they are now
  FreeVector<Real> inverse_mass;               ///< three a block

  ContactModel(std::vector<Block> stacked, const std::vector<double>& coefficients)
      : blocks(std::move(stacked)),
        friction(coefficients.begin(), coefficients.end()),
        kinetic_friction(friction),
        inverse_mass(3 * static_cast<Eigen::Index>(blocks.size())) {
    for (int k = 0; k < size(); ++k) {
      const Block& block = blocks[k];
      const Real lightness = 1 / Real(block.mass);
      inverse_mass.template segment<3>(Eigen::Index{3} * k) << lightness, lightness, 1 / Real(block.inertia);
    }
  }

  int size() const { return static_cast<int>(blocks.size()); }
  bool bounces_by(RestitutionLaw law) const { return restitution > 0 && restitution_law == law; }
  /// Whether springs hold an interface. Its joint is `apart`, as rigid contacts see it.
  bool soft(std::size_t interface) const { return !springs.empty() && springs[interface].soft(); }

  /// What a unit force along one row does along another, 1/kg.
  template <class Row, class Direction>
  Real effect(const Eigen::MatrixBase<Row>& row, const Eigen::MatrixBase<Direction>& direction) const {
    return (row.array() * inverse_mass.transpose().array() * direction.array()).sum();
  }

  /// Height of all blocks, m.
  Real height() const {
    Real sum = 0;
    for (const Block& block : blocks) sum += 2 * Real(block.half_height);
    return sum;
  }
  /// √(H/g), s.
  Real fall_time(const Real& gravity) const { return sqrt(height() / gravity); }
  Real half_width(int body) const {
    return body < 0 ? std::numeric_limits<Real>::infinity() : Real(blocks[body].half_width);
  }
  Real half_height(int body) const { return body < 0 ? Real(0) : Real(blocks[body].half_height); }
  /// The centre of mass of a body from its middle, m.
  Point<Real> centre(int body) const {
    if (body < 0) return {Real(0), Real(0)};
    const Block& block = blocks[body];
    return {Real(block.offset_x), Real(block.offset_y)};
  }

  /// A corner at an end of an interface: of the block above, or of the block below under its face.
  CornerOnFace<Real> corner(int interface, int side, bool below) const {
    const int lower = interface - 1;
    if (below) return {interface, lower, side * half_width(lower), half_height(lower), -1};
    return {lower, interface, side * half_width(interface), -half_height(interface), 1};
  }
  /// The point whose gap and slip a joint holds: its pivot, or the middle of the upper block's face.
  CornerOnFace<Real> held_point(int interface, const Joint<Real>& joint) const {
    return corner(interface, joint.side(), joint.pivots() && joint.corner_below);
  }
};

/// The stack of a scene.
template <class Real>
ContactModel<Real> contact_model_of(const Scene& scene) {
  ContactModel<Real> stack(scene.blocks, friction_of(scene));
  const std::vector<double> sliding = kinetic_friction_of(scene);
  stack.kinetic_friction.assign(sliding.begin(), sliding.end());
  stack.restitution = Real(scene.point_restitution);
  stack.restitution_law = scene.restitution_law;
  stack.pushes = push_points<Real>(scene);
  stack.restraints = restraint_laws<Real>(scene);
  const CornerSprings& springs = scene.springs;
  if (springs.stiffness.empty() && springs.bed_stiffness.empty()) return stack;
  const auto of = [](const std::vector<double>& values, std::size_t k, double default_value) {
    return Real(values.empty() ? default_value : values[k]);
  };
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    constexpr double rigid = std::numeric_limits<double>::infinity();
    Real stiffness = of(springs.stiffness, k, rigid), damping = of(springs.damping, k, 0);
    const Real bed = of(springs.bed_stiffness, k, rigid);
    const bool is_bed = bed < std::numeric_limits<Real>::infinity();
    if (is_bed) {
      const Real width = 2 * Real(interface_half_width(scene, k));
      stiffness = width * bed;
      damping = width * of(springs.bed_damping, k, 0);
    }
    const Real along(springs.tangential);
    stack.springs.push_back(
        {stiffness, damping, stiffness * along, damping * along, stack.friction[k], is_bed});
  }
  return stack;
}

/// The overlap of a flat contact from the middle of the block above, m.
template <class Real>
struct Overlap {
  Real left, right;
};

template <class Real>
Overlap<Real> overlap(const ContactModel<Real>& stack, int interface, const Real& offset) {
  const Real upper = stack.half_width(interface), lower = stack.half_width(interface - 1);
  return {std::max<Real>(-upper, -lower - offset), std::min<Real>(upper, lower - offset)};
}

/// How far the lower face ends beyond the upper one, m; zero where roundings alone part the ends.
template <class Real>
Real overhang(const ContactModel<Real>& stack, int interface, const Real& offset, int side) {
  const Real upper = stack.half_width(interface);
  const Real beyond = stack.half_width(interface - 1) - side * offset - upper;
  return abs(beyond) <= tolerance<Real>(1e-13) * upper ? Real(0) : beyond;
}

/// A pivot at an end of a flat contact: which block has the corner. Even ends: the one whose corner stays on
/// the other's face in the slip, the upper one where nothing slips.
template <class Real>
bool corner_is_below(const ContactModel<Real>& stack, int interface, const Real& offset, int side,
                     int slip = 0) {
  const Real beyond = overhang(stack, interface, offset, side);
  return beyond < 0 || (beyond == 0 && slip * side > 0);
}

}  // namespace rockstack
