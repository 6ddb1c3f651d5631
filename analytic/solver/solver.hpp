#pragma once

#include "analytic/events/tie_breaker.hpp"
#include "analytic/scene/branching.hpp"
#include "analytic/solver/collisions.hpp"
#include "analytic/steps/taylor_step.hpp"

namespace rockstack {

/// Solves a valid scene exactly: smooth motion in a fixed pattern, up to events that are located to rounding.
template <class Real, int N = Eigen::Dynamic, template <class, int> class Steps = TaylorSteps>
class Solver {
 public:
  /// Keeps references to all.
  /// @throws std::invalid_argument for options out of range.
  Solver(const Scene& scene, const SolveOptions& options, Branching* branching = nullptr)
      : scene_(scene),
        steps_(model_, options),
        recorder_(scene, model_, options),
        cancelled_(options.cancelled),
        branching_(branching),
        collisions_(scene, model_, options) {
    validate(options);
    state_ = {{},
              relative(vector_of<Real, N>(scene.initial.angles)),
              relative(vector_of<Real, N>(scene.initial.velocities))};
    state_.pattern = pattern_of(state_.angles, state_.velocities);
    for (int k = 0; k < model_.stack.size(); ++k) toppling_angles_[k] = Real(toppling_angle(scene, k));
  }

  /// @throws std::runtime_error with the time where no pattern lets the motion go on, events do not come to
  /// an end (event_limit.hpp), or numbers leave the range of their type; IllConditioned for
  /// masses or sizes too far apart for the number type.
  BasicHistory<Real> run() {
    start();
    for (; !finished(); advance()) stop_if_cancelled(cancelled_);
    return std::move(*this).history();
  }
  /// Once finished().
  BasicHistory<Real> history() && {
    if (!toppled_) recorder_.note_rest(state_, Real(scene_.duration));
    return std::move(recorder_).history();
  }

  const Recorder<Real, N>& recorder() const { return recorder_; }

  /// What run() does, step by step: start() once, then advance() until finished(). @throws as run().
  void start() {
    // For the IllConditioned that it may throw: steps do not look.
    if (!model_.restraints.empty()) follow_restraints(model_, state_);
    accelerations(model_, state_, directions(), loading());
    make_admissible(state_.pattern);
  }
  bool finished() const { return pieces_.finished() || toppled_; }
  Real time() const { return pieces_.time(); }

  void advance() {
    if (!(pieces_.remaining() > 0)) return pieces_.advance();
    if (pieces_.steps_now()) return kick();
    if (skip_rest()) return;
    if (!(linked_ == state_.pattern)) linkage_ = make_linkage(model_.stack, linked_ = state_.pattern);
    DenseOutput<Real, N> output = steps_(state_, directions(), linkage_, pieces_.current(), pieces_.offset(),
                                         longest_step(), ties_.may_open(state_));
    follow(output);
  }

 private:
  template <int>
  friend class SteppedSolver;  // analytic/batch

  /// Goes along a step up to its first event, and through that. @throws as run().
  void follow(DenseOutput<Real, N>& output, const ExcludedEvents& cleared = {}) {
    ties_.keep_fresh_open(output);
    if (scene_.wall.side != 0)  // never opens there
      (scene_.wall.side < 0 ? output.margins[0].left : output.margins[0].right) = Polynomial<Real>{Real(1)};
    const AngleHulls<Real, N> hulls = angle_hulls(output);
    FirstEvent<Real> event = first_event(output, hulls, toppling_angles_, cleared);
    RestraintChange<Real> change;
    if (!model_.restraints.empty()) change = rockstack::first_change(model_.restraints, output.lengths);
    if (change.restraint >= 0 && (change.s < event.s || !event.happens())) {
      event = {};
      event.s = change.s;
    } else {
      change.restraint = -1;
    }
    state_ = output.at(event.s);
    require_numbers();
    recorder_.note_step(output, hulls, pieces_.current(), pieces_.offset(), event, cleared);
    directed_ = false;
    ties_.note_step(event, time());
    go(event.s, output.length);
    if (event.s > 0)
      for (RestraintLaw<Real>& restraint : model_.restraints) restraint.at_end = false;
    if (event.happens()) handle(event);
    if (change.restraint >= 0) change_restraint(change, output);
  }

  Real longest_step() const { return ties_.longest_step(pieces_.remaining()); }

  /// By a share of a step.
  void go(const Real& share, const Real& length) {
    if (share == 1 && length >= pieces_.remaining()) {
      pieces_.advance();
    } else {
      pieces_.go(share * length);
    }
  }

