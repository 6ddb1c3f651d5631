#pragma once

#include "analytic/unilateral/contact/contact_modes.hpp"

namespace rockstack {

// Poisson's law. An impact has two phases. Compression is the impact without bounce, whose points take normal
// impulses Λ_C. Expansion gives e Λ_C back, and more where a point would go through its face: 0 ≤ Λ_E − e Λ_C
// ⟂ u_N ≥ 0. Each phase rubs by Coulomb's law, |Λ_T| ≤ μ Λ_N (Glocker & Pfeiffer 1995, Nonlinear Dynamics 7,
// 471–497; Anitescu & Potra 1997, Nonlinear Dynamics 14, 231–247).
//
// Energy never grows. With a·b for aᵀ W M⁻¹ Wᵀ b of impulses, T their parts along faces, and slips s_C and
// s_E after the phases, twice the change is
//   −Λ_C·Λ_C + 2e Λ_C·Λ_E − Λ_E·Λ_E + 2(1 + e) s_CᵀT_C + 2 s_Eᵀ(T_E − e T_C).
// No part is positive: the first three are at most −(|Λ_C| − |Λ_E|)², and at each point friction takes |s_E|
// μ Λ_E, while e T_C gives no more than |s_E| μ e Λ_C.

/// Normal impulses of the points of an interface that touched, left first, in the mode that followed.
template <class Real>
ShortVector<Real> point_impulses(const ContactModel<Real>& stack, int interface, const Joint<Real>& touching,
                                 const Joint<Real>& joint, const ContactForce<Real>& impulse) {
  if (touching.touch != Contact::closed) return {impulse.normal};
  if (joint.touch != Contact::closed)
    return {joint.side() < 0 ? impulse.normal : Real(0), joint.side() > 0 ? impulse.normal : Real(0)};
  const auto [left, right] = overlap(stack, interface, joint.offset);
  return {(impulse.normal * right + impulse.moment) / (right - left),
          (-impulse.normal * left - impulse.moment) / (right - left)};
}

/// The expansion after a compression of `touching` to `compressed`, whose response, but for moments, becomes
/// that of both. The mode after it; nothing where no impulses end it. Corners stay on the faces on which they
/// are compressed; of several solutions, the one of Lemke's method. What slides by rounding is told to slide.
template <class Real>
std::optional<Joints<Real>> expand(const ContactProblem<Real>& problem, Joints<Real> touching,
                                   const Joints<Real>& compressed, ModeResponse<Real>& response) {
  const ContactModel<Real>& stack = problem.stack;
  for (std::size_t k = 0; k < touching.size(); ++k)
    if (touching[k].pivots() && compressed[k].pivots()) touching[k] = compressed[k];
  const TouchingContacts<Real> contacts(problem, touching);
  ShortNumbers<Real> given;
  for (const TouchingInterface<Real>& contact : contacts.interfaces()) {
    const int k = contact.interface;
    const ShortVector<Real> points = point_impulses(stack, k, touching[k], compressed[k], response.forces[k]);
    given.push_back(0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Real back = stack.restitution * std::max<Real>(points[i], 0);
      contacts.act({contact.point(i)}, back, response.motion);
      given.back() += back;
    }
  }
  const FreeVector<Real> free = response.motion;
  const ContactProblem<Real> expansion{stack, problem.bodies, free, problem.level};
  const TouchingContacts<Real> expanding(expansion, touching);
  auto found = solve_coulomb_lcp<Real>(expanding, touching, given);
  if (!found) return std::nullopt;
  std::size_t at = 0;
  for (std::size_t c = 0; c < given.size(); ++c) {
    const TouchingInterface<Real>& contact = contacts.interfaces()[c];
    ContactForce<Real>& impulse = response.forces[contact.interface];
    impulse.normal += given[c];
    for (std::size_t i = 0; i < contact.points(); ++i) {
      contacts.act({contact.point(i)}, found->unknowns[at], response.motion);
      impulse.normal += found->unknowns[at++];
    }
    if (contact.friction == 0) continue;
    const Real tangential = found->unknowns[at] - found->unknowns[at + 1];
    contacts.act({contact.slip()}, tangential, response.motion);
    impulse.tangential += tangential;
    at += 3;
  }
  for (const TouchingInterface<Real>& contact : contacts.interfaces()) {
    Joint<Real>& joint = found->mode[contact.interface];
    if (contact.friction == 0 && joint.touches())
      joint.slip = contacts.row(contact.slip()).dot(response.motion) > 0 ? 1 : -1;
  }
  return std::move(found->mode);
}

}  // namespace rockstack
