#pragma once

#include "analytic/polynomials/crossing.hpp"
#include "analytic/scene/history.hpp"
#include "analytic/steps/dense_output.hpp"

namespace rockstack {

/// Where an opening angle or a margin comes within rounding of zero and goes again, so that rounding decides
/// whether it crosses; nothing where it clearly does, or clearly does not, and where the step starts or ends
/// that close. `crossing` is its first crossing. Precondition: it has terms.
template <class Real>
std::optional<Real> grazing(const Polynomial<Real>& guard, const std::optional<Real>& crossing) {
  const Real extent = reach(guard);
  const Real rounding = 16 * std::numeric_limits<Real>::epsilon() * (guard[0] + extent);
  if (guard[0] - extent > rounding || guard[0] <= rounding || value(guard, Real(1)) <= rounding)
    return std::nullopt;
  Polynomial<Real> shifted = guard;
  shifted[0] += crossing ? rounding : -rounding;
  const std::optional<Real> other = first_crossing(shifted);
  if (crossing) return other ? std::nullopt : crossing;
  return other;
}

/// What comes first within a step, at s of its length; nothing, at s = 1, where neither an interface closes
/// or opens nor a block topples.
template <class Real>
struct FirstEvent {
  Real s = 1;
  Interfaces closing;
  Interfaces opening;
  Pattern opened;                        ///< the sides that opening interfaces open to
  int toppling = -1;                     ///< block, from 0
  std::vector<BasicGraze<Real>> grazes;  ///< with s of the step for the time
  Interfaces either;  ///< opening interfaces that carry nothing, for which the other side would do as well

  bool happens() const { return closing.any() || opening.any() || toppling >= 0; }

  /// Makes room for an event at `crossing`, earlier than all so far or with them; false where it is later.
  bool admit(const std::optional<Real>& crossing) {
    if (!crossing || *crossing > s) return false;
    if (*crossing < s) *this = FirstEvent{*crossing, {}, {}, opened, -1, std::move(grazes), {}};
    return true;
  }
};

/// The hulls of relative angles beyond zero; of closed interfaces nothing.
template <class Real, int N>
using AngleHulls = std::array<Hull<Real>, capacity(N)>;

template <class Real, int N>
AngleHulls<Real, N> angle_hulls(const DenseOutput<Real, N>& output) {
  AngleHulls<Real, N> hulls{};
  for (int k = 0; k < output.start.size(); ++k) {
    const Polynomial<Real>& angle = output.angles[k];
    if (angle.terms > 0) hulls[k] = hull_beyond_zero(angle);
  }
  return hulls;
}

template <class Real, int N>
void find_closing(const DenseOutput<Real, N>& output, const AngleHulls<Real, N>& hulls,
                  const Interfaces& cleared, FirstEvent<Real>& event) {
  const Pattern& pattern = output.start.pattern;
  std::array<Polynomial<Real>, capacity(N)> angles;  // opening angles of interfaces that may close
  for (int k = 0; k < output.start.size(); ++k) {
    if (pattern[k] == Contact::closed || cleared.test(k)) continue;
    if (stays_clear(output.angles[k], hulls[k], sign(pattern[k]))) continue;
    Polynomial<Real>& guard = angles[k] = output.angles[k];
    for (Real& coefficient : guard) coefficient *= Real(sign(pattern[k]));
    const auto crossing = first_crossing(guard);
    if (event.admit(crossing)) event.closing.set(k);
    if (const auto s = grazing(guard, crossing)) event.grazes.push_back({*s, EventKind::impact, k + 1});
  }
  if (event.closing.none()) return;
  // What rounding has carried past zero by then closes at the same time.
  for (int k = 0; k < output.start.size(); ++k)
    if (angles[k].terms > 0 && value(angles[k], event.s) < 0) event.closing.set(k);
}

template <class Real, int N>
void find_opening(const DenseOutput<Real, N>& output, FirstEvent<Real>& event) {
  for (int k = 0; k < output.start.size(); ++k) {
    const auto& margin = output.margins[k];
    for (const Contact side : {Contact::right, Contact::left}) {
      const Polynomial<Real>& guard = side == Contact::right ? margin.right : margin.left;
      if (guard.terms == 0 || stays_clear(guard, hull_beyond_zero(guard))) continue;
      const auto crossing = first_crossing(guard);
      if (const auto s = grazing(guard, crossing)) event.grazes.push_back({*s, EventKind::opening, k + 1});
      if (!event.admit(crossing)) continue;
      event.opening.set(k);
      event.opened[k] = side;
      // The margins' sum is the normal force times the width.
      const Polynomial<Real>& other = side == Contact::right ? margin.left : margin.right;
      const Real rounding = 16 * std::numeric_limits<Real>::epsilon() * (abs(other[0]) + reach(other));
      if (value(other, event.s) <= rounding) event.either.set(k);
    }
  }
}

template <class Real, int N>
void find_toppling(const DenseOutput<Real, N>& output, const AngleHulls<Real, N>& hulls,
                   const std::array<Real, max_blocks>& toppling_angles, const Interfaces& cleared,
                   FirstEvent<Real>& event) {
  Real lean = 0;  // of the block, at most
  for (int k = 0; k < output.start.size(); ++k) {
    lean += hulls[k].size();
    if (cleared.test(k) || lean < toppling_angles[k]) continue;
    for (const Contact side : {Contact::right, Contact::left}) {
      Polynomial<Real> room{toppling_angles[k]};
      for (int j = 0; j <= k; ++j) add(output.angles[j], -Real(sign(side)), room);
      const auto crossing = first_crossing(room);
      if (crossing && *crossing < event.s && event.admit(crossing)) event.toppling = k;
    }
  }
}

/// `hulls`: angle_hulls() of the step.
template <class Real, int N>
FirstEvent<Real> first_event(const DenseOutput<Real, N>& output, const AngleHulls<Real, N>& hulls,
                             const std::array<Real, max_blocks>& toppling_angles,
                             const ExcludedEvents& cleared = {}) {
  FirstEvent<Real> event;
  event.opened = output.start.pattern;
  find_closing(output, hulls, cleared.contacts, event);
  find_opening(output, event);
  find_toppling(output, hulls, toppling_angles, cleared.angles, event);
  return event;
}

}  // namespace rockstack
