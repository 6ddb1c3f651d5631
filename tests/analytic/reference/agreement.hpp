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
/// or a height changes by some units in the last place of a double, up or down, taken together. Each
/// deviation is the largest so far, as what has once been amplified may come back in a later event.
Agreement response_to_rounding(const Scene& scene, const QuadHistory& history, int units = 1);

}  // namespace rockstack::testing
