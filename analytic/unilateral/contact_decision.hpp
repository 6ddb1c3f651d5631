#pragma once

#include "analytic/unilateral/contact/contact_modes.hpp"
#include "analytic/unilateral/contact_history.hpp"

namespace rockstack {

/// The lowest interface that differs, from 1, and how.
template <class Real>
int lowest_change(const Joints<Real>& from, const Joints<Real>& to) {
  std::size_t k = 0;
  while (k + 1 < from.size() && from[k].same_mode(to[k])) ++k;
  return static_cast<int>(k) + 1;
}

/// What a change of contacts without impact is called.
template <class Real>
EventKind kind_of(const Joints<Real>& from, const Joints<Real>& to) {
  const auto any = [&](const auto& changed) {
    for (std::size_t k = 0; k < from.size(); ++k)
      if (changed(from[k], to[k])) return true;
    return false;
  };
  if (any([](const BasicJoint<Real>& a, const BasicJoint<Real>& b) { return a.touches() && !b.touches(); }))
    return EventKind::lift_off;
  if (any([](const BasicJoint<Real>& a, const BasicJoint<Real>& b) { return a.touch != b.touch; }))
    return EventKind::opening;
  if (any([](const BasicJoint<Real>& a, const BasicJoint<Real>& b) { return a.slip == 0 && b.slip != 0; }))
    return EventKind::slip;
  return EventKind::stick;
}

/// Whether friction at a pivot may turn it onto its face: G_NN ≤ μ |G_NT|. Without that one mode obeys.
template <class Real>
bool couples(const BasicFrictionStack<Real>& stack, const Joints<Real>& joints,
             const BasicBodies<Real>& bodies, std::size_t interface) {
  using std::abs;
  if (!joints[interface].pivots()) return false;
  const BasicPointRows<Real> rows =
      rows_of(stack.blocks, bodies, held_point(stack.blocks, static_cast<int>(interface), joints[interface]));
  const auto dot = [&](const FreeRow<Real>& a, const FreeRow<Real>& b) -> Real {
    return (a.array() * stack.inverse_mass.transpose().array() * b.array()).sum();
  };
  return dot(rows.gap_row, rows.gap_row) <= stack.friction[interface] * abs(dot(rows.gap_row, rows.slip_row));
}

/// Whether accelerations other than those of a mode obey as well, where there are few to try.
template <class Real>
bool has_others(const BasicFrictionStack<Real>& stack, const Joints<Real>& joints, const Joints<Real>& mode,
                const BasicBodies<Real>& bodies, const BasicFreeVector<Real>& free) {
  if (faces_differ(stack, joints, mode, bodies, free, Sought::accelerations)) return true;
  bool any = false;
  for (std::size_t k = 0; k < joints.size(); ++k) any = any || couples(stack, joints, bodies, k);
  if (!any) return false;
  constexpr std::size_t most = 200;
  const auto motion_of = [&](const Joints<Real>& held) -> BasicFreeVector<Real> {
    return respond(stack, held, bodies, free, Sought::accelerations).motion;
  };
  const BasicFreeVector<Real> motion = motion_of(mode);
  const Real same = Real(1e-6) * free.template lpNorm<Eigen::Infinity>();
  for (const auto& other : modes_that_obey(stack, joints, bodies, free, Sought::accelerations, most))
    if ((motion_of(other) - motion).template lpNorm<Eigen::Infinity>() > same) return true;
  return false;
}

}  // namespace rockstack
