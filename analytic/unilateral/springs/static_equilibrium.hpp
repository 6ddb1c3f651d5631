#pragma once

#include <Eigen/LU>

#include "analytic/unilateral/contact/contact_laws.hpp"
#include "analytic/unilateral/springs/spring_point.hpp"

namespace rockstack {

template <class Real>
using SquareMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// Signs of a bed's ends by where bodies are and go.
template <class Real>
void note_signs(const ContactModel<Real>& stack, const Bodies<Real>& bodies, SpringPoint<Real>& point) {
  const GrowingBed<Real> bed = bed_at(stack, point, bodies);
  for (std::size_t end = 0; end < 2; ++end)
    point.bed.ends[end] = {bed.depth[end][0] > 0, bed.pressure[end][0] > 0};
  point.bed.crossed = stack.springs[point.interface].damping > 0 && bed.crosses();
  point.press = stretch_of(point.bed).presses ? Press::pushing : Press::off;
}

/// A bed before it is loaded: the ends that touch are at its surface.
template <class Real>
SpringPoint<Real> initial_bed(const ContactModel<Real>& stack, int interface, const Joint<Real>& joint,
                              const Bodies<Real>& bodies) {
  SpringPoint<Real> point{.interface = interface,
                          .corner_below = stack.half_width(interface - 1) < stack.half_width(interface)};
  note_signs(stack, bodies, point);
  for (const int side : {-1, 1})
    if (joint.touch == Contact::closed || joint.side() == side)
      point.bed.ends[side < 0 ? 0 : 1] = {true, true, true};
  if (joint.touches()) point.press = Press::pushing;
  if (stack.friction[interface] > 0) point.slide = joint.slip;
  point.slider = kinematics_of(stack, bodies, point).slip;
  return point;
}

/// The points of soft interfaces, where rigid contacts would touch, yet without load. Those that slip slide.
template <class Real>
SpringPoints<Real> initial_points(const ContactModel<Real>& stack, const ContactState<Real>& state) {
  SpringPoints<Real> points;
  for (int k = 0; k < stack.size(); ++k) {
    if (!stack.soft(k)) continue;
    const Joint<Real>& joint = state.joints[k];
    if (stack.springs[k].bed) {
      points.push_back(initial_bed(stack, k, joint, state.bodies));
      continue;
    }
    for (const int side : {-1, 1}) {
      SpringPoint<Real> point{k, side, corner_is_below<Real>(stack, k, joint.offset, side)};
      if (joint.touch == Contact::closed || joint.side() == side) {
        point.press = Press::pushing;
        point.slide = stack.friction[k] > 0 ? joint.slip : 0;
        point.slider = kinematics_of(stack, state.bodies, point).slip;
        point.at_face = true;
      }
      points.push_back(point);
    }
  }
  return points;
}

/// Moves all blocks from one up, and turns them about a point.
template <class Real>
void move_above(std::size_t first, const Point<Real>& about, const Point<Real>& by, const Real& angle,
                Poses<Real>& at) {
  for (std::size_t k = first; k < at.size(); ++k) {
    const Point<Real> arm = turned<Real>({at[k].x - about.x(), at[k].y - about.y()}, angle);
    at[k] = {about.x() + arm.x() + by.x(), about.y() + arm.y() + by.y(), at[k].angle + angle};
  }
}

/// The equilibrium of a stack at rest on its springs, by Newton's method with the stiffness of springs alone:
/// unknown are the displacement and the turn of all above each soft interface. Nothing where the
/// method does not converge, where a corner would have to pull, or a slider would move.
template <class Real>
std::optional<Poses<Real>> find_equilibrium(const Scene& scene, const ContactModel<Real>& stack,
                                            Bodies<Real> bodies, const SpringPoints<Real>& points) {
  const Gravity gravity = gravity_of(scene);
  std::vector<std::size_t> soft;
  for (std::size_t k = 0; k < stack.blocks.size(); ++k)
    if (stack.soft(k)) soft.push_back(k);
  const std::size_t size = 3 * soft.size();
  FreeVector<Real> weight(Eigen::Index{3} * stack.size());
  const Real height = stack.height();
  for (int k = 0; k < stack.size(); ++k) {
    const Block& block = stack.blocks[k];
    weight.template segment<3>(Eigen::Index{3} * k) << Real(block.mass) * Real(gravity.along),
        -Real(block.mass) * Real(gravity.across), Real(0);
  }
  const auto foot = [&](std::size_t k) -> Point<Real> {
    const Pose<Real>& at = bodies.pose[k];
    return Point<Real>(at.x, at.y) +
           turned<Real>(Point<Real>(0, -stack.half_height(k)) - stack.centre(k), at.angle);
  };
  SpringPoints<Real> standing = points;
  for (SpringPoint<Real>& point : standing) point.slide = 0;
  constexpr int most = 1000;
  Real before = std::numeric_limits<Real>::infinity();
  for (int round = 0; round < most; ++round) {
    for (SpringPoint<Real>& point : standing)
      if (point.is_bed()) note_signs(stack, bodies, point);
    SquareMatrix<Real> motions = SquareMatrix<Real>::Zero(weight.size(), size);
    for (std::size_t c = 0; c < soft.size(); ++c) {
      const Point<Real> about = foot(soft[c]);
      for (std::size_t k = soft[c]; k < bodies.pose.size(); ++k) {
        const std::size_t row = 3 * k, column = 3 * c;
        const Point<Real> turn =
            quarter_turned<Real>({bodies.pose[k].x - about.x(), bodies.pose[k].y - about.y()});
        motions(row, column) = motions(row + 1, column + 1) = motions(row + 2, column + 2) = 1;
        motions(row, column + 2) = turn.x();
        motions(row + 1, column + 2) = turn.y();
      }
    }
    using Row = Eigen::Matrix<Real, 1, Eigen::Dynamic>;
    SquareMatrix<Real> stiffness = SquareMatrix<Real>::Zero(size, size);
    for (const SpringPoint<Real>& point : standing) {
      const SpringLaw<Real>& law = stack.springs[point.interface];
      const ContactKinematics<Real> rows = kinematics_of(stack, bodies, point);
      const Row across = rows.gap_row * motions, along = rows.slip_row * motions;
      stiffness += law.tangential_stiffness * along.transpose() * along;
      if (!point.is_bed()) {
        stiffness += law.stiffness * across.transpose() * across;
        continue;
      }
      const auto ends = bed_rows(stack, point, bodies);
      const Row turning = (ends[1].gap_row - ends[0].gap_row) / 2 * motions;
      const auto& [whole, first, second] = moments_in_contact(-ends[0].gap, -ends[1].gap);
      stiffness += law.stiffness * (whole * across.transpose() * across +
                                    first * (turning.transpose() * across + across.transpose() * turning) +
                                    second * turning.transpose() * turning);
    }
    const FreeVector<Real> forces = weight + forces_of(stack, standing, bodies);
    const FreeVector<Real> change =
        Eigen::PartialPivLU<SquareMatrix<Real>>(stiffness).solve(motions.transpose() * forces);
    for (std::size_t c = soft.size(); c-- > 0;)
      move_above<Real>(soft[c], foot(soft[c]), {change[3 * c], change[3 * c + 1]}, change[3 * c + 2],
                       bodies.pose);
    const Real largest = change.template lpNorm<Eigen::Infinity>();
    // Newton's method ends where rounding does: changes are negligible, and no longer fall.
    if (largest <= 8 * std::numeric_limits<Real>::epsilon() * height && largest >= before / 2) break;
    if (round + 1 == most || !(largest < height)) return std::nullopt;
    before = largest;
  }
  for (const SpringPoint<Real>& point : standing) {
    const SpringLaw<Real>& law = stack.springs[point.interface];
    const PointForce<Real> force = force_of(stack, point, bodies, kinematics_of(stack, bodies, point));
    if (!(force.normal > 0) || abs(force.tangential) > law.friction * force.normal) return std::nullopt;
  }
  return bodies.pose;
}

/// How far a soft interface gives way under a weight, m; how many of its points bear it.
template <class Real>
std::pair<Real, int> give_way(const ContactModel<Real>& stack, const Bodies<Real>& bodies, const Real& weight,
                              const std::vector<SpringPoint<Real>*>& ends) {
  const SpringPoint<Real>& first = *ends.front();
  const SpringLaw<Real>& law = stack.springs[first.interface];
  if (first.is_bed()) {
    const auto rows = bed_rows(stack, first, bodies);
    const Real lower = std::min(rows[0].gap, rows[1].gap);
    const Real rise = std::max(rows[0].gap, rows[1].gap) - lower, level = weight / law.stiffness;
    // A trapezium of pressure, or a triangle.
    return {lower + (2 * level > rise ? Real(level + rise / 2) : Real(sqrt(2 * level * rise))), 1};
  }
  SpringPoint<Real>& other = *ends.back();
  if (other.pushes()) return {weight / law.stiffness / 2, 2};
  const ContactKinematics<Real> rows = kinematics_of(stack, bodies, other);
  if (!(rows.gap * law.stiffness < weight)) return {weight / law.stiffness, 1};
  other.press = Press::pushing;
  other.slide = first.slide;
  other.slider = rows.slip;
  return {(rows.gap + weight / law.stiffness) / 2, 2};
}

/// Lets one soft interface bear the weight above it without velocity: N and T across and along its face, by
/// the corners that touch or the bed. A corner that is open by less than that presses it in touches too.
template <class Real>
void preload_interface(const Gravity& gravity, const ContactModel<Real>& stack, std::size_t interface,
                       Bodies<Real>& bodies, SpringPoints<Real>& points) {
  const SpringLaw<Real>& law = stack.springs[interface];
  std::vector<SpringPoint<Real>*> ends;
  for (SpringPoint<Real>& point : points)
    if (point.interface == static_cast<int>(interface)) ends.push_back(&point);
  if (!ends.front()->pushes()) std::swap(ends.front(), ends.back());
  const SpringPoint<Real>& first = *ends.front();
  const int face = corner_of(stack, first).face;
  const Real angle = pose_of(bodies.pose, face).angle;
  Real mass = 0;
  for (std::size_t k = interface; k < bodies.pose.size(); ++k) mass += Real(stack.blocks[k].mass);
  const Point<Real> load = turned<Real>({mass * Real(gravity.along), -mass * Real(gravity.across)}, -angle);
  const auto [depth, count] = give_way<Real>(stack, bodies, -load.y(), ends);
  const Real most = -law.friction * load.y();
  const Real along = first.slide != 0 ? Real(first.slide * most) : std::clamp<Real>(load.x(), -most, most);
  const Real stretch = along / (count * law.tangential_stiffness);
  // What slides keeps its place: its slider stands back.
  if (first.slide != 0)
    for (SpringPoint<Real>* end : ends) end->slider -= stretch;
  const Point<Real> moved = turned<Real>({first.slide != 0 ? Real(0) : stretch, -depth}, angle);
  move_above<Real>(interface, {Real(0), Real(0)}, moved, 0, bodies.pose);
  const Point<Real> turning = quarter_turned(moved) * pose_of(bodies.velocity, face).angle;
  for (std::size_t k = interface; k < bodies.pose.size(); ++k) {
    bodies.velocity[k].x += turning.x();
    bodies.velocity[k].y += turning.y();
  }
}

/// Puts blocks onto their springs. A still, upright stack goes to its equilibrium; others keep their angles.
template <class Real>
void preload(const Scene& scene, const ContactModel<Real>& stack, ContactState<Real>& state,
             SpringPoints<Real>& points) {
  Bodies<Real>& bodies = state.bodies;
  bool still = true;
  for (std::size_t k = 0; k < bodies.pose.size(); ++k) {
    const Pose<Real>& rate = bodies.velocity[k];
    still =
        still && state.joints[k].touch == Contact::closed && rate.x == 0 && rate.y == 0 && rate.angle == 0;
  }
  for (SpringPoint<Real>& point : points) point.at_face = false;
  const auto found = still ? find_equilibrium(scene, stack, bodies, points) : std::nullopt;
  if (found) bodies.pose = *found;
  for (std::size_t k = 0; k < bodies.pose.size(); ++k)
    if (stack.soft(k) && !found) preload_interface(gravity_of(scene), stack, k, bodies, points);
  for (SpringPoint<Real>& point : points)
    if (point.is_bed()) note_signs(stack, bodies, point);
}

}  // namespace rockstack
