#pragma once

#include "analytic/unilateral/contact_motion.hpp"
#include "analytic/unilateral/series/mode_step.hpp"

namespace rockstack {

/// Goes from event to event of a stack that may slip and lift off.
///
/// An event leaves a force, a gap or a speed at zero to rounding, so that what follows is decided by how it
/// goes on: by the laws of contact as they stand a look-ahead time later (6.7 √ε √(H/g), 10⁻⁷ √(H/g) in
/// double) on the motion that just ended. Guards that such a decision starts at zero are watched from then.
template <class Real>
class ContactSolver : ContactMotion<Real> {
 public:
  /// Keeps references to all. Of double, double_does() asks for more than other number types need.
  /// @throws as ContactMotion().
  ContactSolver(const Scene& scene, const SolveOptions& options, Branching* branching = nullptr)
      : ContactMotion<Real>(scene, options, branching), cancelled_(options.cancelled) {
    for (int k = 0; k < stack_.size(); ++k) toppling_angles_.push_back(Real(toppling_angle(scene, k)));
  }

  /// @throws std::runtime_error where the motion cannot go on.
  void run() {
    decide(Joints<Real>(state_.joints), state_.bodies, 0, springs_.empty());
    for (; !ended_ && !pieces_.finished(); advance()) stop_if_cancelled(cancelled_);
    if (!ended_) recorder_.note_rest(state_, springs_, scene_.duration);
  }

  /// Up to the end, or to where the motion could not go on.
  BasicHistory<Real> history() && {
    return std::move(recorder_).history(springs_.shown(std::move(state_.joints)));
  }

 private:
  using Base = ContactMotion<Real>;
  using Base::across_;
  using Base::chatter_;
  using Base::decide;
  using Base::decided_;
  using Base::follow_without_solution;
  using Base::fresh_;
  using Base::kick;
  using Base::look_ahead_;
  using Base::note;
  using Base::note_burst;
  using Base::pieces_;
  using Base::project_onto_joints;
  using Base::recorder_;
  using Base::resolve_impact;
  using Base::scene_;
  using Base::springs_;
  using Base::stack_;
  using Base::state_;
  using Base::stop;
  using Base::time;
  using Base::unit_time_;

  void advance() {
    const GroundPiece<Real>& piece = pieces_.current();
    const Real remaining = pieces_.remaining();
    if (!(remaining > 0)) return pieces_.advance();
    if (pieces_.steps_now()) return kick();
    const Real length =
        std::min<Real>({remaining, longest_, longest_series(piece), springs_.longest_step(state_.bodies)});
    const ScaledBodyForce<Real> body_force = scaled_body_force(across_, piece, pieces_.offset(), length);
    SpringSeries<Real> springs(stack_, springs_.points(), state_.bodies);
    // Decisions look ahead on a step's series, so that it is not much shorter.
    const Real shortest = std::max<Real>(16 * look_ahead_.time, Real(1e-6) * unit_time_);
    const ModeStep<Real> step =
        mode_step(stack_, state_.joints, state_.bodies, body_force, length, shortest, unit_time_, springs);
    if (step.lengthens && step.planned == longest_) longest_ *= Real(1.25);
    if (step.series.length < step.planned) longest_ = step.series.length;
    if (longest_ < shortest_step_) return jam();
    const FirstChange<Real> found =
        first_change(guards_of(stack_, state_.joints, toppling_angles_, step.series), step.series, fresh_,
                     time(), decided_, std::min<Real>(look_ahead_.time / step.series.length, 1));
    if (!springs_.empty()) {
      const FirstSpringChange<Real> change =
          SpringGuards<Real>(stack_, springs_.points(), state_.bodies, step.series, springs).first();
      if (!change.guards.empty() && (found.guards.empty() || change.s < found.s)) {
        advance_to(step.series, springs, change.s);
        return handle(change);
      }
    }
    if (!stack_.restraints.empty()) {
      const RestraintChange<Real> change = rockstack::first_change(stack_.restraints, step.series.lengths);
      if (change.restraint >= 0 && (found.guards.empty() || change.s < found.s)) {
        advance_to(step.series, springs, change.s);
        return handle(change, step.series);
      }
    }
    const bool whole = found.s == 1 && step.series.length >= remaining;
    advance_to(step.series, springs, found.s);
    if (!found.guards.empty()) {
      handle(found, step.series);
    } else if (whole) {
      pieces_.advance();
    }
  }

