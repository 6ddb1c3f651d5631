#pragma once

#include "analytic/unilateral/contact/touching_contacts.hpp"

namespace rockstack {

/// What an interface does to the block above, N and N·m, or impulses; the moment is about its held point.
template <class Real>
struct ContactForce {
  Real normal = 0, tangential = 0, moment = 0;
};

/// What a mode leads to.
template <class Real = double>
struct ModeResponse {
  FreeVector<Real> motion;
  ShortVector<ContactForce<Real>> forces;
};

/// The largest part of a force along or across a face.
template <class Real>
Real largest_force(const ShortVector<ContactForce<Real>>& forces) {
  Real size = 0;
  for (const ContactForce<Real>& force : forces)
    size = std::max<Real>(size, std::max<Real>(abs(force.normal), abs(force.tangential)));
  return size;
}

/// What a mode of `contacts` holds, and what holds it.
template <class Real>
ContactForceRows<Real> held_by(const TouchingContacts<Real>& contacts, const Joints<Real>& mode) {
  ContactForceRows<Real> held;
  for (const TouchingInterface<Real>& contact : contacts.interfaces()) {
    const Joint<Real>& joint = mode[contact.interface];
    if (!joint.touches()) continue;
    if (joint.touch == Contact::closed) held.push_back({contact.turn()});
    const bool end = contact.flat && joint.pivots();
    held.push_back({end ? contact.left() + (joint.side() > 0) : contact.gap, contact.slip(),
                    -joint.slip * contact.friction});
    if (joint.slip == 0) held.push_back({contact.slip()});
  }
  return held;
}

/// The forces that leave nothing of the conditions of their rows; of velocities where they are given.
template <class Real>
ShortNumbers<Real> holding(const TouchingContacts<Real>& contacts, const ContactForceRows<Real>& held,
                           const FreeVector<Real>* velocities = nullptr) {
  const auto entry = [&](std::size_t i, std::size_t j) { return contacts.effect(held[i].row, held[j]); };
  ShortNumbers<Real> right_side(held.size());
  for (std::size_t i = 0; i < held.size(); ++i) {
    const std::size_t row = held[i].row;
    right_side[i] = -(velocities != nullptr ? contacts.row(row).dot(*velocities) : contacts.free(row));
  }
  return LinearSystem<Real>(held.size(), entry).solve(right_side);
}

/// The forces of a mode, as held_by() lists them, interface by interface.
template <class Real>
ShortVector<ContactForce<Real>> held_forces(const TouchingContacts<Real>& contacts, const Joints<Real>& mode,
                                            const ShortNumbers<Real>& values) {
  const ContactModel<Real>& stack = contacts.problem().stack;
  ShortVector<ContactForce<Real>> forces(mode.size());
  std::size_t at = 0;
  for (const TouchingInterface<Real>& contact : contacts.interfaces()) {
    const Joint<Real>& joint = mode[contact.interface];
    if (!joint.touches()) continue;
    ContactForce<Real>& force = forces[contact.interface];
    if (joint.touch == Contact::closed) force.moment = values[at++] * stack.half_width(contact.interface);
    force.normal = values[at++];
    force.tangential = joint.slip == 0 ? values[at++] : Real(-joint.slip * contact.friction * force.normal);
  }
  return forces;
}

/// The motion that is left of a free one where `contacts` are in a mode of theirs, or of velocities.
template <class Real>
ModeResponse<Real> respond(const TouchingContacts<Real>& contacts, const Joints<Real>& mode,
                           const FreeVector<Real>* velocities = nullptr) {
  const ContactForceRows<Real> held = held_by(contacts, mode);
  const ShortNumbers<Real> values = holding(contacts, held, velocities);
  ModeResponse<Real> response{velocities != nullptr ? *velocities : contacts.problem().free,
                              held_forces(contacts, mode, values)};
  for (std::size_t i = 0; i < held.size(); ++i) contacts.act(held[i], values[i], response.motion);
  return response;
}

/// Response where joints hold as they say.
template <class Real>
ModeResponse<Real> respond(const ContactProblem<Real>& problem, const Joints<Real>& joints) {
  return respond(TouchingContacts<Real>(problem, joints), joints);
}

/// No interface's angular acceleration is larger where all joints stick. Of all accelerations that obey them,
/// forces change the free ones least, in the metric of kinetic energy (Gauss's principle), and one that obeys
/// turns no block: then a block's centre follows the one below but for both arms' centripetal accelerations.
template <class Real>
Real most_turning(const ContactModel<Real>& stack, const Poses<Real>& rates, const FreeVector<Real>& free) {
  Real path = 0, turning = 0, change = 0, least = std::numeric_limits<Real>::infinity();
  for (std::size_t k = 0; k < rates.size(); ++k) {
    const Block& block = stack.blocks[k];
    const Real arm = block.half_width + block.half_height + abs(block.offset_x) + abs(block.offset_y);
    path += 2 * arm * rates[k].angle * rates[k].angle;
    const Real moved = path + abs(free[3 * k]) + abs(free[3 * k + 1]);
    turning = std::max<Real>(turning, abs(free[3 * k + 2]));
    change += block.mass * moved * moved + block.inertia * turning * turning;
    least = std::min<Real>(least, block.inertia);
  }
  return 2 * (turning + sqrt(change / least));
}

/// A rounding over what it makes of contact forces, in shares of them, of a stack that stands and sticks: the
/// reciprocal condition number, by largest rows' sums, of what forces do, each in the unit of its own effect.
template <class Real>
Real conditioning(const ContactModel<Real>& stack) {
  Joints<Real> joints(stack.blocks.size());
  Bodies<Real> bodies{Poses<Real>(joints.size()), Poses<Real>(joints.size())};
  place(stack, joints, bodies);
  const FreeVector<Real> none = FreeVector<Real>::Zero(Eigen::Index{3} * stack.size());
  const ContactProblem<Real> problem{stack, bodies, none, ContactLevel::velocities};
  const TouchingContacts<Real> contacts(problem, joints);
  const ContactForceRows<Real> held = held_by(contacts, joints);
  const std::size_t size = held.size();
  const auto effect = [&](std::size_t i, std::size_t j) { return contacts.effect(held[i].row, held[j].row); };
  const auto scaled = [&](std::size_t i, std::size_t j) {
    return effect(i, j) / sqrt(effect(i, i) * effect(j, j));
  };
  const LinearSystem<Real> system(size, scaled);
  ShortNumbers<Real> sums(size, 0), inverse_sums(size, 0);
  for (std::size_t j = 0; j < size; ++j) {
    ShortNumbers<Real> unit(size, 0);
    unit[j] = 1;
    const ShortNumbers<Real> column = system.solve(unit);
    for (std::size_t i = 0; i < size; ++i) {
      sums[i] += abs(scaled(i, j));
      inverse_sums[i] += abs(column[i]);
    }
  }
  return 1 / (*std::ranges::max_element(sums) * *std::ranges::max_element(inverse_sums));
}

/// Whether contact forces and half-sizes, to which poses round, keep so many digits of a number type.
template <class Real>
bool keeps_digits(const ContactModel<Real>& stack, int digits) {
  Real smallest = std::numeric_limits<Real>::infinity();
  for (const Block& block : stack.blocks)
    smallest = std::min<Real>(smallest, std::min(block.half_width, block.half_height));
  return std::min<Real>(conditioning(stack), smallest / stack.height()) >=
         pow(Real(10), digits) * std::numeric_limits<Real>::epsilon();
}

}  // namespace rockstack
