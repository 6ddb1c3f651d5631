#pragma once

#include <stdexcept>

#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {

/// Ends a motion whose events do not come to an end: of √(H/g), H the stack's height, no thousandth takes
/// more than 10⁴ for each block, for chatter inside chatter grows with the blocks that take part
/// (chatter.hpp), and 1/(1 − e) as many where points bounce. Columns of 20 equal blocks have been seen to
/// come to rest after 25,000 in one thousandth. No motion keeps more than half a million, some 600 bytes
/// each: a thousandth of so many come together in a motion that ends. So a motion ends, or does with a
/// diagnosis. Events at one instant are counted by the tie breaker.
template <class Real>
class EventLimit {
 public:
  static constexpr int most_of_block = 10000;
  static constexpr std::size_t most_kept = 500000;

  /// `unit_time` is √(H/g), s; points keep a share `restitution` of their speeds.
  EventLimit(int blocks, const Real& unit_time, const Real& restitution = 0)
      : most_(Real(most_of_block * blocks) / (1 - restitution)), window_(unit_time / 1000) {}

  /// An event after so many that are kept. @throws std::runtime_error where they are too many to wait for.
  void note_event(const Real& time, std::size_t kept) {
    if (time - burst_start_ > window_) {
      burst_start_ = time;
      burst_ = 0;
    }
    if (++burst_ > most_)
      throw std::runtime_error(std::to_string(burst_ - 1) + " events within " + text(window_) +
                               " s after t = " + text(burst_start_) +
                               " s: impacts follow each other, and no end is in sight");
    if (kept >= most_kept)
      throw std::runtime_error(std::to_string(kept) + " events by t = " + text(time) +
                               " s: no motion keeps more");
  }

  /// Events since the last brief time without.
  int burst() const { return burst_; }

 private:
  static std::string text(const Real& seconds) { return number_text(static_cast<double>(seconds)); }

  Real most_;  ///< in a burst
  int burst_ = 0;
  Real window_;           ///< s
  Real burst_start_ = 0;  ///< s
};

}  // namespace rockstack
