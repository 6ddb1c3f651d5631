#pragma once

#include <optional>

#include "tests/analytic/reference/quad.hpp"

namespace rockstack::testing {

/// The state of an event less that of the same event in another history.
struct Deviation {
  double time = 0;   ///< s
  double state = 0;  ///< the largest of an angle or a velocity, in shares of the size it has had so far
};

/// How the events of one history compare with those of another.
struct Agreement {
  std::vector<Deviation> events;  ///< one for each event up to the first that differs
  std::optional<std::size_t>
      parts;  ///< the first event that differs in kind, place or pattern, or is missing
};

template <class Real>
Agreement compare(const BasicHistory<Real>& history, const QuadHistory& other);

/// What a scene itself makes of roundings of its input: the largest deviations of the reference when gravity
/// or a height changes by some units in the last place of a double, up or down, and in that many draws all
/// its numbers by up to as many at once, taken together. Each deviation is the largest so far, as what has
/// once been amplified may come back in a later event. No more are drawn once they make of the scene what
/// `wanted` is: its parting, and all of its deviations.
Agreement response_to_rounding(const Scene& scene, const QuadHistory& history, int units = 1, int draws = 0,
                               const std::optional<Agreement>& wanted = {});

/// True where two histories that part at an event do so at the resolution at which chatter ends (solver.hpp):
/// the impact is the same, and what one of them leaves out is a flight of at most twice the rounding of an
/// angle, or none.
bool parts_at_resolution(const History& history, const QuadHistory& other, std::size_t event);

/// True where two histories that part at an event come to the same within a few roundings of its time:
/// impacts at one instant that one of them has together and the other one by one.
bool parts_within_an_instant(const History& history, const QuadHistory& other, std::size_t event);

/// True where the reference does not part at an event when it decides for as much later as double does: a
/// mode that lasts no longer than that is none in double (contact_solver.hpp).
bool parts_at_decision(const Scene& scene, const History& history, std::size_t event);

/// True where the solver in double parts from its own history of a scene at an event or before, when each of
/// its operations is rounded up, down or towards zero and the scene's numbers change as in
/// response_to_rounding(): a decision that its own roundings take. @throws as solve().
bool parts_from_itself(const Scene& scene, const History& history, std::size_t event, int units, int draws);

}  // namespace rockstack::testing
