#pragma once

#include "analytic/unilateral/series/guards.hpp"

namespace rockstack {

/// Which joints have just parted or started to slide from rest by a decision: their guards start at zero.
template <class Real>
class RecentChanges {
 public:
  explicit RecentChanges(std::size_t size) : joints_(size) {}

  /// A decision from `joined` joints, `before` before it. What returns to its joint has not parted.
  void mark(const Joints<Real>& before, const Joints<Real>& joined, const Joints<Real>& after,
            const Real& time) {
    for (std::size_t k = 0; k < after.size(); ++k) {
      Fresh& fresh = joints_[k];
      if (before[k].slip == 0 && after[k].slip != 0) fresh.slid = time;
      const auto stays = [&](const Joint<Real>& joint) { return joint.touch == after[k].touch; };
      if (stays(before[k]) || stays(joined[k]) || !before[k].touches()) continue;
      fresh.parted = time;
      fresh.parted_from = joined[k];
      fresh.parted_to = after[k].touch;
      fresh.struck = false;
    }
  }

  /// An impact of `touching`, after which points of a law that bounces may have done so.
  void mark_impact(const Joints<Real>& touching, const Joints<Real>& after, const Real& time, bool bounces) {
    for (std::size_t k = 0; k < after.size(); ++k) {
      joints_[k].struck = true;
      if (!bounces || !touching[k].touches() || after[k].touches()) continue;
      joints_[k].bounced = time;
      joints_[k].bounced_from = touching[k];
    }
  }

  /// Whether a corner has bounced last, so that within rounding it is on its face: else a step that another
  /// event starts would give it a height to fall from, and its series of bounces no end.
  bool bounced(const Guard<Real>& guard) const {
    const Fresh& fresh = joints_[guard.interface];
    return guard.change == Change::landing && fresh.bounced > fresh.parted &&
           may_be(guard, fresh.bounced_from);
  }

  /// Whether a guard may start at zero by a decision at this time; `decided`: the last event was there.
  bool starts(const Guard<Real>& guard, const Real& time, bool decided) const {
    const Fresh& fresh = joints_[guard.interface];
    if (guard.change == Change::force || guard.change == Change::corner) return decided;
    if (guard.change == Change::halt) return fresh.slid == time;
    if (guard.change == Change::closing) return fresh.parted == time;
    return guard.change == Change::landing && fresh.parted == time && may_be(guard, fresh.parted_from);
  }

  /// Joints as before they parted, where that was at most `window` s ago, without an impact since that has
  /// parted them faster than `slow`, m/s. What slides faster slides on.
  Joints<Real> joined(const ContactModel<Real>& stack, const Bodies<Real>& bodies, Joints<Real> joints,
                      const Real& time, const Real& window, const Real& slow) const {
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const Fresh& fresh = joints_[k];
      if (fresh.parted < 0 || time - fresh.parted > window || joints[k].touch != fresh.parted_to) continue;
      Joint<Real> back = joints[k];
      back.touch = fresh.parted_from.touch;
      back.corner_below = fresh.parted_from.corner_below;
      if (fresh.parted_to == Contact::apart) {
        const FreeVector<Real> rates = vector_of(bodies.velocity);
        const ContactKinematics<Real> rows = kinematics_of(stack, bodies, static_cast<int>(k), back);
        if (fresh.struck && abs(rows.gap_row.dot(rates)) > slow) continue;
        const Real slip = rows.slip_row.dot(rates);
        back.slip = (slip > slow) - (slip < -slow);
        if (back.slip != 0) back.offset = offset_of(stack, bodies, static_cast<int>(k), back);
      }
      joints[k] = back;
    }
    return joints;
  }

 private:
  /// Whether the corner of a landing is one at which a joint has touched.
  static bool may_be(const Guard<Real>& guard, const Joint<Real>& joint) {
    return !joint.pivots() || joint.side() == guard.side;
  }

  struct Fresh {
    Real parted = -1, slid = -1, bounced = -1;  ///< when, s
    Joint<Real> parted_from, bounced_from;      ///< what it was before
    Contact parted_to = Contact::closed;
    bool struck = false;  ///< since, so that it may part faster than by a decision
  };
  std::vector<Fresh> joints_;
};

/// Angles below it are flat, rad: the ends of a face are apart by roundings of places along it then.
template <class Real>
inline const Real flat_angle = tolerance<Real>(1e-13);

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
  for (std::size_t i = 0; i + 1 < shifted.terms; ++i)
    for (std::size_t j = shifted.terms - 1; j > i; --j) shifted[j - 1] += first * shifted[j];
  rescale<Real>(shifted, 1 - first);
  return shifted;
}

/// Whether a corner is on its face, to rounding, and not about to pass an end; the ground has none.
template <class Real>
bool is_over_face(const Guard<Real>& guard, const Real& s) {
  const auto is_inside = [&](const Polynomial<Real>& within) {
    const auto [distance, slope] = tangent(within, s);
    return distance > guard.rounding || (distance >= -guard.rounding && slope >= 0);
  };
  return guard.within.terms == 0 || (is_inside(guard.within) && is_inside(guard.within_other));
}

/// Whether a guard that is negative from s on ends its step: corners may be beside a face, and come back.
template <class Real>
bool ends_step(const ModeSeries<Real>& series, const Guard<Real>& guard, const Real& s) {
  if (guard.change == Change::landing) {
    // The block above leans to the corner.
    const int k = guard.interface;
    const Real angle =
        value(series.bodies[k].angle, s) - (k > 0 ? value(series.bodies[k - 1].angle, s) : Real(0));
    if (guard.side * angle < -flat_angle<Real>) return false;
    return is_over_face(guard, s);
  }
  if (guard.change == Change::strike) return is_over_face(guard, s);
  return guard.change != Change::fall || guard.other.terms == 0 || value(guard.other, s) < 0;
}

/// The changes that end a step. Guards that a decision at `time` starts at zero are seen from `skipped` on.
template <class Real>
FirstChange<Real> first_change(std::vector<Guard<Real>> guards, const ModeSeries<Real>& series,
                               const RecentChanges<Real>& fresh, const Real& time, bool decided,
                               const Real& skipped) {
  FirstChange<Real> found;
  for (Guard<Real>& guard : guards) {
    Polynomial<Real>& whole = guard.series;
    const bool starts = fresh.starts(guard, time, decided);
    Real first = starts ? skipped : Real(0);
    // Beside its face a corner may be lower, and come up before it meets it. Over its face it is lower where
    // blocks below were put on each other, and is on it then.
    const bool over =
        guard.change == Change::landing && whole[0] >= -guard.sunk && is_over_face(guard, Real(0));
    const bool lower =
        !over && (guard.change == Change::landing || guard.within.terms > 0) && whole[0] < -guard.rounding;
    if (lower) {
      const std::optional<Real> above = first_crossing(times(-1, whole));
      if (!above) continue;
      first = *above;
    } else if (guard.change == Change::landing &&
               whole[0] <= (starts || fresh.bounced(guard) ? guard.rounding : Real(0))) {
      // A corner that has not just parted may come down from within rounding above the face.
      whole[0] = 0;
    }
    Polynomial<Real> rest = first > 0 ? from(whole, first) : whole;
    if (lower) rest[0] = 0;
    std::optional<Real> crossing = first_crossing(rest);
    if (crossing) *crossing = first + (1 - first) * *crossing;
    if (!crossing || *crossing > found.s || !ends_step(series, guard, *crossing)) continue;
    if (*crossing < found.s) found = {*crossing, {}};
    found.guards.push_back(std::move(guard));
  }
  return found;
}

}  // namespace rockstack
