#pragma once

#include "analytic/scene/event_limit.hpp"
#include "analytic/steps/ground_pieces.hpp"
#include "analytic/unilateral/contact/initial_contacts.hpp"
#include "analytic/unilateral/contact_decision.hpp"
#include "analytic/unilateral/contact_recorder.hpp"

namespace rockstack {

/// Motion of a stack that may slip and lift off, and what changes it at an instant: impulses, and decisions
/// which contacts go on, by the laws of contact.
template <class Real>
class ContactMotion {
 protected:
  /// Keeps references to all.
  /// @throws std::domain_error where contact forces or sizes keep fewer than six digits.
  ContactMotion(const Scene& scene, const SolveOptions& options, Branching* branching)
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
        branching_(branching) {
    if (!std::is_same_v<Real, double> && !keeps_digits(stack_, 6))
      throw std::domain_error(
          "block masses or sizes are too far apart: rounding would leave contact forces fewer than six digits");
    across_ = Real(scene.gravity) * cos(Real(scene.inclination));
    for (RestraintLaw<Real>& law : stack_.restraints) law.follow(length_of(law));
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
    Joints<Real> joints = time_ahead > 0 ? slid_on(joined, bodies) : joined;
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
    for (std::size_t k = 0; k < joined.size(); ++k) state_.joints[k].offset = joined[k].offset;
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

  /// Joints with the offsets that those which slide have come to at `bodies`.
  Joints<Real> slid_on(Joints<Real> joints, const Bodies<Real>& bodies) const {
    for (std::size_t k = 0; k < joints.size(); ++k)
      if (joints[k].touches() && joints[k].slip != 0)
        joints[k].offset = offset_of(stack_, bodies, static_cast<int>(k), joints[k]);
    return joints;
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
  Real across_{};   ///< gravity across the ground, m/s²
  Real unit_time_;  ///< √(H/g), s
  LookAhead<Real> look_ahead_;
  ContactState<Real> state_;
  SpringContacts<Real> springs_;
  bool decided_ = false;  ///< the step starts at an event
  EventLimit<Real> event_limit_{stack_.size(), unit_time_, stack_.restitution};
  ContactRecorder<Real> recorder_;
  Branching* branching_;
};

}  // namespace rockstack
