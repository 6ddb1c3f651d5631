#pragma once

#include "analytic/scene/lists.hpp"
#include "analytic/scene/solve_options.hpp"
#include "analytic/steps/force_extremes.hpp"
#include "analytic/unilateral/contact/contact_problem.hpp"
#include "analytic/unilateral/springs/spring_contacts.hpp"

namespace rockstack {

/// Takes what an interface bears into account. A normal force up to `rounding` is zero, and nothing rubs. No
/// interface pulls, or rubs more than its friction, so that first times stay infinite.
template <class Real>
void note_bearing(BasicDemand<Real>& demand, const Real& normal, const Real& tangential, const Real& rounding,
                  const Real& time) {
  const bool bears = normal > rounding;
  raise_demand(demand, bears ? normal : Real(0), bears ? Real(abs(tangential) / normal) : Real(0), time);
}

/// The least gap of blocks that are apart, over all corners that are over a face, m; infinite where there are
/// none, or where one block has turned past a right angle to the other, so that their faces no longer meet.
template <class Real>
Real gap_of(const ContactModel<Real>& stack, const Bodies<Real>& bodies, int interface) {
  Real gap = std::numeric_limits<Real>::infinity();
  if (abs(relative_angle(bodies.pose, interface)) >= pi<Real> / 2) return gap;
  for (const bool below : {false, true})
    for (const int side : {-1, 1}) {
      if (below && interface == 0) continue;
      const CornerOnFace<Real> point = stack.corner(interface, side, below);
      const ContactKinematics<Real> rows = kinematics_of(stack, bodies, point);
      if (abs(rows.slip) <= stack.half_width(point.face) * (1 + tolerance<Real>(1e-12)))
        gap = std::min(gap, rows.gap);
    }
  return gap;
}

template <class Real>
std::vector<Real> angles_of(const Poses<Real>& poses) {
  return mapped(poses, &Pose<Real>::angle);
}

/// Adds x and y of each block to a list.
template <class Real>
void add_centres(const Poses<Real>& poses, std::vector<Real>& list) {
  for (const Pose<Real>& pose : poses) list.insert(list.end(), {pose.x, pose.y});
}

/// Reaction of a joint to the force that holds it.
template <class Real>
BasicReaction<Real> reaction_of(const ContactModel<Real>& stack, int interface, const Joint<Real>& joint,
                                const ContactForce<Real>& force) {
  const int corner = joint.corner_below ? interface - 1 : interface;
  const Real pivot = joint.side() * stack.half_width(corner) - (joint.corner_below ? joint.offset : Real(0));
  const Real centre = joint.touch == Contact::closed ? Real(-force.moment / force.normal) : pivot;
  return {force.normal, force.tangential, force.normal > 0 ? centre : std::numeric_limits<Real>::quiet_NaN()};
}

/// Keeps the history of a motion that goes by step by step: its events, and what the options ask for.
template <class Real>
class ContactRecorder {
 public:
  /// Keeps references to all.
  ContactRecorder(const Scene& scene, const ContactModel<Real>& stack, const SolveOptions& options)
      : scene_(scene), stack_(stack), options_(options) {
    history_.blocks = stack.size();
    Real mass = 0;
    for (const Block& block : stack.blocks) mass += block.mass;
    rounding_ = 1024 * std::numeric_limits<Real>::epsilon() * mass * scene.gravity;
    negligible_impulse_ = Real(1e-6) * mass * sqrt(scene.gravity * stack.height());
    if (options.validity)
      history_.forces = history_.impulses = std::vector<BasicDemand<Real>>(scene.blocks.size());
    if (options.peaks)
      history_.peaks = history_.uplifts = history_.largest_slips = history_.lifts =
          std::vector<Real>(scene.blocks.size(), Real(0));
  }

  /// A step up to `end_s` of its length; it starts at `start` s. A mode that ends as it starts bears nothing.
  void note_step(const Joints<Real>& rigid, const ModeSeries<Real>& series,
                 const SpringContacts<Real>& springs, const SpringSeries<Real>& spring_series,
                 const Real& end_s, const Real& start) {
    while (sample_due()) {
      const Real s = (Real(options_.sample_times[next_sample_]) - start) / series.length;
      if (s >= end_s) break;
      const Real at = std::max(s, Real(0));
      ContactState<Real> state{series.at(at), rigid};
      if (springs.empty()) {
        note_sample(std::move(state), springs);
        continue;
      }
      SpringContacts<Real> then = springs;
      then.go(spring_series, at, series.at(0), state.bodies);
      note_sample(std::move(state), then);
    }
    if (!options_.validity && !options_.peaks) return;
    const Joints<Real> joints = springs.shown(rigid);
    if (options_.validity && end_s > 0) note_demands(joints, series, end_s, start);
    if (!options_.peaks) return;
    note_peaks(series, end_s);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      if (joints[k].touch != Contact::closed) note_uplift(k, joints[k], series, end_s);
      if (!joints[k].touches()) note_lift(k, series, end_s);
    }
  }

