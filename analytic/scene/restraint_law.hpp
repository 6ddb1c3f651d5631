#pragma once

#include "analytic/scene/kinematics.hpp"

namespace rockstack {

/// What a tendon does: its force goes with its length, or is none, or stays at the yield force.
enum class Stretch : std::int8_t { elastic, slack, yields };

/// A restraint between two points, in the number type of a calculation. Blocks count from 0; −1 is the
/// ground.
template <class Real>
struct RestraintLaw {
  int from = -1, to = -1;
  Point<Real> from_arm,
      to_arm;     ///< from centres of mass, in blocks' frames; of the ground from its middle, m
  Real length{};  ///< where the stack stands upright, m
  Real stiffness{}, prestress{}, yield{};  ///< N/m, N, N; of a damper no stiffness
  Real damping{};                          ///< N·s/m
  Stretch stretch = Stretch::elastic;
  Real drawn{};         ///< what yielding has left, m
  bool at_end = false;  ///< it has come from its last stretch just now, so that what ends this one is at zero

  /// The force of a length without change, N; the law of the elastic stretch.
  Real elastic(const Real& now) const { return prestress + stiffness * ((now - length) - drawn); }
  /// Force that pulls its ends together, N.
  Real force(const Real& now, const Real& rate) const {
    if (stretch == Stretch::slack) return 0;
    return (stretch == Stretch::yields ? yield : elastic(now)) + damping * rate;
  }

  /// Goes to a length: it is slack where it would push, and drawn where it would pull more than it can.
  void follow(const Real& now) {
    if (stiffness == 0) return;
    if (elastic(now) > yield) unload(now);
    stretch = elastic(now) < 0 ? Stretch::slack : Stretch::elastic;
  }
  /// Takes the length for that at which it yields, no more and no less.
  void unload(const Real& now) { drawn = (now - length) - (yield - prestress) / stiffness; }
};

/// A point of a body, where it is and how it goes, with its arm from the centre of mass, on the ground's
/// axes.
template <class Real>
struct PointMotion {
  Point<Real> place, velocity, arm;
};

/// Calls f with each body that a restraint pulls at, the force on it and its clockwise moment about the
/// centre of mass. `motion_of` has PointMotion of a body and an arm.
template <class Real, class MotionOf, class F>
void each_restraint(const std::vector<RestraintLaw<Real>>& restraints, const MotionOf& motion_of,
                    const F& f) {
  for (const RestraintLaw<Real>& restraint : restraints) {
    const PointMotion<Real> from = motion_of(restraint.from, restraint.from_arm);
    const PointMotion<Real> to = motion_of(restraint.to, restraint.to_arm);
    const Point<Real> apart = to.place - from.place;
    const Real length = apart.norm();
    const Point<Real> unit = apart / length;
    const Point<Real> force = restraint.force(length, unit.dot(to.velocity - from.velocity)) * unit;
    const Point<Real> back = -force;
    if (restraint.from >= 0) f(restraint.from, force, quarter_turned(from.arm).dot(force));
    if (restraint.to >= 0) f(restraint.to, back, quarter_turned(to.arm).dot(back));
  }
}

/// Restraints of a scene, as they are where it stands upright.
template <class Real>
std::vector<RestraintLaw<Real>> restraint_laws(const Scene& scene) {
  const auto arm_of = [&](const BlockPoint& point) -> Point<Real> {
    if (point.block == 0) return {Real(point.x), Real(point.y)};
    const Block& block = scene.blocks[static_cast<std::size_t>(point.block) - 1];
    return {Real(point.x) - Real(block.offset_x),
            Real(point.y) - (Real(block.half_height) + Real(block.offset_y))};
  };
  const auto upright = [&](const BlockPoint& point) -> Point<Real> {
    Real height = 0;
    for (int k = 0; k + 1 < point.block; ++k) height += 2 * Real(scene.blocks[k].half_height);
    return {Real(point.x), height + Real(point.y)};
  };
  std::vector<RestraintLaw<Real>> laws;
  laws.reserve(scene.restraints.size());
  for (const Restraint& given : scene.restraints) {
    RestraintLaw<Real> law;
    law.from = given.from.block - 1;
    law.to = given.to.block - 1;
    law.from_arm = arm_of(given.from);
    law.to_arm = arm_of(given.to);
    law.length = Point<Real>(upright(given.to) - upright(given.from)).norm();
    law.stiffness = Real(given.stiffness);
    law.prestress = Real(given.prestress);
    law.yield = Real(given.yield);
    law.damping = Real(given.damping);
    laws.push_back(law);
  }
  return laws;
}

}  // namespace rockstack