  /// Forces are singular, as where one grows without bound. A vanishing step of Moreau's passes that time.
  void jam() {
    note_burst();
    const Real length = std::min<Real>(32 * shortest_step_, pieces_.remaining());
    state_.bodies.pose =
        poses_of<Real>(vector_of(state_.bodies.pose) + length * vector_of(state_.bodies.velocity));
    pieces_.go(length);
    place(stack_, state_.joints, state_.bodies);
    longest_ = unit_time_ / 4;
    decide(follow_without_solution(Joints<Real>(state_.joints)), state_.bodies, 0);
  }

  /// Goes up to s of a step.
  void advance_to(const ModeSeries<Real>& series, const SpringSeries<Real>& springs, const Real& s) {
    Bodies<Real> next = series.at(s);
    if (!vector_of(next.velocity).allFinite())
      stop("velocities have become too large for numbers at", time());
    recorder_.note_step(state_.joints, series, springs_, springs, s, time());
    const Bodies<Real> before = std::exchange(state_.bodies, std::move(next));
    place(stack_, state_.joints, state_.bodies);
    if (!springs_.empty()) springs_.go(springs, s, before, state_.bodies);
    recorder_.note_slips(state_.joints, springs_);
    pieces_.go(s * series.length);
    if (s > 0) decided_ = false;
    if (s > 0)
      for (RestraintLaw<Real>& restraint : stack_.restraints) restraint.at_end = false;
  }

  /// A tendon goes on in another stretch. Its force does not jump.
  void handle(const RestraintChange<Real>& change, const ModeSeries<Real>& series) {
    note_burst();
    const auto i = static_cast<std::size_t>(change.restraint);
    const EventKind kind = take(change, value(series.lengths[i], change.s), stack_.restraints[i]);
    note(kind, stack_.restraints[i].from + 1, springs_.shown(state_.joints), state_.bodies.velocity);
  }

  /// What springs change. Forces may change at once, so that rigid joints are decided anew.
  void handle(const FirstSpringChange<Real>& found) {
    note_burst();
    const Joints<Real> before = springs_.shown(state_.joints);
    std::vector<bool> passes(before.size(), false);
    for (const SpringGuard<Real>& guard : found.guards) {
      const int interface = springs_.points()[guard.point].interface;
      if (guard.change == SpringChange::fall) {
        ended_ = true;
        return note(EventKind::fall, interface + 1, before, state_.bodies.velocity);
      }
      if (guard.change == SpringChange::pass) passes[interface] = true;
      springs_.apply(guard, state_.bodies);
    }
    springs_.show();
    const Joints<Real> after = springs_.shown(state_.joints);
    for (std::size_t k = 0; k < before.size(); ++k)
      if (const auto kind = change_of(before[k], after[k], passes[k]))
        note(*kind, static_cast<int>(k) + 1, before, state_.bodies.velocity);
    if (std::any_of(state_.joints.begin(), state_.joints.end(), std::mem_fn(&Joint<Real>::touches)))
      decide(Joints<Real>(state_.joints), state_.bodies, 0);
  }

  void handle(const FirstChange<Real>& found, const ModeSeries<Real>& series) {
    note_burst();
    const Joints<Real> before = state_.joints;
    for (const Guard<Real>& guard : found.guards) {
      const auto end = ending(guard.change);
      if (!end) continue;
      ended_ = true;
      return note(*end, guard.interface + 1, springs_.shown(before), state_.bodies.velocity);
    }
    Joints<Real> touching = state_.joints;
    const int interface = found.guards.front().interface + 1;
    if (apply(found, stack_, chatter_, state_.bodies, touching))
      return resolve_impact(before, std::move(touching), interface);
    look_ahead_.note_decision(time(), longest_);
    state_.joints = std::move(touching);
    project_onto_joints();
    if (std::ranges::find(found.guards, Change::corner, &Guard<Real>::change) != found.guards.end())
      note(EventKind::corner, interface, springs_.shown(before), state_.bodies.velocity);
    decide(before, series.at(found.s + look_ahead_.time / series.length), look_ahead_.time);
  }

  std::vector<Real> toppling_angles_;
  Real shortest_step_ = tolerance<Real>(1e-13) * unit_time_;  ///< s
  Real longest_ = unit_time_ / 4;                             ///< step, s
  bool ended_ = false;
  const std::function<bool()>* cancelled_;
};

}  // namespace rockstack
