#pragma once

#include "analytic/events/first_event.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {

/// Decides what rounding would decide. At the instant of an event an angle, a velocity and an acceleration
/// may be zero together. Rounding then makes an interface open and close, or close and open, without end.
/// Three states keep it from that. Of an interface:
///
///  - fresh: it has opened at this instant. It still touches what is below it, and moves to its side even if
///    its acceleration rounds to the other. Fresh it is until time goes on.
///  - held: it has opened and closed again at one instant, or opens while the instant is undecided. It does
///    not open within the next step, which is brief. Held it is until time goes on from an instant that is
///    not undecided. An interface may be fresh and held, where an impact opens it once more.
///
/// And of the instant:
///
///  - undecided: openings in a row, or events at this one instant, number more than 4 (N + 1). An interface
///    opens once at most before something comes back to it; the number leaves room for every interface, and
///    for the whole stack, to open, to close, to open again and to be held. More come of blocks that bear on
///    nothing, as in free fall, where all reactions vanish together. Interfaces are held then instead of
///    opened. After four times as many events at one instant the solver gives up.
template <class Real>
class TieBreaker {
 public:
  /// A relative acceleration of slack() = 500 ε g/H is rounding, with H the stack's height. Blocks whose
  /// sizes and densities are alike within a factor of four lose at most 160 ε g/H to rounding where there are
  /// two, and less than 310 ε g/H in 999 of 1000 states where there are three (20,000 random states each,
  /// double against long double). What it leaves out is at most 250 ε rad within √(H/g).
  ///
  /// A brief step lasts 10⁻⁴ √(H/g). An acceleration changes at a rate of some (g/H)^(3/2), so by 10⁻⁴ g/H in
  /// a brief step: far above slack, so that the end of the step decides. By then the interface would have
  /// moved by a sixth of 10⁻¹² rad.
  template <int N>
  explicit TieBreaker(const Model<Real, N>& model) : few_(4 * (model.stack.size() + 1)) {
    const Real rate = model.gravity / (2 * model.stack.half_height.sum());
    slack_ = 500 * std::numeric_limits<Real>::epsilon() * rate;
    brief_ = Real(1e-4) / sqrt(rate);
  }

  /// A step up to its first event, which is at `time`.
  /// @throws std::runtime_error where events at one instant do not come to an end.
  void note_step(const FirstEvent<Real>& event, const Real& time) {
    const bool goes_on = event.s > 0;
    if (event.opening.any()) {
      ++openings_;
    } else if (goes_on) {
      openings_ = 0;
    }
    instant_events_ = goes_on ? 0 : instant_events_ + 1;
    if (instant_events_ > 4 * few_)
      throw std::runtime_error(
          "events follow each other without end, and without time between them, at t = " +
          number_text(static_cast<double>(time)) + " s: each pattern that is found leads to another");
    if (!goes_on) return;
    fresh_.reset();
    if (!undecided()) held_.reset();
  }

  /// A step that nothing happens in.
  void note_uneventful_step() {
    openings_ = instant_events_ = 0;
    fresh_.reset();
    held_.reset();
  }

  void note_opening(const Interfaces& opening) { fresh_ |= opening; }
  void note_closing(const Interfaces& closing) { held_ |= closing & fresh_; }
  void hold(const Interfaces& opening) { held_ |= opening; }

  bool undecided() const { return std::max(openings_, instant_events_) > few_; }
  /// True after an event without time before it.
  bool at_instant() const { return instant_events_ > 0; }
  /// True where no interface is fresh or held: computed conditions tell all.
  bool all_clear() const { return fresh_.none() && held_.none(); }

  const Real& slack() const { return slack_; }
  /// Longest length of the next step, with `remaining` s to go, s.
  Real longest_step(const Real& remaining) const {
    return held_.any() ? std::min(remaining, brief_) : remaining;
  }

  /// Closed interfaces that may open within the next step.
  template <int N>
  Interfaces may_open(const State<Real, N>& state) const {
    return state.closed() & ~held_;
  }

  /// Interfaces that touch along their whole width at this instant, and may open or close.
  template <int N>
  Interfaces touching(const State<Real, N>& state) const {
    const Interfaces result = fresh(state) | state.closed();
    return undecided() ? result & ~held_ : result;
  }

  /// Lets fresh interfaces accelerate towards their sides.
  template <int N>
  void keep_fresh_open(DenseOutput<Real, N>& output) const {
    const Interfaces starting = fresh(output.start);
    for (int k = 0; k < output.start.size(); ++k) {
      Polynomial<Real>& angle = output.angles[k];
      if (starting.test(k) && angle.terms > 2 && angle[2] * Real(sign(output.start.pattern[k])) < 0)
        angle[2] = 0;
    }
  }

 private:
  /// An impulse may since have parted what has just opened: it moves on by that.
  template <int N>
  Interfaces fresh(const State<Real, N>& state) const {
    Interfaces result = fresh_;
    for (int k = 0; k < state.size(); ++k)
      if (state.velocities[k] != 0) result.reset(k);
    return result;
  }

  int few_;
  int openings_ = 0;  ///< in a row
  int instant_events_ = 0;
  Real slack_{};  ///< rad/s²
  Real brief_{};  ///< s
  Interfaces fresh_, held_;
};

}  // namespace rockstack
