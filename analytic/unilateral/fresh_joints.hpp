#pragma once

#include "analytic/unilateral/series/contact_course.hpp"

namespace rockstack {

/// Which joints have just parted, or started to slide, from rest by a decision: their courses start at zero
/// to rounding.
template <class Real>
class FreshJoints {
 public:
  explicit FreshJoints(std::size_t size)
      : parted_(size, Real(-1)), slid_(parted_), parted_from_(size), parted_to_(size) {}

  /// A decision from `joined` joints, which were `before` it. What only comes back to what it was joined to
  /// has not parted.
  void mark(const Joints<Real>& before, const Joints<Real>& joined, const Joints<Real>& after,
            const Real& time) {
    for (std::size_t k = 0; k < after.size(); ++k) {
      if (before[k].slip == 0 && after[k].slip != 0) slid_[k] = time;
      const auto stays = [&](const BasicJoint<Real>& joint) { return joint.touch == after[k].touch; };
      if (stays(before[k]) || stays(joined[k]) || !before[k].touches()) continue;
      parted_[k] = time;
      parted_from_[k] = joined[k];
      parted_to_[k] = after[k].touch;
    }
  }

  /// Whether a course may start at zero because of what was decided at this time; `decided` tells whether the
  /// last event was there.
  bool starts(const Course<Real>& course, const Real& time, bool decided) const {
    const auto k = static_cast<std::size_t>(course.interface);
    switch (course.change) {
      case Change::force:
      case Change::corner:
        return decided;
      case Change::halt:
        return slid_[k] == time;
      case Change::closing:
        return parted_[k] == time;
      case Change::landing:
        return parted_[k] == time && (!parted_from_[k].pivots() || parted_from_[k].side() == course.side);
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
  std::vector<Real> parted_, slid_;  ///< when, s
  Joints<Real> parted_from_;         ///< what each joint was before
  std::vector<Touch> parted_to_;
};

}  // namespace rockstack
