#pragma once

#include "analytic/polynomials/crossing.hpp"
#include "analytic/unilateral/series/guards.hpp"

namespace rockstack {

/// Which joints have just parted, or started to slide, from rest by a decision: their guards start at zero
/// to rounding.
template <class Real>
class FreshJoints {
 public:
  explicit FreshJoints(std::size_t size)
      : parted_(size, Real(-1)),
        slid_(parted_),
        bounced_(parted_),
        parted_from_(size),
        bounced_from_(size),
        parted_to_(size) {}

  /// A decision from `joined` joints, which were `before` it. What only comes back to what it was joined to
  /// has not parted.
  void mark(const Joints<Real>& before, const Joints<Real>& joined, const Joints<Real>& after,
            const Real& time) {
    for (std::size_t k = 0; k < after.size(); ++k) {
      if (before[k].slip == 0 && after[k].slip != 0) slid_[k] = time;
      const auto stays = [&](const Joint<Real>& joint) { return joint.touch == after[k].touch; };
      if (stays(before[k]) || stays(joined[k]) || !before[k].touches()) continue;
      parted_[k] = time;
      parted_from_[k] = joined[k];
      parted_to_[k] = after[k].touch;
    }
  }

  /// An impact of `touching`, after which points have bounced.
  void mark_bounces(const Joints<Real>& touching, const Joints<Real>& after, const Real& time) {
    for (std::size_t k = 0; k < after.size(); ++k)
      if (touching[k].touches() && !after[k].touches()) {
        bounced_[k] = time;
        bounced_from_[k] = touching[k];
      }
  }

  /// Whether a corner has just bounced, so that it starts on its face, whatever roundings put it at.
  bool bounced(const Guard<Real>& guard, const Real& time) const {
    const auto k = static_cast<std::size_t>(guard.interface);
    return guard.change == Change::landing && bounced_[k] == time && may_be(guard, bounced_from_[k]);
  }

  /// Whether a guard may start at zero because of what was decided at this time; `decided` tells whether the
  /// last event was there.
  bool starts(const Guard<Real>& guard, const Real& time, bool decided) const {
    const auto k = static_cast<std::size_t>(guard.interface);
    switch (guard.change) {
      case Change::force:
      case Change::corner:
        return decided;
      case Change::halt:
        return slid_[k] == time;
      case Change::closing:
        return parted_[k] == time;
      case Change::landing:
        return parted_[k] == time && may_be(guard, parted_from_[k]);
      default:
        return false;
    }
  }

  /// Joints as they were before they parted, where that was `window` s ago or less and they have not met
  /// since.
  Joints<Real> joined(Joints<Real> joints, const Real& time, const Real& window) const {
    for (std::size_t k = 0; k < joints.size(); ++k) {
      if (parted_[k] < 0 || time - parted_[k] > window || joints[k].touch != parted_to_[k]) continue;
      joints[k].touch = parted_from_[k].touch;
      joints[k].corner_below = parted_from_[k].corner_below;
    }
    return joints;
  }

 private:
  /// Whether the corner of a landing is one at which a joint has touched.
  static bool may_be(const Guard<Real>& guard, const Joint<Real>& joint) {
    return !joint.pivots() || joint.side() == guard.side;
  }

  std::vector<Real> parted_, slid_, bounced_;  ///< when, s
  Joints<Real> parted_from_, bounced_from_;    ///< what each joint was before
  std::vector<Touch> parted_to_;
};

/// Angles below it are flat, rad.
template <class Real>
Real flat_angle() {
  return tolerance<Real>(1e-14);
}

/// The first changes of a step, at s of its length.
template <class Real>
struct FirstChange {
  Real s = 1;
  std::vector<Guard<Real>> guards;  ///< those that end there
};

/// p(first + (1 − first) u) as a polynomial in u.
template <class Real>
Polynomial<Real> from(const Polynomial<Real>& polynomial, const Real& first) {
  Polynomial<Real> shifted = polynomial;
  for (std::size_t i = 0; i + 1 < shifted.terms; ++i) {
    for (std::size_t j = shifted.terms - 1; j > i; --j) shifted[j - 1] += first * shifted[j];
  }
  rescale<Real>(shifted, 1 - first);
  return shifted;
}

/// Whether a corner is on its face, to rounding, and not about to pass its end.
template <class Real>
bool is_inside(const Polynomial<Real>& within, const Real& s, const Real& rounding) {
  const auto [distance, slope] = tangent(within, s);
  return distance > rounding || (distance >= -rounding && slope >= 0);
}

/// Whether a corner that meets a face is the one that the block above leans to, and on the face.
template <class Real>
bool lands(const ModeSeries<Real>& series, const Guard<Real>& guard, const Real& s) {
  const auto k = static_cast<std::size_t>(guard.interface);
  const Real angle =
      value(series.bodies[k].angle, s) - (k > 0 ? value(series.bodies[k - 1].angle, s) : Real(0));
  if (guard.side * angle < -flat_angle<Real>()) return false;
  return guard.within.terms == 0 ||
         (is_inside(guard.within, s, guard.rounding) && is_inside(guard.within_other, s, guard.rounding));
}

/// Whether a guard that is negative from s on ends its step: a corner may meet the plane of a face beside it,
/// and what flies may be beyond a face and come back.
template <class Real>
bool ends_step(const ModeSeries<Real>& series, const Guard<Real>& guard, const Real& s) {
  switch (guard.change) {
    case Change::landing:
      return lands(series, guard, s);
    case Change::fall:
      return guard.other.terms == 0 || value(guard.other, s) < 0;
    case Change::strike:
      return guard.within.terms == 0 ||
             (is_inside(guard.within, s, guard.rounding) && is_inside(guard.within_other, s, guard.rounding));
    default:
      return true;
  }
}

/// The changes that end a step. Guards that start at zero by a decision at `time` are looked at from
/// `skipped` of the step on.
template <class Real>
FirstChange<Real> first_change(std::vector<Guard<Real>> guards, const ModeSeries<Real>& series,
                               const FreshJoints<Real>& fresh, const Real& time, bool decided,
                               const Real& skipped) {
  FirstChange<Real> found;
  for (Guard<Real>& guard : guards) {
    Polynomial<Real>& whole = guard.series;
    const bool starts = fresh.starts(guard, time, decided);
    Real first = starts ? skipped : Real(0);
    // Beside its face a corner may be lower, and come up before it meets it.
    const bool lower =
        (guard.change == Change::landing || guard.within.terms > 0) && whole[0] < -guard.rounding;
    if (lower) {
      const std::optional<Real> above = first_crossing(times(-1, whole));
      if (!above) continue;
      first = *above;
    } else if (guard.change == Change::landing &&
               whole[0] <= (starts || fresh.bounced(guard, time) ? guard.rounding : Real(0))) {
      // A corner that has not just parted may come down from within rounding above the face.
      whole[0] = 0;
    }
    Polynomial<Real> rest = first > 0 ? from(whole, first) : whole;
    if (lower) rest[0] = 0;
    std::optional<Real> crossing = first_crossing(rest);
    if (crossing) *crossing = first + (1 - first) * *crossing;
    if (!crossing || *crossing > found.s) continue;
    if (!ends_step(series, guard, *crossing)) continue;
    if (*crossing < found.s) found = {*crossing, {}};
    found.guards.push_back(std::move(guard));
  }
  return found;
}

}  // namespace rockstack