  /// Where a step has led: what slides does so one way all through it.
  void note_slips(const Joints<Real>& rigid, const SpringContacts<Real>& springs) {
    if (options_.peaks) note_slips(springs.shown(rigid));
  }

  /// Impulses that bring about a mode.
  void note_impact(const Joints<Real>& mode, const Bodies<Real>& bodies,
                   ShortVector<ContactForce<Real>> impulses, const Real& time) {
    if (!options_.validity) return;
    note_impulses(impulses, time);
    for (const int k : sticking_pairs(mode))
      impulses[k] = on_other_face(impulses[k], mode[k], relative_angle(bodies.pose, k));
    note_impulses(impulses, time);
  }

  void note_event(BasicEvent<Real> event) { history_.events.push_back(std::move(event)); }
  /// How many are kept.
  std::size_t events() const { return history_.events.size(); }

  /// The samples at the end of the scene.
  void note_rest(const ContactState<Real>& state, const SpringContacts<Real>& springs, double duration) {
    while (sample_due() && options_.sample_times[next_sample_] <= duration) note_sample(state, springs);
    if (options_.end) add_sample(state, springs, duration);
  }

  /// The motion up to where it has come, with the joints as they are shown there.
  BasicHistory<Real> history(const Joints<Real>& last) && {
    if (!options_.peaks) return std::move(history_);
    note_slips(last);
    for (std::size_t k = 0; k < last.size(); ++k) history_.slips_left.push_back(slip_of(last, k));
    return std::move(history_);
  }

 private:
  ShortVector<int> sticking_pairs(const Joints<Real>& joints) const {
    return open_pairs(stack_, joints, ContactLevel::accelerations);
  }

  /// What acts over a step up to `end` of its length: the least normal force, which is zero where blocks
  /// part, and the largest ratio of tangential to normal force, no more than the friction. `start` in s.
  void note_forces(const Joints<Real>& joints, const ModeSeries<Real>& series, const Real& end,
                   const Real& start) {
    for (std::size_t k = 0; k < joints.size(); ++k) {
      BasicDemand<Real>& demand = history_.forces[k];
      if (!joints[k].touches()) {
        note_bearing<Real>(demand, 0, 0, rounding_, start);
        continue;
      }
      const Polynomial<Real> normal = times(series.force_unit, series.forces[k].normal);
      const Polynomial<Real> tangential = times(series.force_unit, series.forces[k].tangential);
      note_extremes(demand, normal, tangential, end, rounding_, [&](const Real& s) {
        note_bearing<Real>(demand, value(normal, s), value(tangential, s), rounding_,
                           start + s * series.length);
      });
    }
  }
  /// Notes one impact. Impulses below a millionth of that of the stack's fall by its own size are chatter.
  void note_impulses(const ShortVector<ContactForce<Real>>& impulses, const Real& time) {
    for (std::size_t k = 0; k < impulses.size(); ++k)
      if (impulses[k].normal > negligible_impulse_)
        note_bearing(history_.impulses[k], impulses[k].normal, impulses[k].tangential, negligible_impulse_,
                     time);
  }
  /// Pairs of corners need the friction of either face.
  void note_demands(const Joints<Real>& joints, const ModeSeries<Real>& series, const Real& end_s,
                    const Real& start) {
    note_forces(joints, series, end_s, start);
    const ShortVector<int> pairs = sticking_pairs(joints);
    if (pairs.empty()) return;
    ModeSeries<Real> others = series;
    for (const int k : pairs) others.forces[k] = on_upper_face(series, k, series.forces[k]);
    note_forces(joints, others, end_s, start);
  }

  /// Since the start, m.
  Real slip_of(const Joints<Real>& joints, std::size_t k) const {
    const std::vector<double>& offsets = scene_.initial.offsets;
    return joints[k].offset - (offsets.empty() ? Real(0) : Real(offsets[k]));
  }

  void note_slips(const Joints<Real>& shown) {
    for (std::size_t k = 0; k < shown.size(); ++k)
      history_.largest_slips[k] = std::max<Real>(history_.largest_slips[k], abs(slip_of(shown, k)));
  }

  bool sample_due() const { return next_sample_ < options_.sample_times.size(); }

  void note_sample(ContactState<Real> state, const SpringContacts<Real>& springs) {
    add_sample(std::move(state), springs, options_.sample_times[next_sample_++]);
  }