  Loading<Real> loading() const { return pieces_.current().at(pieces_.offset()); }

  /// At the state.
  const Directions<Real, N>& directions() {
    if (!directed_) directions_ = directions_at(model_, state_.angles);
    directed_ = true;
    return directions_;
  }

  /// Goes on past the ground pieces through whose rest the stack stands still, and nothing of it is to be
  /// kept. False where there is none. At the instant of an event steps tell.
  bool skip_rest() {
    if (!is_closed(state_.pattern) || !ties_.all_clear() || ties_.at_instant() ||
        pieces_.has_applied_forces())
      return false;
    const auto stands = [&] {
      const SupportDemand<Real> bears = support_demand(model_.gravity, pieces_.current(), pieces_.offset());
      return bears.tilt < resting_.critical_tilt && !recorder_.wants(resting_, bears);
    };
    // Samples are looked at one by one where gravity stays as it is; that is enough.
    const Real quiet = model_.gravity * std::min(resting_.critical_tilt, recorder_.known_friction()) *
                       (1 - 1024 * std::numeric_limits<Real>::epsilon());
    bool skipped = false;
    for (; !finished() && stands(); skipped = true) pieces_.advance_past(quiet);
    return skipped;
  }

  [[noreturn]] void fail(const std::string& what, const char* why = "") const {
    throw std::runtime_error(what + " at t = " + number_text(static_cast<double>(time())) + " s" + why);
  }

  void require_numbers() const {
    const Real size = state_.angles.template lpNorm<1>() + state_.velocities.template lpNorm<1>();
    if (!(size <= std::numeric_limits<Real>::max()))
      fail("angles or velocities have become too large for numbers");
  }

  void handle(const FirstEvent<Real>& event, const PredictedImpact<Real, N>* foreseen = nullptr) {
    const Pattern from = state_.pattern;
    if (event.toppling >= 0) {
      toppled_ = true;
      recorder_.note_event(time(), EventKind::topple, event.toppling + 1, from, state_.velocities, state_);
    } else if (event.closing.any()) {
      ties_.note_closing(event.closing);
      collide(event.closing, foreseen);
      make_admissible(state_.pattern);
    } else if (ties_.undecided()) {
      ties_.hold(event.opening);
    } else {
      for (int k = 0; k < state_.size(); ++k)
        if (event.opening.test(k)) state_.pattern[k] = event.opened[k];
      ties_.note_opening(event.opening);
      if (event.either.any()) recorder_.note_choices(event.either, time());
      make_admissible(from, event.either);
    }
  }

  /// Rule 4: an impact, or the end of chatter.
  void collide(Interfaces closing, const PredictedImpact<Real, N>* foreseen) {
    const int first = lowest(closing);
    for (int k = 0; k < state_.size(); ++k) {
      if (collisions_.negligibly_open(state_, k)) closing.set(k);
      if (!closing.test(k)) continue;
      state_.angles[k] = 0;
      if (k != first) foreseen = nullptr;
    }
    directed_ = foreseen != nullptr;
    if (directed_) directions_ = foreseen->before.directions;
    const Impact<Real, N> impact{state_, closing};
    const auto outcome =
        collisions_.outcome(impact, directions(), pieces_.current(), pieces_.offset(), recorder_, foreseen);
    state_.pattern = outcome.solution.pattern;
    state_.velocities = outcome.solution.relative;
    require_numbers();
    const EventKind kind = !outcome.closes             ? EventKind::impact
                           : is_closed(state_.pattern) ? EventKind::rest
                                                       : EventKind::closure;
    recorder_.note_event(time(), kind, first + 1, impact.before.pattern, impact.before.velocities, state_,
                         outcome.consistency);
    if (outcome.closes) recorder_.put_off_closure(outcome.chatter, Real(scene_.duration));
  }

  /// Whether what would open to a side cannot, as there is a wall.
  bool leans_on_wall(Contact opens) const {
    return scene_.wall.side != 0 && opens == static_cast<Contact>(scene_.wall.side);
  }

  /// A tendon goes on in another stretch. Its force does not jump.
  [[gnu::cold]] void change_restraint(const RestraintChange<Real>& change,
                                      const DenseOutput<Real, N>& output) {
    const auto i = static_cast<std::size_t>(change.restraint);
    RestraintLaw<Real>& law = model_.restraints[i];
    const EventKind kind = take(change, value(output.lengths[i], change.s), law);
    recorder_.note_event(time(), kind, law.from + 1, state_.pattern, state_.velocities, state_);
  }

