#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/unilateral/mode_response.hpp"
#include "analytic/unilateral/mode_series.hpp"

namespace rockstack {

/// What acts at the interfaces over a motion: the least normal force, which is zero where blocks part, and
/// the largest ratio of tangential to normal force. No interface pulls or bears more than its friction.
class ContactDemands {
 public:
  ContactDemands(const Scene& scene, std::size_t interfaces);

  /// A step up to `end` of its length; `start` in s.
  void note_step(const std::vector<Joint>& joints, const ModeSeries& series, double end, double start);
  /// Impulses of one impact. Of less than a millionth of the momentum that the stack has after falling its
  /// own size, those of chatter, nothing is told.
  void note_impact(const std::vector<ContactForce>& impulses, double time);

  const std::vector<Demand>& forces() const { return forces_; }
  const std::vector<Demand>& impulses() const { return impulses_; }

 private:
  void note_along(Demand& demand, const ForceSeries& force, double end, double start, double length) const;

  std::vector<Demand> forces_, impulses_;
  double rounding_;            ///< of forces, N
  double negligible_impulse_;  ///< N·s
};

}  // namespace rockstack
