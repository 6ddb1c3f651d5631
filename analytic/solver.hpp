#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "analytic/guards.hpp"
#include "analytic/impact.hpp"
#include "analytic/rk4.hpp"
#include "analytic/validity.hpp"

namespace rockstack {

/// How to solve, and what to keep.
struct SolveOptions {
  double step = 2e-4;                ///< longest step of the rk4 integrator, s, > 0
  std::vector<double> sample_times;  ///< when to sample the motion, s, ascending from ≥ 0; none: events alone
  bool validity = false;  ///< whether to keep the demands on each interface, taken at the start of every step
};

/// Solves a valid scene exactly: smooth motion in a fixed pattern, interrupted by events that are located to
/// rounding.
///
/// Chatter, ever smaller impacts whose number is infinite, ends where an interface would part at no more than
/// the settling speed u = 500 ε √(g/H), with ε the rounding unit and H the stack's height: it closes instead.
/// What is left out are excursions of at most u²/(2a) rad, a the relative acceleration that brings them back,
/// and the kinetic energy of a relative motion at speed u. As each impact takes its share of the speed, the
/// number of impacts is at most ln(u₀/u)/ln(1/η), for a speed u₀ at first and a velocity ratio η.
template <class Real>
class Solver {
 public:
  /// Keeps references to `scene` and `options`.
  /// @throws std::invalid_argument for a step that is not > 0.
  Solver(const Scene& scene, const SolveOptions& options)
      : scene_(scene), options_(options), model_(make_model<Real>(scene)), pieces_(scene) {
    if (!(options.step > 0))
      throw std::invalid_argument("step = " + std::to_string(options.step) + ": must be > 0 s");
    const int size = model_.stack.size();
    Vector<Real> angles(model_.stack.mass.size());
    Vector<Real> velocities(model_.stack.mass.size());
    for (int k = 0; k < size; ++k) {
      angles[k] = Real(scene.initial.angles[static_cast<std::size_t>(k)]);
      velocities[k] = Real(scene.initial.velocities[static_cast<std::size_t>(k)]);
      toppling_angles_[static_cast<std::size_t>(k)] = Real(toppling_angle(scene, k));
    }
    state_ = {{}, relative<Real>(angles), relative<Real>(velocities)};
    state_.pattern = pattern_of<Real>(state_.angles, state_.velocities);
    rate_ = model_.gravity / (2 * model_.stack.half_height.sum());
    using std::sqrt;
    slack_ = 500 * std::numeric_limits<Real>::epsilon() * rate_;
    settling_speed_ = 500 * std::numeric_limits<Real>::epsilon() * sqrt(rate_);
    history_.blocks = size;
    if (options.validity) {
      history_.forces.resize(static_cast<std::size_t>(size));
      history_.impulses.resize(static_cast<std::size_t>(size));
    }
  }

  /// @throws std::runtime_error where no pattern lets the motion go on, with the time; std::domain_error for
  /// masses too far apart for the number type.
  BasicHistory<Real> run() {
    settle(state_.pattern);
    while (!pieces_.finished() && !toppled_) advance();
    while (!toppled_ && sample_due(Real(scene_.duration))) record_sample(state_);
    return std::move(history_);
  }

 private:
  Real time() const { return pieces_.current().start + offset_; }

  void advance() {
    using std::ceil;
    const GroundPiece<Real>& piece = pieces_.current();
    const Real remaining = piece.length - offset_;
    if (!(remaining > 0)) return next_piece();
    if (options_.validity)
      note_demands(history_.forces, accelerate(model_, state_, piece.at(offset_)), time());
    // A stack at rest needs no steps where the ground's straight line alone decides when it opens.
    const bool whole = is_closed(state_.pattern) && piece.straight() && held_.none();
    const Real steps = whole ? Real(1) : ceil(remaining / Real(options_.step));
    const Flow<Real> flow = rk4_step(model_, state_, piece, offset_, Real(remaining / steps), fresh_);
    const Next<Real> next = Guards<Real>(model_, flow, piece, offset_).first(held_, toppling_angles_);
    record_samples(flow, next.s);
    state_ = flow.at(next.s);
    note_progress(next.s);
    if (steps <= 1 && next.s == 1) {
      next_piece();
    } else {
      offset_ += next.s * flow.length;
    }
    if (next.happens()) handle(next);
  }

  void next_piece() {
    pieces_.advance();
    offset_ = 0;
  }

  /// Events without time between them must come to an end.
  void note_progress(const Real& s) {
    if (s > 0) {
      instant_events_ = 0;
      held_.reset();
      fresh_.reset();
    } else if (++instant_events_ > 16 * (model_.stack.size() + 1)) {
      no_way_on();
    }
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
      held_ |= next.closing & fresh_;
      collide(next.closing);
      settle(state_.pattern);
    } else {
      for (int k = 0; k < from.size; ++k) {
        if (next.opening.test(static_cast<std::size_t>(k))) state_.pattern[k] = next.opened[k];
      }
      fresh_ |= next.opening;
      settle(from);
    }
  }

  /// Open by less than the bounds on what ending chatter leaves out: such interfaces close with the next that
  /// does, or two of them would push each other open for ever.
  bool negligibly_open(int k) const {
    using std::abs;
    return state_.pattern[k] != Contact::closed && abs(state_.velocities[k]) <= settling_speed_ &&
           abs(state_.angles[k]) * rate_ <= settling_speed_ * settling_speed_;
  }