  void add_sample(ContactState<Real> state, const SpringContacts<Real>& springs, double time) {
    place(stack_, state.joints, state.bodies);
    history_.times.push_back(Real(time));
    for (const Pose<Real>& pose : state.bodies.pose) history_.angles.push_back(pose.angle);
    for (const Pose<Real>& rate : state.bodies.velocity) history_.velocities.push_back(rate.angle);
    add_centres(state.bodies.pose, history_.centres);
    add_centres(state.bodies.velocity, history_.centre_velocities);
    add_reactions(state, springs, time);
    const Joints<Real> joints = springs.shown(std::move(state.joints));
    history_.patterns.push_back(pattern_of(joints));
    for (int k = 0; k < stack_.size(); ++k) {
      history_.slips.push_back(joints[k].offset);
      history_.gaps.push_back(joints[k].touches() ? Real(0) : gap_of(stack_, state.bodies, k));
    }
  }

  /// Adds what interfaces carry at a sample, and what their springs hold.
  void add_reactions(const ContactState<Real>& state, const SpringContacts<Real>& springs, double time) {
    const Gravity gravity = gravity_of(scene_);
    FreeVector<Real> free =
        uniform<Real>(stack_.size(), Real(gravity.along - acceleration(scene_.horizontal, time)),
                      Real(-gravity.across - acceleration(scene_.vertical, time)));
    if (!stack_.pushes.empty()) add_pushes(stack_, state.bodies, loading_at<Real>(scene_, time), free);
    if (!stack_.restraints.empty()) add_restraints(stack_, state.bodies, free);
    if (!springs.empty()) free += springs.accelerations(state.bodies);
    const ModeResponse<Real> response =
        respond<Real>({stack_, state.bodies, free, ContactLevel::accelerations}, state.joints);
    const std::vector<SpringState<Real>> held = springs.states(state.bodies);
    for (int k = 0; k < stack_.size(); ++k)
      history_.reactions.push_back(
          stack_.soft(k) ? held[k].reaction : reaction_of(stack_, k, state.joints[k], response.forces[k]));
    for (const auto& [reaction, energy] : held) history_.spring_energies.push_back(energy);
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

  /// The upper block's corners over the face below. Over a pivot the other one rises by the width of its face
  /// times the sine of the angle at most.
  void note_uplift(std::size_t interface, const Joint<Real>& joint, const ModeSeries<Real>& series,
                   const Real& end_s) {
    const int k = static_cast<int>(interface);
    Real& uplift = history_.uplifts[interface];
    if (joint.pivots() && 2 * stack_.half_width(k) * hull(turn_of(k, series)).size() <= uplift) return;
    for (const int side : {-1, 1}) {
      const CornerOnFace<Real> point = stack_.corner(k, side, false);
      Polynomial<Real> rise =
          line(-stack_.half_height(point.face), 1, corner_series(stack_, series, point).above);
      rescale(rise, end_s);
      if (const auto top = maximum(rise, uplift)) uplift = top->height;
    }
  }

  /// The relative angle of an interface.
  static Polynomial<Real> turn_of(int interface, const ModeSeries<Real>& series) {
    Polynomial<Real> angle = series.bodies[interface].angle;
    if (interface > 0) add(series.bodies[interface - 1].angle, Real(-1), angle);
    return angle;
  }

  /// The gap is greatest at the end, where a corner is highest over its face, or where faces are parallel.
  void note_lift(int interface, const ModeSeries<Real>& series, const Real& end_s) {
    Real& lift = history_.lifts[interface];
    const auto note_at = [&](const Real& s) {
      const Real gap = gap_of(stack_, series.at(s), interface);
      if (gap < std::numeric_limits<Real>::infinity()) lift = std::max(lift, gap);
    };
    note_at(end_s);
    for (const bool below : {false, true})
      for (const int side : {-1, 1}) {
        if (below && interface == 0) continue;
        const CornerOnFace<Real> point = stack_.corner(interface, side, below);
        Polynomial<Real> gap =
            line(-stack_.half_height(point.face), point.upward, corner_series(stack_, series, point).above);
        rescale(gap, end_s);
        if (const auto top = maximum(gap, lift)) note_at(top->s * end_s);
      }
    for (const int side : {-1, 1}) {
      Polynomial<Real> angle = times(side, turn_of(interface, series));
      rescale(angle, end_s);
      if (angle[0] <= 0) continue;
      if (const auto level = first_crossing(angle)) note_at(*level * end_s);
    }
  }

  const Scene& scene_;
  const ContactModel<Real>& stack_;
  const SolveOptions& options_;
  std::size_t next_sample_ = 0;
  Real rounding_{};            ///< of forces, N
  Real negligible_impulse_{};  ///< N·s
  BasicHistory<Real> history_;
};

}  // namespace rockstack
