#pragma once

#include <limits>
#include <optional>
#include <utility>

#include "analytic/scene/ground/pulse.hpp"
#include "analytic/unilateral/contact_demands.hpp"
#include "analytic/unilateral/contact_history.hpp"
#include "analytic/unilateral/springs/spring_contacts.hpp"

namespace rockstack {

/// The least gap of blocks that are apart, over all corners that are over a face, m; infinite where there are
/// none, or where one block has turned past a right angle to the other, so that their faces no longer meet.
template <class Real>
Real gap_of(const BasicFrictionStack<Real>& stack, const BasicBodies<Real>& bodies, int interface) {
  using std::abs;
  Real gap = std::numeric_limits<Real>::infinity();
  const auto k = static_cast<std::size_t>(interface);
  const Real below_angle = interface == 0 ? Real(0) : bodies.at[k - 1].angle;
  if (abs(bodies.at[k].angle - below_angle) >= pi<Real> / 2) return gap;
  for (const bool below : {false, true}) {
    for (const int side : {-1, 1}) {
      if (below && interface == 0) continue;
      const CornerOnFace<Real> point = below ? lower_corner<Real>(stack.blocks, interface, side)
                                             : upper_corner<Real>(stack.blocks, interface, side);
      const BasicPointRows<Real> rows = rows_of(stack.blocks, bodies, point);
      if (abs(rows.slip) <= half_width_of<Real>(stack.blocks, point.face) * (1 + tolerance<Real>(1e-12)))
        gap = std::min(gap, rows.gap);
    }
  }
  return gap;
}

/// Keeps the history of a motion that goes by step by step: its events, and what the options ask for.
template <class Real>
class ContactRecorder {
 public:
  /// Keeps references to `stack` and `options`.
  ContactRecorder(const Scene& scene, const BasicFrictionStack<Real>& stack, const ContactOptions& options)
      : stack_(stack), options_(options) {
    if (options.validity) demands_.emplace(scene, scene.blocks.size());
    if (options.peaks) history_.peaks = history_.lifts = std::vector<Real>(scene.blocks.size(), Real(0));
  }

  /// A step up to `end_s` of its length; it starts at `start` s. A mode that ends as it starts bears nothing.
  void note_step(const Joints<Real>& rigid, const ModeSeries<Real>& series,
                 const SpringContacts<Real>& springs, const SpringSeries<Real>& spring_series,
                 const Real& end_s, const Real& start) {
    while (sample_due()) {
      const Real s = (Real(options_.sample_times[next_sample_]) - start) / series.length;
      if (s >= end_s) break;
      note_sample({series.at(std::max(s, Real(0))), rigid}, springs, spring_series, std::max(s, Real(0)),
                  series);
    }
    if (!demands_ && !options_.peaks) return;
    const Joints<Real> joints = springs.shown(rigid);
    if (demands_ && end_s > 0) note_demands(joints, series, end_s, start);
    if (!options_.peaks) return;
    note_peaks(series, end_s);
    for (std::size_t k = 0; k < joints.size(); ++k)
      if (!joints[k].touches()) note_lift(static_cast<int>(k), series, end_s);
  }

  /// Impulses that bring about a mode.
  void note_impact(const Joints<Real>& mode, const BasicBodies<Real>& bodies,
                   std::vector<BasicContactForce<Real>> impulses, const Real& time) {
    if (!demands_) return;
    demands_->note_impact(impulses, time);
    for (const int k : sticking_pairs(mode)) {
      const auto index = static_cast<std::size_t>(k);
      impulses[index] = on_other_face(impulses[index], mode[index], relative_angle(bodies.at, index));
    }
    demands_->note_impact(impulses, time);
  }

  void note_event(BasicContactEvent<Real> event) { history_.events.push_back(std::move(event)); }

  /// The samples at the end of the scene.
  void note_rest(const ContactState<Real>& state, const SpringContacts<Real>& springs, double duration) {
    while (sample_due() && options_.sample_times[next_sample_] <= duration) note_sample(state, springs);
  }

  /// The motion up to where it has come.
  BasicContactHistory<Real> history(const ContactState<Real>& last, const Real& end_time) && {
    if (demands_) {
      history_.forces = demands_->forces();
      history_.impulses = demands_->impulses();
    }
    if (options_.peaks)
      for (const BasicJoint<Real>& joint : last.joints) history_.slips_left.push_back(joint.offset);
    history_.last = last.bodies;
    history_.end_time = end_time;
    return std::move(history_);
  }