  /// Rule 4: an impact, or the end of chatter.
  void collide(Interfaces closing) {
    const int first = lowest(closing);
    for (int k = 0; k < state_.pattern.size; ++k) {
      if (negligibly_open(k)) closing.set(static_cast<std::size_t>(k));
    }
    for (int k = 0; k < state_.pattern.size; ++k) {
      if (closing.test(static_cast<std::size_t>(k))) state_.angles[k] = 0;
    }
    const Impact<Real> impact{state_, closing};
    const Resolution<Real> resolution = resolve(model_, impact, scene_.law);
    Outcome<Real> outcome = resolution.outcome;
    bool settled = false;
    for (Pattern slow = without_slow(outcome, impact.touching()); !(slow == outcome.pattern);
         slow = without_slow(outcome, impact.touching())) {
      outcome = velocities_after(model_, impact, slow);
      settled = true;
    }
    if (options_.validity) note_demands(history_.impulses, outcome, time());
    state_.pattern = outcome.pattern;
    state_.velocities = outcome.relative;
    const EventKind kind = !settled                     ? EventKind::impact
                           : is_closed(outcome.pattern) ? EventKind::rest
                                                        : EventKind::closure;
    record_event(kind, first, impact.before.pattern, impact.before.velocities, resolution.consistency);
  }

  /// The pattern of an outcome with the interfaces closed that part too slowly to be followed.
  Pattern without_slow(const Outcome<Real>& outcome, const Interfaces& touching) const {
    using std::abs;
    Pattern pattern = outcome.pattern;
    for (int k = 0; k < pattern.size; ++k) {
      if (touching.test(static_cast<std::size_t>(k)) && abs(outcome.relative[k]) <= settling_speed_) {
        pattern[k] = Contact::closed;
      }
    }
    return pattern;
  }

  /// Rule 2 at an instant: opens the closed interfaces whose centre of pressure would lie outside.
  void settle(Pattern from) {
    Interfaces touching = fresh_;
    for (int k = 0; k < state_.pattern.size; ++k) {
      if (state_.pattern[k] == Contact::closed) touching.set(static_cast<std::size_t>(k));
    }
    const Point<Real> ground = pieces_.current().at(offset_);
    const auto evaluate = [&](const Pattern& pattern) {
      return accelerate(model_, State<Real>{pattern, state_.angles, state_.velocities}, ground);
    };
    if (first_violation(model_.stack, evaluate(state_.pattern), touching, slack_)) {
      const auto found = find_admissible(model_.stack, state_.pattern, touching, slack_, evaluate);
      if (!found) no_way_on();
      // To rounding, closed may do as well; but an opening taken back would be found again at once.
      if (instant_events_ == 0 || !(found->pattern == from)) state_.pattern = found->pattern;
    }
    Interfaces changed;
    for (int k = 0; k < from.size; ++k)
      changed.set(static_cast<std::size_t>(k), from[k] != state_.pattern[k]);
    if (changed.none()) return;
    fresh_ |= changed;
    record_event(EventKind::opening, lowest(changed), from, state_.velocities, Consistency::consistent);
  }

  static int lowest(const Interfaces& interfaces) {
    int k = 0;
    while (!interfaces.test(static_cast<std::size_t>(k))) ++k;
    return k;
  }

  void record_event(EventKind kind, int interface, const Pattern& from, const Vector<Real>& before,
                    Consistency consistency) {
    const auto list = [](const Vector<Real>& relative_values) {
      const Vector<Real> values = absolute<Real>(relative_values);
      return std::vector<Real>(values.begin(), values.end());
    };
    history_.events.push_back({time(), kind, interface + 1, from, state_.pattern, list(state_.angles),
                               list(before), list(state_.velocities), consistency});
  }

  bool sample_due(const Real& until) const {
    return next_sample_ < options_.sample_times.size() && Real(options_.sample_times[next_sample_]) <= until;
  }

  /// Samples of a step up to, and without, s of its length.
  void record_samples(const Flow<Real>& flow, const Real& end) {
    for (; next_sample_ < options_.sample_times.size();) {
      const Real sample(options_.sample_times[next_sample_]);
      const Real s = ((sample - pieces_.current().start) - offset_) / flow.length;
      if (!(s < end)) return;
      record_sample(flow.at(std::max(s, Real(0))));
    }
  }

  void record_sample(const State<Real>& state) {
    history_.times.push_back(Real(options_.sample_times[next_sample_++]));
    const Vector<Real> angles = absolute<Real>(state.angles);
    const Vector<Real> velocities = absolute<Real>(state.velocities);
    history_.angles.insert(history_.angles.end(), angles.begin(), angles.end());
    history_.velocities.insert(history_.velocities.end(), velocities.begin(), velocities.end());
    history_.patterns.push_back(state.pattern);
  }

  const Scene& scene_;
  const SolveOptions& options_;
  Model<Real> model_;
  GroundPieces<Real> pieces_;
  Real offset_ = 0;  ///< into the current piece, s
  State<Real> state_;
  Interfaces fresh_;  ///< opened at this instant
  Interfaces held_;   ///< opened and closed again at this instant: stay closed for one step
  std::array<Real, max_blocks> toppling_angles_{};
  Real rate_{};            ///< g/H, the stack's height H, 1/s²
  Real slack_{};           ///< relative accelerations below this are rounding, rad/s²
  Real settling_speed_{};  ///< rad/s
  int instant_events_ = 0;
  bool toppled_ = false;
  std::size_t next_sample_ = 0;
  BasicHistory<Real> history_;
};

}  // namespace rockstack
