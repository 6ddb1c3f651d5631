#pragma once

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "analytic/events/chatter.hpp"
#include "analytic/events/first_event.hpp"
#include "analytic/events/rest.hpp"
#include "analytic/events/stall_guard.hpp"
#include "analytic/events/tie_breaker.hpp"
#include "analytic/mechanics/impact.hpp"
#include "analytic/solver/recorder.hpp"
#include "analytic/steps/rk4.hpp"
#include "analytic/steps/taylor_step.hpp"

namespace rockstack {

/// Solves a valid scene exactly: smooth motion in a fixed pattern, interrupted by events that are located to
/// rounding.
template <class Real, int N = Eigen::Dynamic, template <class, int> class Steps = TaylorSteps>
class Solver {
 public:
  /// Keeps references to `scene` and `options`.
  /// @throws std::invalid_argument for options out of range.
  Solver(const Scene& scene, const SolveOptions& options)
      : scene_(scene),
        model_(make_model<Real, N>(scene)),
        pieces_(scene),
        steps_(model_, options),
        recorder_(model_, options),
        stall_guard_(model_),
        ties_(model_),
        standing_(model_),
        end_of_chatter_(model_, options.resolution > 0 ? Real(options.resolution)
                                                       : std::numeric_limits<Real>::epsilon()) {
    validate(options);
    const auto vector = [](const std::vector<double>& values) -> Vector<Real, N> {
      return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))
          .template cast<Real>();
    };
    state_ = {{}, relative(vector(scene.initial.angles)), relative(vector(scene.initial.velocities))};
    state_.pattern = pattern_of(state_.angles, state_.velocities);
    turn();
    for (int k = 0; k < model_.stack.size(); ++k)
      toppling_angles_[static_cast<std::size_t>(k)] = Real(toppling_angle(scene, k));
  }

  /// @throws std::runtime_error with the time where no pattern lets the motion go on, events do not come to
  /// an end (stall_guard.hpp, tie_breaker.hpp), or numbers leave the range of their type; IllConditioned for
  /// masses or sizes too far apart for the number type.
  BasicHistory<Real> run() {
    start();
    while (!finished()) advance();
    return std::move(*this).history();
  }
  /// Once finished().
  BasicHistory<Real> history() && {
    if (!toppled_) recorder_.note_rest(state_, Real(scene_.duration));
    return std::move(recorder_).history();
  }

  /// What run() does, step by step: start() once, then advance() until finished(). @throws as run().
  void start() {
    // For the IllConditioned that it may throw: steps do not look.
    accelerations(model_, state_, towards_, pieces_.current().at(offset_));
    settle(state_.pattern);
  }
  bool finished() const { return pieces_.finished() || toppled_; }
  Real time() const { return pieces_.current().start + offset_; }

  void advance() {
    if (!(remaining() > 0)) return next_piece();
    if (stand()) return;
    Flow<Real, N> flow = steps_(state_, towards_, linkage(), pieces_.current(), offset_, longest_step(),
                                ties_.may_open(state_));
    take(flow);
  }

  /// Goes on up to a step in which blocks move, and true; or to the end. @throws as run().
  bool seek_motion() {
    while (!finished()) {
      if (remaining() > 0 && !is_closed(state_.pattern)) return true;
      advance();
    }
    return false;
  }

  /// What the next step starts from. Preconditions: not finished, not at the end of a piece.
  struct Start {
    const State<Real, N>& state;
    const Directions<Real, N>& towards;
    const Linkage<Real, N>& linkage;
    Real length;  ///< s
    Pull<Real> pull;
    Interfaces watched;
    bool clear;  ///< of ties
  };
  Start next_step() {
    const Real length = steps_.length(pieces_.current(), longest_step());
    return {state_,
            towards_,
            linkage(),
            length,
            make_pull(model_.gravity, pieces_.current(), offset_, length),
            ties_.may_open(state_),
            ties_.all_clear()};
  }

  /// Goes along a step up to its first event, and through that. @throws as run().
  void take(Flow<Real, N>& flow, const Cleared& cleared = {}) {
    ties_.keep_fresh_open(flow);
    const Next<Real> next = first_event(flow, toppling_angles_, cleared);
    state_ = flow.at(next.s);
    require_numbers();
    recorder_.note_step(flow, pieces_.current(), offset_, next, cleared);
    if (next.closing.none()) turn();
    go_on(next, flow.length);
    if (next.happens()) handle(next);
  }

  /// Where a step leads: relative angles and velocities of open interfaces, and all peaks so far.
  struct End {
    PerBlock<Real, N> angles, velocities, peaks;
  };

  /// Goes along a whole step in which nothing happens, and nothing is to be recorded but peaks.
  void pass(const Real& length, const End& end) {
    for (int k = 0; k < state_.size(); ++k) {
      if (state_.pattern[k] == Contact::closed) continue;
      state_.angles[k] = end.angles[static_cast<std::size_t>(k)];
      state_.velocities[k] = end.velocities[static_cast<std::size_t>(k)];
    }
    turn();
    recorder_.raise_peaks(end.peaks);
    go_on({}, length);
  }

  const State<Real, N>& state() const { return state_; }
  const Model<Real, N>& model() const { return model_; }
  const Recorder<Real, N>& recorder() const { return recorder_; }
  const std::array<Real, max_blocks>& toppling_angles() const { return toppling_angles_; }
  Steps<Real, N>& steps() { return steps_; }
  const Steps<Real, N>& steps() const { return steps_; }

 private:
  Real remaining() const { return pieces_.current().length - offset_; }
  Real longest_step() const { return ties_.longest_step(remaining()); }

  /// To the event that ends a step of a length, or to its end.
  void go_on(const Next<Real>& next, const Real& length) {
    ties_.note_step(next, time());
    if (length >= remaining() && next.s == 1) {
      next_piece();
    } else {
      offset_ += next.s * length;
    }
  }

  /// After a change of angles.
  void turn() { towards_ = directions_at(model_, state_.angles); }

  const Linkage<Real, N>& linkage() {
    if (linkage_.blocks == 0 || !(linked_ == state_.pattern)) {
      linkage_ = make_linkage(model_.stack, state_.pattern);
      linked_ = state_.pattern;
    }
    return linkage_;
  }

  /// Goes on past the ground pieces through whose rest the stack stands still, and nothing of it is to be
  /// kept. False where there is none. At the instant of an event steps tell.
  bool stand() {
    if (!is_closed(state_.pattern) || !ties_.all_clear() || ties_.at_instant()) return false;
    const auto stands = [&] {
      const Bearing<Real> bears = bearing(model_.gravity, pieces_.current(), offset_);
      return bears.tilt < standing_.slenderness && !recorder_.wants(standing_, bears);
    };
    bool stood = false;
    for (; !finished() && stands(); stood = true) next_piece();
    return stood;
  }

  void next_piece() {
    pieces_.advance();
    offset_ = 0;
  }

  void require_numbers() const {
    const Real size = state_.angles.template lpNorm<1>() + state_.velocities.template lpNorm<1>();
    if (!(size <= std::numeric_limits<Real>::max()))
      throw std::runtime_error("angles or velocities have become too large for numbers at t = " +
                               std::to_string(static_cast<double>(time())) + " s");
  }

  [[noreturn]] void no_way_on() const {
    throw std::runtime_error(
        "no pattern lets the motion go on at t = " + std::to_string(static_cast<double>(time())) +
        " s: the blocks would have to lift off");
  }

  void handle(const Next<Real>& next) {
    const Pattern from = state_.pattern;
    if (next.toppling >= 0) {
      toppled_ = true;
      record_event(EventKind::topple, next.toppling, from, state_.velocities, Consistency::consistent);
    } else if (next.closing.any()) {
      ties_.note_closing(next.closing);
      collide(next.closing);
      settle(state_.pattern);
    } else if (ties_.undecided()) {
      ties_.hold(next.opening);
    } else {
      for (int k = 0; k < state_.size(); ++k) {
        if (next.opening.test(static_cast<std::size_t>(k))) state_.pattern[k] = next.opened[k];
      }
      ties_.note_opening(next.opening);
      settle(from);
    }
  }

  /// Rule 4: an impact, or the end of chatter.
  void collide(Interfaces closing) {
    const int first = lowest(closing);
    for (int k = 0; k < state_.size(); ++k) {
      if (end_of_chatter_.negligibly_open(state_, k)) closing.set(static_cast<std::size_t>(k));
    }
    for (int k = 0; k < state_.size(); ++k) {
      if (closing.test(static_cast<std::size_t>(k))) state_.angles[k] = 0;
    }
    turn();
    const Impact<Real, N> impact{state_, closing};
    const Approach<Real, N> before = approach(model_, state_, towards_);
    Resolution<Real, N> resolution = resolve(model_, impact, before, scene_.law);
    Outcome<Real, N>& outcome = resolution.outcome;
    const auto without_slow = [&] {
      return end_of_chatter_.without_slow({outcome.pattern, state_.angles, outcome.relative},
                                          impact.touching(), towards_, pieces_.current().at(offset_));
    };
    bool settled = false;
    for (Pattern slow = without_slow(); !(slow == outcome.pattern); slow = without_slow()) {
      outcome = velocities_after(model_, before, slow);
      settled = true;
    }
    state_.pattern = outcome.pattern;
    state_.velocities = outcome.relative;
    require_numbers();
    recorder_.note_impact(outcome, time());
    const EventKind kind = !settled                     ? EventKind::impact
                           : is_closed(outcome.pattern) ? EventKind::rest
                                                        : EventKind::closure;
    record_event(kind, first, impact.before.pattern, impact.before.velocities, resolution.consistency);
  }

  /// Rule 2 at an instant: opens the closed interfaces whose centre of pressure would lie outside.
  void settle(Pattern from) {
    const Interfaces touching = ties_.touching(state_);
    const Point<Real> ground = pieces_.current().at(offset_);
    const auto evaluate = [&](const Pattern& pattern) {
      return accelerate(model_, State<Real, N>{pattern, state_.angles, state_.velocities}, towards_, ground);
    };
    if (touching.any() && first_violation(model_.stack, evaluate(state_.pattern), touching, ties_.slack())) {
      const auto found = find_admissible(model_.stack, with_closed(state_.pattern, touching), touching,
                                         ties_.slack(), evaluate);
      if (!found) no_way_on();
      // To rounding, closed may do as well; but an opening taken back would be found again at once.
      if (!ties_.at_instant() || !(found->pattern == from)) state_.pattern = found->pattern;
    }
    Interfaces changed;
    for (int k = 0; k < state_.size(); ++k)
      changed.set(static_cast<std::size_t>(k), from[k] != state_.pattern[k]);
    if (changed.none()) return;
    ties_.note_opening(changed);
    record_event(EventKind::opening, lowest(changed), from, state_.velocities, Consistency::consistent);
  }

  static int lowest(const Interfaces& interfaces) {
    int k = 0;
    while (!interfaces.test(static_cast<std::size_t>(k))) ++k;
    return k;
  }

  void record_event(EventKind kind, int interface, const Pattern& from, const Vector<Real, N>& before,
                    Consistency consistency) {
    stall_guard_.note_event(time());
    recorder_.note_event(time(), kind, interface + 1, from, before, state_, consistency);
  }

  const Scene& scene_;
  Model<Real, N> model_;
  GroundPieces<Real> pieces_;
  Steps<Real, N> steps_;
  Recorder<Real, N> recorder_;
  StallGuard<Real> stall_guard_;
  TieBreaker<Real> ties_;
  StandingStack<Real, N> standing_;
  EndOfChatter<Real, N> end_of_chatter_;
  Linkage<Real, N> linkage_;
  State<Real, N> state_;
  Directions<Real, N> towards_;  ///< at the state
  std::array<Real, max_blocks> toppling_angles_{};
  Real offset_ = 0;  ///< into the current piece, s
  Pattern linked_;   ///< the pattern of linkage_
  bool toppled_ = false;
};

}  // namespace rockstack
