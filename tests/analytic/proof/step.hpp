#pragma once

#include <optional>

#include "tests/analytic/proof/decisions.hpp"
#include "tests/analytic/proof/first_zero.hpp"
#include "tests/analytic/proof/ground.hpp"

namespace rockstack::proof {

/// A set of states at an instant that is known within an interval.
struct Motion {
  Pattern pattern;
  std::vector<Ball> angles, rates;  ///< relative; 0 where closed
  /// Orders of the zeros that relative angles of open interfaces have now: 1 after an impact, 2 where one
  /// opens at once, 3 where a margin has fallen through zero, since angle, rate and acceleration are zero
  /// then; else 0.
  std::vector<int> zeros;
  Ball time;  ///< s
};

enum class EventKind { opening, impact, accumulation, topple };
const char* name(EventKind kind);

/// A guard that may end a step.
struct Watched {
  EventKind kind;
  std::size_t interface;
  int side;  ///< 1 right, −1 left
  Series series;
  int sign;
  int zeros;
  Ball bound;
};

/// Picard's test on the complex times |t| ≤ radius: with rates of change R sup|f(Y)| strictly below the reach
/// on every component, the solution exists there and stays within that reach of its start, from every member
/// of a set.
struct Enclosure {
  Ball radius;  ///< s
  std::vector<Ball> angle_reach, rate_reach;
  std::vector<Margins<Ball>> margins;  ///< bounds of their magnitudes there
};

/// The enclosure on the largest disc found from a first radius on, s. @throws Undecided
Enclosure enclose(const Stack& stack, const Motion& motion, const GroundPiece& piece, const Ball& offset,
                  double& radius);

/// Taylor series of a motion in its pattern, with Cauchy's bounds of what they leave out.
class Step {
 public:
  /// `length`, s, exact, is at most an eighth of the radius.
  Step(const Stack& stack, const Motion& motion, const GroundPiece& piece, const Ball& offset,
       Enclosure enclosure, const Ball& length);

  const std::vector<Watched>& watched() const { return watched_; }
  ZeroSearch search(const Watched& watched) const;
  /// The motion at a time of the step, in the same pattern.
  Motion at(const Ball& time) const;
  slong terms() const { return tape_.terms(); }
  const Enclosure& enclosure() const { return enclosure_; }
  const Ball& length() const { return length_; }

 private:
  void extend();
  void watch_interfaces(const Stack& stack);
  void watch_toppling(const Stack& stack);

  const Motion& start_;
  Enclosure enclosure_;
  Ball length_;
  Tape tape_;
  std::vector<Series> angles_, rates_;
  Accelerations<Series> accelerations_;
  std::vector<Watched> watched_;
};

}  // namespace rockstack::proof