  /// Impulses and steps of the ground's velocity, after the impacts that rounding puts behind them.
  [[gnu::cold]] void kick() {
    const Interfaces landing = landing_now();
    if (landing.any()) {
      collide(landing, nullptr);
      make_admissible(state_.pattern);
    }
    const State<Real, N> before = state_;
    const Resolution<Real, N> outcome = collisions_.kicked(
        before, ties_.touching(state_), directions(), pieces_.current(), pieces_.take_steps(), recorder_);
    state_.pattern = outcome.solution.pattern;
    state_.velocities = outcome.solution.relative;
    require_numbers();
    recorder_.note_event(time(), EventKind::impulse, first_change(before, state_), before.pattern,
                         before.velocities, state_, outcome.consistency);
    make_admissible(state_.pattern);
  }

  /// Interfaces that are about to close by what time and angles round to.
  [[gnu::cold]] Interfaces landing_now() const {
    Interfaces result;
    for (int k = 0; k < state_.size(); ++k) {
      const Real side = Real(sign(state_.pattern[k]));
      const Real rounding = 16 * std::numeric_limits<Real>::epsilon() * (1 + time());
      result.set(k, side * state_.velocities[k] < 0 &&
                        side * state_.angles[k] <= rounding * abs(state_.velocities[k]));
    }
    return result;
  }

  /// The lowest interface whose velocity an impulse has changed, from 1.
  static int first_change(const State<Real, N>& before, const State<Real, N>& after) {
    int k = 0;
    while (k + 1 < after.size() && before.velocities[k] == after.velocities[k]) ++k;
    return k + 1;
  }

  /// Rule 2 at an instant: opens the closed interfaces whose centre of pressure would lie outside. `either`:
  /// have just opened to a side that the other would do for as well.
  void make_admissible(Pattern from, const Interfaces& either = {}) {
    const Interfaces touching = ties_.touching(state_);
    Interfaces pulled;
    const auto evaluate = [&](const Pattern& pattern) {
      return accelerate(model_, State<Real, N>{pattern, state_.angles, state_.velocities}, directions(),
                        loading());
    };
    const auto violates = [&](const PatternSolution<Real, N>& present) {
      const auto violation = first_violation(model_.stack, present, touching, ties_.slack());
      if (!violation || leans_on_wall(violation->mend)) return false;
      pulled = pulled_apart(model_.stack, present);
      return true;
    };
    if (touching.any() && violates(evaluate(state_.pattern))) {
      const auto found = find_admissible(model_.stack, with_closed(state_.pattern, touching), touching,
                                         ties_.slack(), evaluate);
      if (!found) fail("no pattern lets the motion go on", ": the blocks would have to lift off");
      // To rounding, closed may do as well; but an opening taken back would be found again at once.
      if (!ties_.at_instant() || !(found->pattern == from)) state_.pattern = found->pattern;
    }
    Interfaces changed;
    for (int k = 0; k < state_.size(); ++k) changed.set(k, from[k] != state_.pattern[k]);
    if (changed.none()) return;
    if (pulled.any()) recorder_.note_choices(pulled & changed, time());
    const auto is_admissible = [&](const Pattern& pattern) {
      return !first_violation(model_.stack, evaluate(pattern), touching, ties_.slack());
    };
    if (branching_ != nullptr) {
      const std::vector<Pattern> ways =
          with_other_sides(state_.pattern, (pulled | either) & changed, is_admissible);
      state_.pattern = ways[branching_->take(static_cast<double>(time()), ways)];
    }
    ties_.note_opening(changed);
    recorder_.note_event(time(), EventKind::opening, lowest(changed) + 1, from, state_.velocities, state_);
  }

  const Scene& scene_;
  Model<Real, N> model_ = make_model<Real, N>(scene_);
  GroundPieces<Real> pieces_{scene_};
  Steps<Real, N> steps_;
  Recorder<Real, N> recorder_;
  TieBreaker<Real> ties_{model_};
  RestingStack<Real, N> resting_{model_};
  const std::function<bool()>* cancelled_;
  Branching* branching_;
  Collisions<Real, N> collisions_;
  Linkage<Real, N> linkage_;
  State<Real, N> state_;
  Directions<Real, N> directions_;  ///< at the state, if it is
  bool directed_ = false;
  std::array<Real, max_blocks> toppling_angles_{};
  Pattern linked_;  ///< the pattern of linkage_
  bool toppled_ = false;
};

}  // namespace rockstack
