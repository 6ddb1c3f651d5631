#pragma once

#include <algorithm>
#include <cmath>

#include "analytic/polynomials/crossing.hpp"
#include "analytic/scene/history.hpp"
#include "analytic/unilateral/contact/contact_problem.hpp"
#include "analytic/unilateral/series/mode_series.hpp"

namespace rockstack {

/// Takes what one interface bears at one time into account. Where the normal force is `rounding` or less, it
/// is zero, and nothing rubs.
template <class Real>
void note_bearing(BasicDemand<Real>& demand, const Real& normal, const Real& tangential, const Real& rounding,
                  const Real& time) {
  using std::abs;
  const bool bears = normal > rounding;
  if (const Real pushed = bears ? normal : Real(0); pushed < demand.least_normal) {
    demand.least_normal = pushed;
    demand.least_normal_time = time;
  }
  if (const Real ratio = bears ? Real(abs(tangential) / normal) : Real(0); ratio > demand.friction) {
    demand.friction = ratio;
    demand.friction_time = time;
  }
}

/// What acts at the interfaces over a motion: the least normal force, which is zero where blocks part, and
/// the largest ratio of tangential to normal force. No interface pulls or bears more than its friction.
template <class Real>
class ContactDemands {
 public:
  ContactDemands(const Scene& scene, std::size_t interfaces) : forces_(interfaces), impulses_(interfaces) {
    using std::sqrt;
    Real mass = 0;
    Real height = 0;
    for (const Block& block : scene.blocks) {
      mass += block.mass;
      height += 2 * block.half_height;
    }
    rounding_ = 1024 * std::numeric_limits<Real>::epsilon() * mass * scene.gravity;
    negligible_impulse_ = Real(1e-6) * mass * sqrt(scene.gravity * height);
  }

  /// A step up to `end` of its length; `start` in s.
  void note_step(const Joints<Real>& joints, const ModeSeries<Real>& series, const Real& end,
                 const Real& start) {
    for (std::size_t k = 0; k < forces_.size(); ++k) {
      if (!joints[k].touches()) {
        note_bearing<Real>(forces_[k], 0, 0, rounding_, start);
        continue;
      }
      ForceSeries<Real> force = series.forces[k];
      for (Polynomial<Real>* part : {&force.normal, &force.tangential})
        for (Real& coefficient : *part) coefficient *= series.force_unit;
      note_along(forces_[k], force, end, start, series.length);
    }
  }

  /// Impulses of one impact. Of less than a millionth of the momentum that the stack has after falling its
  /// own size, those of chatter, nothing is told.
  void note_impact(const std::vector<BasicContactForce<Real>>& impulses, const Real& time) {
    for (std::size_t k = 0; k < impulses_.size(); ++k) {
      const BasicContactForce<Real>& impulse = impulses[k];
      if (impulse.normal > negligible_impulse_)
        note_bearing(impulses_[k], impulse.normal, impulse.tangential, negligible_impulse_, time);
    }
  }

  const std::vector<BasicDemand<Real>>& forces() const { return forces_; }
  const std::vector<BasicDemand<Real>>& impulses() const { return impulses_; }

 private:
  /// To rounding: where the normal force is least, and where ±T/N is largest. The latter is the ratio μ at
  /// which the maximum of ±T − μN comes down to zero (Dinkelbach 1967, Management Science 13, 492–498).
  void note_along(BasicDemand<Real>& demand, const ForceSeries<Real>& force, const Real& end,
                  const Real& start, const Real& length) const {
    const auto note_at = [&](const Real& s) {
      note_bearing<Real>(demand, value(force.normal, s), value(force.tangential, s), rounding_,
                         start + s * length);
    };
    // Where normal · N + tangential · T passes `least` most.
    const auto note_maximum = [&](const Real& normal, const Real& tangential, const Real& least,
                                  const Real& slack) {
      Polynomial<Real> sum;
      add(force.normal, normal, sum);
      add(force.tangential, tangential, sum);
      rescale(sum, end);
      if (const auto top = maximum(sum, least, slack)) note_at(top->s * end);
    };
    note_maximum(-1, 0, rounding_ - demand.least_normal, rounding_);
    for (const Real& side : {Real(1), Real(-1)}) {
      for (Real before = -1; demand.friction > before;) {
        before = demand.friction;
        const Real negligible = rounding_ * (1 + before);
        note_maximum(-before, side, negligible, negligible);
      }
    }
  }

  std::vector<BasicDemand<Real>> forces_, impulses_;
  Real rounding_{};            ///< of forces, N
  Real negligible_impulse_{};  ///< N·s
};

}  // namespace rockstack
