#pragma once

#include <stdexcept>
#include <string>

#include "analytic/mechanics/dynamics.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {

/// Ends a motion whose events do not come to an end: of √(H/g), H the stack's height, no thousandth takes
/// more than 10⁴ for each block, for chatter inside chatter grows with the blocks that take part
/// (chatter.hpp). So a motion of N blocks over a time T has at most 10⁷ N T √(g/H) events, or ends with a
/// diagnosis. Columns of 20 equal blocks have been seen to come to rest after 25,000 in one thousandth.
/// Events at one instant are counted by the tie breaker.
template <class Real>
class StallGuard {
 public:
  static constexpr int most_of_block = 10000;

  template <int N>
  explicit StallGuard(const Model<Real, N>& model) : most_(most_of_block * model.stack.size()) {
    using std::sqrt;
    window_ = sqrt(2 * model.stack.half_height.sum() / model.gravity) / 1000;
  }

  /// @throws std::runtime_error where the events are too many to wait for.
  void note_event(const Real& time) {
    if (time - burst_start_ > window_) {
      burst_start_ = time;
      burst_events_ = 0;
    }
    if (++burst_events_ <= most_) return;
    throw std::runtime_error(std::to_string(most_) + " events within " + text(window_) + " s after t = " +
                             text(burst_start_) + " s: impacts follow each other, and no end is in sight");
  }

 private:
  static std::string text(const Real& seconds) { return number_text(static_cast<double>(seconds)); }

  int most_;  ///< in a burst
  int burst_events_ = 0;
  Real window_{};         ///< s
  Real burst_start_ = 0;  ///< s
};

}  // namespace rockstack
