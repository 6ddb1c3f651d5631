#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "analytic/guards.hpp"

namespace rockstack {

/// Watches that a motion gets on: of √(H/g), H the stack's height, no thousandth takes more than
/// `most_in_burst` events, and no instant more than a few for each interface. So a motion over a time T has
/// at most 10⁷ T √(g/H) events, or ends with a diagnosis.
template <class Real>
class Progress {
 public:
  static constexpr int most_in_burst = 10000;

  template <int N>
  explicit Progress(const Model<Real, N>& model) : few_(4 * (model.stack.size() + 1)) {
    using std::sqrt;
    window_ = sqrt(2 * model.stack.half_height.sum() / model.gravity) / 1000;
  }

  /// A step up to its first event, which is at `time`.
  /// @throws std::runtime_error where events at one instant do not come to an end.
  void note_step(const Next<Real>& next, const Real& time) {
    if (next.opening.any()) {
      ++openings_;
    } else if (next.s > 0) {
      openings_ = 0;
    }
    instant_events_ = next.s > 0 ? 0 : instant_events_ + 1;
    if (instant_events_ <= 4 * few_) return;
    throw std::runtime_error("events follow each other without end, and without time between them, at t = " +
                             text(time) + " s: each pattern that is found leads to another");
  }

  /// @throws std::runtime_error where the events are too many to wait for.
  void note_event(const Real& time) {
    if (time - burst_start_ > window_) {
      burst_start_ = time;
      burst_events_ = 0;
    }
    if (++burst_events_ <= most_in_burst) return;
    throw std::runtime_error(std::to_string(most_in_burst) + " events within " + text(window_) +
                             " s after t = " + text(burst_start_) +
                             " s: interfaces chatter inside each other's chatter, and no end is in sight");
  }

  /// True after an event without time before it.
  bool at_instant() const { return instant_events_ > 0; }

  /// True where rounding decides which interfaces are open. Each opens once at most before something comes
  /// back to it. More openings in a row, or events at one instant, are those of blocks that bear on nothing,
  /// as in free fall: all reactions vanish together there.
  bool undecided() const { return std::max(openings_, instant_events_) > few_; }

 private:
  static std::string text(const Real& seconds) { return std::to_string(static_cast<double>(seconds)); }

  int few_;
  int openings_ = 0;  ///< in a row
  int instant_events_ = 0;
  int burst_events_ = 0;
  Real window_{};         ///< s
  Real burst_start_ = 0;  ///< s
};

}  // namespace rockstack
