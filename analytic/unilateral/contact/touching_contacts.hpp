#pragma once

#include "analytic/unilateral/contact/contact_kinematics.hpp"
#include "analytic/unilateral/contact/linear_system.hpp"

namespace rockstack {

// Motion and impact are one rule for free bodies: M (v' − v) = Wᵀ λ, with v' the accelerations or the
// velocities after, v those that there would be without contact, and W the Jacobian of gaps and slips.

/// Velocities are sought, those after an impact, which bounce, or accelerations, to which velocities add.
enum class ContactLevel { velocities, impacts, accelerations };

/// What is asked of the laws of contact at one instant: the motion that follows from the one without contact.
template <class Real = double>
struct ContactProblem {
  const ContactModel<Real>& stack;
  const Bodies<Real>& bodies;
  const FreeVector<Real>& free;  ///< the motion without contact
  ContactLevel level;
  std::uint32_t left_cones = 0;  ///< interfaces, as bits, whose forces have left the static cone

  bool of_accelerations() const { return level == ContactLevel::accelerations; }
  /// The way an interface slides: a direction, or 0 where it is to be found.
  int slip_before(const Joint<Real>& joint) const { return of_accelerations() ? joint.slip : 0; }
  /// Whether an interface has its static coefficient: one that sticks, until its forces leave that cone.
  bool has_static_cone(int interface, const Joint<Real>& joint) const {
    return of_accelerations() && joint.slip == 0 && (left_cones >> interface & 1U) == 0;
  }
  Real friction(int interface, const Joint<Real>& joint) const {
    return (has_static_cone(interface, joint) ? stack.friction : stack.kinetic_friction)[interface];
  }
};

/// The Jacobian of the angle between an interface's upper and lower block, times a factor.
template <class Real>
FreeRow<Real> angle_row(const ContactModel<Real>& stack, int interface, const Real& factor = 1) {
  FreeRow<Real> row = FreeRow<Real>::Zero(Eigen::Index{3} * stack.size());
  row[Eigen::Index{3} * interface + 2] = factor;
  if (interface > 0) row[Eigen::Index{3} * interface - 1] = -factor;
  return row;
}

/// What an impact adds to the condition of a point: by Newton's law its speed across the face is 0 ≤ u + e u⁻
/// ⟂ λ ≥ 0 where it met it, u⁻ < 0, so that e u⁻ is what a pushing point keeps, backwards.
template <class Real>
Real bounce_of(const ContactProblem<Real>& problem, const FreeRow<Real>& gap_row) {
  if (problem.level != ContactLevel::impacts || !problem.stack.bounces_by(RestitutionLaw::newton)) return 0;
  return problem.stack.restitution * std::min<Real>(gap_row.dot(problem.free), 0);
}

/// The rows of an interface that touches, by their places among those of all: its gap and slip, and of a flat
/// contact the gaps of both ends, left first, and its turn, by its half-width, so that all are of one unit.
template <class Real>
struct TouchingInterface {
  int interface;
  bool flat;
  std::size_t gap;
  Real friction;
  Overlap<Real> ends = {};  ///< of a flat contact, m

  std::size_t slip() const { return gap + 1; }
  std::size_t left() const { return gap + 2; }
  std::size_t turn() const { return gap + 4; }
  /// The points that may push: one, or both ends.
  std::size_t points() const { return flat ? 2 : 1; }
  std::size_t point(std::size_t i) const { return flat ? left() + i : gap; }
};

/// An unknown force: along a row, and with it `slide` times that along another.
template <class Real>
struct ContactForceRow {
  std::size_t row, slip;
  Real slide;

  ContactForceRow() {}  // a list has room for many
  ContactForceRow(std::size_t along, std::size_t aside = 0, const Real& share = 0)
      : row(along), slip(aside), slide(share) {}
};
template <class Real>
using ContactForceRows = ShortVector<ContactForceRow<Real>, 20>;

/// What touches at one instant: W row by row, what unit forces along rows change of the conditions of rows, W
/// M⁻¹ Wᵀ, and the conditions W v + bias without contact. Decisions are by told(): a contact whose conditions
/// are below the rounding of what enters them neither presses, parts nor slides, and stays without force.
template <class Real>
class TouchingContacts {
 public:
  TouchingContacts(const ContactProblem<Real>& problem, const Joints<Real>& joints) : problem_(problem) {
    for (int k = 0; k < problem.stack.size(); ++k)
      if (joints[k].touches()) add(k, joints[k]);
    effects_ = NumberTable<Real>(rows_.size(), rows_.size());
    for (std::size_t c = 0; c < interfaces_.size(); ++c) add_effects(c);
  }

