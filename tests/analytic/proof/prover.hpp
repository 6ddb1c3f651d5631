#pragma once

#include <limits>
#include <string>
#include <vector>

#include "tests/analytic/proof/exact_scene.hpp"
#include "tests/analytic/proof/stack.hpp"
#include "tests/analytic/proof/witness.hpp"

namespace rockstack::proof {

struct ProofOptions {
  slong bits = 512;
  std::size_t most_events = std::numeric_limits<std::size_t>::max();
  /// Chatter at a lower speed is an accumulation even where that costs digits, rad/s. In any case it is one
  /// where the lemma's interval, as wide as the square of the speed, is no wider than what is known.
  double slow_speed = 0;
};

/// An event at a time that is certain within an interval.
struct ProvedEvent {
  EventKind kind;
  std::size_t interface;  ///< from 0; of a toppling the block
  Pattern from, to;
  Ball time;                        ///< s
  std::vector<Ball> angles, rates;  ///< absolute, rad and rad/s, after it
};

struct Proof {
  std::vector<ProvedEvent> events;
  Ball until;          ///< the motion is known up to here, s
  std::string end;     ///< why it ends
  bool whole = false;  ///< whether it ends with the scene, at rest for ever, or toppled
  std::size_t steps = 0;
  std::vector<Witness> witnesses;  ///< what a checker needs, in order
};

/// Follows a scene from event to event, with certainty, until it is not certain any more.
Proof prove(const ExactScene& scene, const ProofOptions& options);

}  // namespace rockstack::proof
