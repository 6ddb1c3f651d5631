#pragma once

#include <vector>

#include "analytic/polynomials/crossing.hpp"
#include "analytic/scene/history.hpp"
#include "analytic/steps/dense_output.hpp"

namespace rockstack {

/// Where a gap or margin comes within rounding of zero and goes again, so that rounding decides whether it
/// crosses; nothing where it clearly does, or clearly does not, and where the step starts or ends that close.
/// `crossing` is its first crossing. Precondition: it has terms.
template <class Real>
std::optional<Real> grazing(const Polynomial<Real>& course, const std::optional<Real>& crossing) {
  const Real extent = reach(course);
  const Real rounding = 16 * std::numeric_limits<Real>::epsilon() * (course[0] + extent);
  if (course[0] - extent > rounding || course[0] <= rounding || value(course, Real(1)) <= rounding)
    return std::nullopt;
  Polynomial<Real> shifted = course;
  shifted[0] += crossing ? rounding : -rounding;
  const std::optional<Real> other = first_crossing(shifted);
  if (crossing) return other ? std::nullopt : crossing;
  return other;
}

/// What comes first within a step, at s of its length; nothing, at s = 1, where neither an interface closes
/// or opens nor a block topples.
template <class Real>
struct Next {
  Real s = 1;
  Interfaces closing;
  Interfaces opening;
  Pattern opened;                        ///< the sides that opening interfaces open to
  int toppling = -1;                     ///< block, from 0
  std::vector<BasicGraze<Real>> grazes;  ///< with s of the step for the time

  bool happens() const { return closing.any() || opening.any() || toppling >= 0; }

  /// Makes room for an event at `crossing`: earlier than all so far, or at the same time. False where it is
  /// later.
  bool admit(const std::optional<Real>& crossing) {
    if (!crossing || *crossing > s) return false;
    if (*crossing < s) *this = Next{*crossing, {}, {}, opened, -1, std::move(grazes)};
    return true;
  }
};

/// How far an open interface is open, as a polynomial.
template <class Real, int N>
Polynomial<Real> gap(const Flow<Real, N>& flow, int interface) {
  Polynomial<Real> polynomial = flow.angles[static_cast<std::size_t>(interface)];
  for (Real& coefficient : polynomial) coefficient *= Real(sign(flow.start.pattern[interface]));
  return polynomial;
}

/// The hulls of relative angles beyond zero; of closed interfaces nothing.
template <class Real, int N>
using AngleHulls = std::array<Hull<Real>, capacity(N)>;

template <class Real, int N>
void find_closing(const Flow<Real, N>& flow, const AngleHulls<Real, N>& hulls, const Interfaces& cleared,
                  Next<Real>& next) {
  const Pattern& pattern = flow.start.pattern;
  std::array<Polynomial<Real>, capacity(N)> gaps;  // of interfaces that may close
  for (int k = 0; k < flow.start.size(); ++k) {
    const auto interface = static_cast<std::size_t>(k);
    if (pattern[k] == Contact::closed || cleared.test(interface)) continue;
    if (stays_clear(flow.angles[interface], hulls[interface], sign(pattern[k]))) continue;
    const Polynomial<Real>& course = gaps[interface] = gap(flow, k);
    const auto crossing = first_crossing(course);
    if (next.admit(crossing)) next.closing.set(interface);
    if (const auto s = grazing(course, crossing)) next.grazes.push_back({*s, EventKind::impact, k + 1});
  }
  if (next.closing.none()) return;
  // What rounding has carried past zero by then closes at the same time.
  for (int k = 0; k < flow.start.size(); ++k) {
    const auto interface = static_cast<std::size_t>(k);
    if (gaps[interface].terms > 0 && value(gaps[interface], next.s) < 0) next.closing.set(interface);
  }
}

template <class Real, int N>
void find_opening(const Flow<Real, N>& flow, Next<Real>& next) {
  for (int k = 0; k < flow.start.size(); ++k) {
    const auto& margin = flow.margins[static_cast<std::size_t>(k)];
    for (const Contact side : {Contact::right, Contact::left}) {
      const Polynomial<Real>& course = side == Contact::right ? margin.right : margin.left;
      if (course.terms == 0 || stays_clear(course, hull_beyond_zero(course))) continue;
      const auto crossing = first_crossing(course);
      if (const auto s = grazing(course, crossing)) next.grazes.push_back({*s, EventKind::opening, k + 1});
      if (!next.admit(crossing)) continue;
      next.opening.set(static_cast<std::size_t>(k));
      next.opened[k] = side;
    }
  }
}

template <class Real, int N>
void find_toppling(const Flow<Real, N>& flow, const AngleHulls<Real, N>& hulls,
                   const std::array<Real, max_blocks>& toppling_angles, const Interfaces& cleared,
                   Next<Real>& next) {
  Real lean = 0;  // of the block, at most
  for (int k = 0; k < flow.start.size(); ++k) {
    const auto block = static_cast<std::size_t>(k);
    lean += hulls[block].size();
    if (cleared.test(block) || lean < toppling_angles[block]) continue;
    for (const Contact side : {Contact::right, Contact::left}) {
      Polynomial<Real> room{toppling_angles[block]};
      for (std::size_t j = 0; j <= block; ++j) add(flow.angles[j], -Real(sign(side)), room);
      const auto crossing = first_crossing(room);
      if (crossing && *crossing < next.s && next.admit(crossing)) next.toppling = k;
    }
  }
}

/// Finds the first event in a step.
template <class Real, int N>
Next<Real> first_event(const Flow<Real, N>& flow, const std::array<Real, max_blocks>& toppling_angles,
                       const Cleared& cleared = {}) {
  Next<Real> next;
  next.opened = flow.start.pattern;
  AngleHulls<Real, N> hulls{};
  for (int k = 0; k < flow.start.size(); ++k) {
    const Polynomial<Real>& angle = flow.angles[static_cast<std::size_t>(k)];
    if (angle.terms > 0) hulls[static_cast<std::size_t>(k)] = hull_beyond_zero(angle);
  }
  find_closing(flow, hulls, cleared.gaps, next);
  find_opening(flow, next);
  find_toppling(flow, hulls, toppling_angles, cleared.angles, next);
  return next;
}

}  // namespace rockstack