 private:
  std::vector<int> sticking_pairs(const Joints<Real>& joints) const {
    return open_pairs(stack_, joints, Sought::accelerations);
  }

  /// Pairs of corners need the friction of either face.
  void note_demands(const Joints<Real>& joints, const ModeSeries<Real>& series, const Real& end_s,
                    const Real& start) {
    demands_->note_step(joints, series, end_s, start);
    const std::vector<int> pairs = sticking_pairs(joints);
    if (pairs.empty()) return;
    ModeSeries<Real> others = series;
    for (const int k : pairs) {
      ForceSeries<Real>& force = others.forces[static_cast<std::size_t>(k)];
      force = on_upper_face(series, k, force);
    }
    demands_->note_step(joints, others, end_s, start);
  }

  bool sample_due() const { return next_sample_ < options_.sample_times.size(); }

  /// At s of a step.
  void note_sample(ContactState<Real> state, const SpringContacts<Real>& springs,
                   const SpringSeries<Real>& series, const Real& s, const ModeSeries<Real>& motion) {
    if (springs.empty()) return note_sample(std::move(state), springs);
    SpringContacts<Real> then = springs;
    then.go(series, s, motion.at(0), state.bodies);
    note_sample(std::move(state), then);
  }

  void note_sample(ContactState<Real> state, const SpringContacts<Real>& springs) {
    place(stack_.blocks, state.joints, state.bodies);
    std::vector<BasicSpringState<Real>> spring_states = springs.states(state.bodies);
    BasicFreeVector<Real> spring_accelerations;
    if (!springs.empty()) spring_accelerations = springs.accelerations(state.bodies);
    state.joints = springs.shown(std::move(state.joints));
    BasicContactSample<Real> sample{Real(options_.sample_times[next_sample_++]),
                                    std::move(state.bodies),
                                    std::move(state.joints),
                                    {},
                                    {},
                                    std::move(spring_states),
                                    std::move(spring_accelerations)};
    for (int k = 0; k < stack_.size(); ++k) {
      const BasicJoint<Real>& joint = sample.joints[static_cast<std::size_t>(k)];
      sample.slips.push_back(joint.offset);
      sample.gaps.push_back(joint.touches() ? Real(0) : gap_of(stack_, sample.bodies, k));
    }
    history_.samples.push_back(std::move(sample));
  }

  void note_peaks(const ModeSeries<Real>& series, const Real& end_s) {
    for (std::size_t k = 0; k < history_.peaks.size(); ++k) {
      Real& peak = history_.peaks[k];
      for (const Real& side : {Real(1), Real(-1)}) {
        Polynomial<Real> lean;
        add(series.bodies[k].angle, side, lean);
        rescale(lean, end_s);
        if (const auto top = maximum(lean, peak)) peak = top->height;
      }
    }
  }

  /// The gap is greatest at the end, where a corner is highest over its face, or where the faces are
  /// parallel.
  void note_lift(int interface, const ModeSeries<Real>& series, const Real& end_s) {
    Real& lift = history_.lifts[static_cast<std::size_t>(interface)];
    const auto note_at = [&](const Real& s) {
      const Real gap = gap_of(stack_, series.at(s), interface);
      if (gap < std::numeric_limits<Real>::infinity()) lift = std::max(lift, gap);
    };
    note_at(end_s);
    for (const bool below : {false, true}) {
      for (const int side : {-1, 1}) {
        if (below && interface == 0) continue;
        const CornerOnFace<Real> point = below ? lower_corner<Real>(stack_.blocks, interface, side)
                                               : upper_corner<Real>(stack_.blocks, interface, side);
        Polynomial<Real> gap = line(-half_height_of<Real>(stack_.blocks, point.face), point.upward,
                                    corner_series(stack_.blocks, series, point).above);
        rescale(gap, end_s);
        if (const auto top = maximum(gap, lift)) note_at(top->s * end_s);
      }
    }
    for (const int side : {-1, 1}) {
      Polynomial<Real> angle = times(side, series.bodies[static_cast<std::size_t>(interface)].angle);
      if (interface > 0)
        add(series.bodies[static_cast<std::size_t>(interface - 1)].angle, Real(-side), angle);
      rescale(angle, end_s);
      if (angle[0] <= 0) continue;
      if (const auto level = first_crossing(angle)) note_at(*level * end_s);
    }
  }

  const BasicFrictionStack<Real>& stack_;
  const ContactOptions& options_;
  std::size_t next_sample_ = 0;
  std::optional<ContactDemands<Real>> demands_;  ///< where they are asked for
  BasicContactHistory<Real> history_;
};

}  // namespace rockstack
