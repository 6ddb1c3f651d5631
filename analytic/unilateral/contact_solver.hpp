#pragma once

#include "analytic/scene/event_limit.hpp"
#include "analytic/unilateral/contact/initial_contacts.hpp"
#include "analytic/unilateral/contact_decision.hpp"
#include "analytic/unilateral/contact_recorder.hpp"
#include "analytic/unilateral/series/mode_step.hpp"

namespace rockstack {

/// Goes from event to event of a stack that may slip and lift off.
///
/// An event leaves a force, a gap or a speed at zero to rounding, so that what follows is decided by how it
/// goes on: by the laws of contact as they stand a look-ahead time later (6.7 √ε √(H/g), 10⁻⁷ √(H/g) in
/// double) on the motion that just ended. Guards that such a decision starts at zero are watched from then.
template <class Real>
class ContactSolver {
 public:
  /// Keeps references to all. Of double, double_does() asks for more than other number types need.
  /// @throws std::domain_error where contact forces or sizes keep fewer than six digits.
  ContactSolver(const Scene& scene, const SolveOptions& options, Branching* branching = nullptr)
      : scene_(scene),
        stack_(contact_model_of<Real>(scene)),
        smooth_(scene.blocks, std::vector<double>(scene.blocks.size(), 0)),
        pieces_(scene),
        chatter_(stack_, scene.gravity, options.resolution),
        fresh_(scene.blocks.size()),
        unit_time_(stack_.fall_time(Real(scene.gravity))),
        look_ahead_(options.look_ahead, unit_time_),
        state_(initial_contacts(stack_, scene.initial)),
        springs_(scene, stack_, state_),
        recorder_(scene, stack_, options),
        cancelled_(options.cancelled),
        branching_(branching) {
    if (!std::is_same_v<Real, double> && !keeps_digits(stack_, 6))
      throw std::domain_error(
          "block masses or sizes are too far apart: rounding would leave contact forces fewer than six digits");
    across_ = Real(scene.gravity) * cos(Real(scene.inclination));
    for (int k = 0; k < stack_.size(); ++k) toppling_angles_.push_back(Real(toppling_angle(scene, k)));
    for (RestraintLaw<Real>& law : stack_.restraints) law.follow(length_of(law));
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

  /// Puts bodies onto joints, and takes from velocities what joints do not leave.
  void project_onto_joints() {
    const Poses<Real> rates = state_.bodies.velocity;
    place(stack_, state_.joints, state_.bodies);
    state_.bodies.velocity = held_rates(smooth_, state_.joints, {state_.bodies.pose, rates});
    place(stack_, state_.joints, state_.bodies);
  }

  /// An impact of joints that touch.
  void resolve_impact(const Joints<Real>& before, Joints<Real> touching, int interface) {
    look_ahead_.note_impact();
    const Poses<Real> rates = state_.bodies.velocity;
    close_negligible(stack_, chatter_, state_.bodies, touching);
    place(stack_, touching, state_.bodies);
    state_.bodies.velocity = rates;
    const Real approach = closing_speed(stack_, state_.bodies, interface - 1, touching[interface - 1]);
    const ContactCollision<Real> impact = take_impulses(touching, ContactLevel::impacts);
    note(impact.kind, interface, springs_.shown(before), rates, impact.consistency, approach);
    decide(impact.mode, state_.bodies, 0, true);
  }

  /// Goes through impulses at joints that touch.
  ContactCollision<Real> take_impulses(const Joints<Real>& touching, ContactLevel level) {
    const auto impact = collide(
        stack_, smooth_, chatter_, touching, state_.bodies, free_acceleration(0, state_.bodies),
        [&](const auto& contacts, const auto& joints, auto& mode) {
          return choose_branch(contacts, joints, mode);
        },
        level);
    if (!impact) stop("no impulses end an impact at", time());
    recorder_.note_impact(impact->found, state_.bodies, impact->impulses, time());
    state_ = {{state_.bodies.pose, impact->rates}, impact->mode};
    place(stack_, state_.joints, state_.bodies);
    fresh_.mark_impact(touching, impact->mode, time(), stack_.restitution > 0);
    return *impact;
  }

  /// Impulses and steps of the ground's velocity. What they press does not bounce.
  void kick() {
    note_burst();
    look_ahead_.note_impact();
    const Joints<Real> before = state_.joints;
    const Poses<Real> rates = state_.bodies.velocity;
    const Loading<Real> steps = pieces_.take_steps();
    FreeVector<Real> kicked =
        vector_of(rates) - uniform<Real>(stack_.size(), steps.ground.x(), steps.ground.y());
    add_pushes(stack_, state_.bodies, steps, kicked);
    state_.bodies.velocity = poses_of(kicked);
    const ContactCollision<Real> impact = take_impulses(before, ContactLevel::velocities);
    note(EventKind::impulse, lowest_change(before, state_.joints), springs_.shown(before), rates,
         impact.consistency);
    decide(impact.mode, state_.bodies, 0, true);
  }

  /// Decides by the laws of contact as they stand `time_ahead`, s, at `bodies`, which `on_joints` tells to be
  /// on their joints.
  void decide(const Joints<Real>& before, Bodies<Real> bodies, const Real& time_ahead,
              bool on_joints = false) {
    decided_ = true;
    const Joints<Real> touching = state_.joints;
    const FreeVector<Real> free = free_acceleration(time_ahead, bodies);
    const Real window = 2 * look_ahead_.time;
    const Joints<Real> joined = time_ahead > 0 ? fresh_.joined(stack_, state_.bodies, touching, time(),
                                                               window, Real(scene_.gravity) * window)
                                               : touching;
    Joints<Real> joints = joined;
    ContactProblem<Real> problem{stack_, bodies, free, ContactLevel::accelerations};
    std::optional<TouchingContacts<Real>> contacts(std::in_place, problem, joints);
    auto mode = find_mode_in_cones(problem, joints, contacts);
    if (!mode) {
      joints = follow_without_solution(joints);
      bodies = state_.bodies;
      problem.left_cones = 0;
      contacts.emplace(problem, joints);
      mode = find_mode_in_cones(problem, joints, contacts);
      if (!mode) stop("no forces let the motion go on at", time());
    }
    // Other modes are sought only where an event can tell of them.
    const bool others =
        (branching_ != nullptr || !same_modes(before, *mode)) && choose_branch(*contacts, joints, *mode);
    const Poses<Real> rates = state_.bodies.velocity;
    state_.joints = *mode;
    fresh_.mark(touching, joined, state_.joints, time());
    const bool stays = same_modes(touching, *mode) && same_modes(joints, *mode) &&
                       std::ranges::all_of(*mode, [](const Joint<Real>& joint) { return joint.slip == 0; });
    if (on_joints && stays) {
      // The contacts that hold them are known.
      const FreeVector<Real> velocities = vector_of(rates);
      state_.bodies.velocity = poses_of<Real>(respond(*contacts, *mode, &velocities).motion);
      place(stack_, state_.joints, state_.bodies);
    } else {
      project_onto_joints();
    }
    if (!same_modes(before, state_.joints))
      note(kind_of(before, state_.joints), lowest_change(before, state_.joints), springs_.shown(before),
           rates, others ? Consistency::several : Consistency::consistent);
  }

  /// Calls choose_branch() of contact_decision.hpp, which chatter does not come to.
  bool choose_branch(const TouchingContacts<Real>& contacts, const Joints<Real>& joints, Joints<Real>& mode) {
    const bool follows = branching_ != nullptr && event_limit_.burst() <= longest_followed_burst;
    return rockstack::choose_branch(contacts, joints, springs_, time(), follows ? branching_ : nullptr, mode);
  }

  /// The impulse that lets the motion go on where no forces do: that of a vanishing step of Moreau's.
  Joints<Real> follow_without_solution(const Joints<Real>& joints) {
    const Poses<Real> rates = state_.bodies.velocity;
    const FreeVector<Real> velocities = vector_of(rates);
    const FreeVector<Real> kicked = velocities + look_ahead_.shortest * free_acceleration(0, state_.bodies);
    const auto mode = find_mode<Real>({stack_, state_.bodies, kicked, ContactLevel::velocities}, joints);
    if (!mode) stop("no impulses let the motion go on at", time());
    const ModeResponse<Real> response =
        respond<Real>({stack_, state_.bodies, velocities, ContactLevel::velocities}, *mode);
    recorder_.note_impact(*mode, state_.bodies, response.forces, time());
    // The mode is that of the kicked velocities. Where its impulses on those without the kick would gain
    // energy, what joints do not leave is taken without friction.
    state_.bodies.velocity = twice_energy(stack_, response.motion) <= twice_energy(stack_, velocities)
                                 ? poses_of(response.motion)
                                 : held_rates(smooth_, *mode, state_.bodies);
    state_.joints = *mode;
    if (!same_modes(joints, state_.joints))
      note(EventKind::impact, lowest_change(joints, state_.joints), springs_.shown(joints), rates,
           Consistency::none, Real(0));
    return state_.joints;
  }

  Real length_of(const RestraintLaw<Real>& law) const {
    const auto place = [&](int k, const Point<Real>& arm) -> Point<Real> {
      const Pose<Real> at = pose_of(state_.bodies.pose, k);
      return Point<Real>(at.x, at.y) + turned<Real>(arm, at.angle);
    };
    return Point<Real>(place(law.to, law.to_arm) - place(law.from, law.from_arm)).norm();
  }

  /// Without rigid contacts; springs have bodies where they are at that time.
  FreeVector<Real> free_acceleration(const Real& time_ahead, const Bodies<Real>& bodies) const {
    const Loading<Real> loading = pieces_.current().at(pieces_.offset() + time_ahead);
    const Point<Real>& ground = loading.ground;
    FreeVector<Real> result = uniform<Real>(stack_.size(), -ground.x(), -(across_ + ground.y()));
    add_pushes(stack_, bodies, loading, result);
    if (!stack_.restraints.empty()) add_restraints(stack_, bodies, result);
    if (!springs_.empty()) result += springs_.accelerations(bodies);
    return result;
  }

  void note_burst() {
    event_limit_.note_event(time(), recorder_.events());
    chatter_.note_burst(event_limit_.burst());
  }

  /// An event between joints as they are shown.
  void note(EventKind kind, int interface, const Joints<Real>& from, const Poses<Real>& before,
            Consistency consistency = Consistency::consistent, std::optional<Real> approach = {}) {
    const auto& [at, after] = state_.bodies;
    std::vector<Real> centres;
    for (const Poses<Real>* poses : {&at, &before, &after}) add_centres(*poses, centres);
    recorder_.note_event({time(), kind, interface, pattern_of(from),
                          pattern_of(springs_.shown(state_.joints)), angles_of(at), angles_of(before),
                          angles_of(after), consistency, 1, std::move(approach), std::move(centres)});
  }

  [[noreturn]] static void stop(const char* what, const Real& time) {
    throw std::runtime_error(std::string(what) + " t = " + std::to_string(static_cast<double>(time)) + " s");
  }

  Real time() const { return pieces_.time(); }

  /// In chatter, where more events follow each other, no more branches leave the motion.
  static constexpr int longest_followed_burst = 8;

  const Scene& scene_;
  ContactModel<Real> stack_;
  ContactModel<Real> smooth_;  ///< the stack without friction
  GroundPieces<Real> pieces_;
  ContactChatter<Real> chatter_;
  RecentChanges<Real> fresh_;
  std::vector<Real> toppling_angles_;
  Real across_{};   ///< gravity across the ground, m/s²
  Real unit_time_;  ///< √(H/g), s
  LookAhead<Real> look_ahead_;
  Real shortest_step_ = tolerance<Real>(1e-13) * unit_time_;  ///< s
  Real longest_ = unit_time_ / 4;                             ///< step, s
  ContactState<Real> state_;
  SpringContacts<Real> springs_;
  bool decided_ = false;  ///< the step starts at an event
  EventLimit<Real> event_limit_{stack_.size(), unit_time_, stack_.restitution};
  bool ended_ = false;
  ContactRecorder<Real> recorder_;
  const std::function<bool()>* cancelled_;
  Branching* branching_;
};

}  // namespace rockstack
