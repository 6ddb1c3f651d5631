#pragma once

#include <optional>
#include <stdexcept>

#include "tests/analytic/proof/motion.hpp"

namespace rockstack::proof {

/// Where enclosures do not tell which of two things happens.
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A number that has to be > 0 in a pattern: "opens", "pushes", or the margin on the "right" or "left" of an
/// interface.
struct Condition {
  std::string name;
  std::size_t interface;
  Ball value;
};

/// A pattern that was tried. The first condition that it certainly violates, if there is one.
struct Trial {
  Pattern pattern;
  std::optional<Condition> violated;
};

/// What follows at an instant: the pattern that holds all conditions with certainty, and the others, each of
/// which violates one with certainty.
struct Decision {
  Pattern pattern;
  std::vector<Ball> rates;  ///< of relative angles after the impact; none where nothing impacts
  std::vector<Trial> tried;
};

/// The impact of interface `hit` that closes at unit speed, all other relative rates zero. What motion has no
/// part in the closing goes on through the impact: it is one of those that are allowed after it, whose
/// nearest one it is. So the pattern depends on angles alone, and rates after an impact are those of the
/// others plus the closing speed times these.
/// @throws Undecided
Decision unit_impact(const Stack& stack, bool paper, const Pattern& before, std::size_t hit,
                     const std::vector<Ball>& angles);

/// Which closed interfaces open at once under the ground's acceleration, and to which side. @throws Undecided
Decision opening_at_once(const Stack& stack, const Pattern& pattern, const std::vector<Ball>& angles,
                         const std::vector<Ball>& rates, const Point<Ball>& ground);

}  // namespace rockstack::proof