  const ContactProblem<Real>& problem() const { return problem_; }
  const ShortVector<TouchingInterface<Real>>& interfaces() const { return interfaces_; }
  bool empty() const { return interfaces_.empty(); }
  const FreeRow<Real>& row(std::size_t i) const { return rows_[i]; }
  const Real& free(std::size_t i) const { return free_[i]; }
  /// The condition without contact, or zero where it is rounding.
  Real told(std::size_t i) const { return abs(free_[i]) <= rounding_[i] ? Real(0) : free_[i]; }
  const Real& effect(std::size_t row, std::size_t force) const { return effects_(row, force); }
  Real effect(std::size_t row, const ContactForceRow<Real>& force) const {
    const Real own = effects_(row, force.row);
    return force.slide == 0 ? own : own + force.slide * effects_(row, force.slip);
  }

  /// The condition of a row under forces, from what is told without them.
  Real condition(std::size_t row, const ContactForceRows<Real>& forces,
                 const ShortNumbers<Real>& values) const {
    Real sum = told(row);
    for (std::size_t j = 0; j < forces.size(); ++j) sum += values[j] * effect(row, forces[j]);
    return sum;
  }

  /// Adds what a force does to a motion.
  void act(const ContactForceRow<Real>& force, const Real& value, FreeVector<Real>& motion) const {
    FreeRow<Real> direction = rows_[force.row];
    if (force.slide != 0) direction += force.slide * rows_[force.slip];
    motion += value * problem_.stack.inverse_mass.cwiseProduct(direction.transpose());
  }

 private:
  void add(int k, const Joint<Real>& joint) {
    const ContactModel<Real>& stack = problem_.stack;
    const Real bias = problem_.of_accelerations() ? 1 : 0;
    const ContactKinematics<Real> kinematics = kinematics_of(stack, problem_.bodies, k, joint);
    TouchingInterface<Real> contact{k, joint.touch == Contact::closed, rows_.size(),
                                    problem_.friction(k, joint)};
    const FreeRow<Real>& gap = kinematics.gap_row;
    if (!contact.flat) {
      add_row(gap, bias * kinematics.gap_bias + bounce_of(problem_, gap));
      add_row(kinematics.slip_row, bias * kinematics.slip_bias);
    } else {
      contact.ends = overlap(stack, k, joint.offset);
      const Real half_width = stack.half_width(k);
      const FreeRow<Real> turn = angle_row(stack, k);
      const FreeRow<Real> left = gap - contact.ends.left * turn, right = gap - contact.ends.right * turn;
      // What ends keep is on a line.
      const Real at_left = bounce_of(problem_, left), at_right = bounce_of(problem_, right);
      const Real turning = (at_left - at_right) / (contact.ends.right - contact.ends.left);
      add_row(gap, bias * kinematics.gap_bias + (at_left + contact.ends.left * turning));
      add_row(kinematics.slip_row, bias * kinematics.slip_bias);
      add_row(left, bias * kinematics.gap_bias + at_left);
      add_row(right, bias * kinematics.gap_bias + at_right);
      add_row(half_width * turn, turning * half_width);
    }
    interfaces_.push_back(contact);
    const Real rounding = rounding_of(k, kinematics);
    while (rounding_.size() < rows_.size()) rounding_.push_back(rounding);
  }
  /// What forces of a contact and of those before it do to each other: nothing but where they share a block.
  void add_effects(std::size_t c) {
    const bool shares = c > 0 && interfaces_[c - 1].interface + 1 == interfaces_[c].interface;
    const std::size_t first = interfaces_[shares ? c - 1 : c].gap;
    const std::size_t end = c + 1 < interfaces_.size() ? interfaces_[c + 1].gap : rows_.size();
    for (std::size_t i = interfaces_[c].gap; i < end; ++i) {
      for (std::size_t j = 0; j < first; ++j) effects_(i, j) = effects_(j, i) = 0;
      for (std::size_t j = first; j <= i; ++j)
        effects_(i, j) = effects_(j, i) = problem_.stack.effect(rows_[i], rows_[j]);
    }
  }
  template <class Row>
  void add_row(const Eigen::MatrixBase<Row>& row, const Real& bias) {
    rows_.resize(rows_.size() + 1);
    rows_.back() = row;
    free_.push_back(rows_.back().dot(problem_.free) + bias);
  }
  /// Axes and arms are known to rounding, so that conditions of an interface are to that of the motions of
  /// both its blocks.
  Real rounding_of(int k, const ContactKinematics<Real>& kinematics) const {
    Real size = 0;
    for (Eigen::Index at = Eigen::Index{3} * std::max(k - 1, 0); at < Eigen::Index{3} * (k + 1); ++at)
      size += (abs(kinematics.gap_row[at]) + abs(kinematics.slip_row[at])) * abs(problem_.free[at]);
    return tolerance<Real>(1e-14) * size;
  }

  const ContactProblem<Real>& problem_;
  ShortVector<TouchingInterface<Real>> interfaces_;
  ShortVector<FreeRow<Real>, 20> rows_;
  ShortNumbers<Real> free_, rounding_;
  NumberTable<Real> effects_;
};

}  // namespace rockstack
