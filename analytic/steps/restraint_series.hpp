#pragma once

#include "analytic/mechanics/linkage.hpp"
#include "analytic/polynomials/crossing.hpp"
#include "analytic/scene/history.hpp"
#include "analytic/scene/restraint_law.hpp"

namespace rockstack {

/// A restraint along a step: its length ℓ, from ℓ² = |apart|², and the force on the body that it leads from,
/// T u, u = apart/ℓ; both order by order.
template <class Real>
struct GrowingRestraint {
  RestraintLaw<Real> law;
  Real step{};  ///< length of the step, s
  Polynomial<Real> apart_x{}, apart_y{}, length{}, unit_x{}, unit_y{}, pull{}, force_x{}, force_y{};

  /// Order m of the length; `apart_at` has each order of the way from one point to the other, m.
  template <class Apart>
  void extend_length(std::size_t m, const Apart& apart_at) {
    const PlaneVector<Real> apart = apart_at(m);
    put(apart_x, m, apart.x);
    put(apart_y, m, apart.y);
    apart_x.terms = apart_y.terms = m + 1;
    Real square = convolution(apart_x, apart_x, m) + convolution(apart_y, apart_y, m);
    for (std::size_t i = 1; i < m; ++i) square -= length[i] * length[m - i];
    put(length, m, m == 0 ? Real(sqrt(square)) : Real(square / (2 * length[0])));
    length.terms = m + 1;
  }

  /// Order n of the force, times the step's length squared, N·s².
  template <class Apart>
  void extend(std::size_t n, const Apart& apart_at) {
    if (n == 0) extend_length(0, apart_at);
    extend_length(n + 1, apart_at);
    extend_unit(n);
    Real own = n == 0 ? law.force(length[0], Real(0)) : Real(0);
    if (n > 0 && law.stretch == Stretch::elastic) own = law.stiffness * length[n];
    put(pull, n, own + law.damping * Real(n + 1) * length[n + 1] / step);
    pull.terms = n + 1;
    put(force_x, n, step * step * convolution(pull, unit_x, n));
    put(force_y, n, step * step * convolution(pull, unit_y, n));
    force_x.terms = force_y.terms = n + 1;
  }

 private:
  void extend_unit(std::size_t n) {
    Real x = apart_x[n], y = apart_y[n];
    for (std::size_t i = 1; i <= n; ++i) {
      x -= length[i] * unit_x[n - i];
      y -= length[i] * unit_y[n - i];
    }
    put(unit_x, n, x / length[0]);
    put(unit_y, n, y / length[0]);
    unit_x.terms = unit_y.terms = n + 1;
  }
};

/// The first restraint whose stretch ends within a step, at s of it, and what follows; none: −1.
template <class Real>
struct RestraintChange {
  Real s = 1;
  int restraint = -1;
  Stretch next = Stretch::elastic;
};

/// From lengths along a step. A force that has grown to the yield force stays there as long as the length
/// does not fall; one that has fallen to zero as long as the length is shorter. What ends the last stretch is
/// at zero where this one starts, and at the end of yielding its rate too.
template <class Real>
RestraintChange<Real> first_change(const std::vector<RestraintLaw<Real>>& laws,
                                   const std::vector<Polynomial<Real>>& lengths) {
  RestraintChange<Real> first;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const RestraintLaw<Real>& law = laws[i];
    if (law.stiffness == 0) continue;
    const Real rounding = Real(1e-9) * law.stiffness * law.length;
    const auto consider = [&](Polynomial<Real> guard, std::size_t zeros, Stretch next) {
      for (std::size_t n = 0; law.at_end && n < zeros && abs(guard[0]) <= rounding; ++n) guard[n] = 0;
      const auto crossing = first_crossing(guard);
      if (crossing && (*crossing < first.s || first.restraint < 0))
        first = {*crossing, static_cast<int>(i), next};
    };
    const Polynomial<Real> force = line(law.elastic(Real(0)), law.stiffness, lengths[i]);
    if (law.stretch == Stretch::slack) consider(times(-1, force), 1, Stretch::elastic);
    if (law.stretch == Stretch::yields) consider(derivative(lengths[i]), 0, Stretch::elastic);
    if (law.stretch != Stretch::elastic) continue;
    consider(force, 1, Stretch::slack);
    if (law.yield < std::numeric_limits<Real>::infinity())
      consider(line(law.yield, -1, force), 2, Stretch::yields);
  }
  return first;
}

/// Lets a restraint go on in its next stretch, at a length; the event that it is.
template <class Real>
EventKind take(const RestraintChange<Real>& change, const Real& length, RestraintLaw<Real>& law) {
  const Stretch before = law.stretch;
  if (before == Stretch::yields) law.unload(length);
  law.stretch = change.next;
  law.at_end = true;
  if (change.next == Stretch::slack) return EventKind::slack;
  if (change.next == Stretch::yields) return EventKind::yield;
  return before == Stretch::slack ? EventKind::taut : EventKind::unload;
}

}  // namespace rockstack
