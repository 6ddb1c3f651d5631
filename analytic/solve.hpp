#pragma once

#include "analytic/scene/branching.hpp"
#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"
#include "analytic/scene/solve_options.hpp"

namespace rockstack {

/// A motion that could not be followed to its end: why and when, and what is known of it.
class Unfinished : public std::runtime_error {
 public:
  Unfinished(const std::string& reason, History known)
      : std::runtime_error(reason), history(std::move(known)) {}
  History history;  ///< up to there
};

/// The exact motion of a scene in double precision; where block masses or sizes lie too far apart for that,
/// in long double, rounded. Other number types: Solver<Real> in solver.hpp.
/// @throws FieldError for a scene out of range; std::invalid_argument for options out of range;
/// Unfinished where the model cannot go on; Stopped where it is cancelled; IllConditioned where masses or
/// sizes are too far apart for long double too, under law unilateral std::domain_error
/// (solve_contacts.hpp). `branching` leads it through its forks, and comes to hold them; null: it is led
/// nowhere.
History solve(const Scene& scene, const SolveOptions& options = {}, Branching* branching = nullptr);

/// 0, interval, 2 interval, … up to and including the duration (to within a millionth of the interval). s.
/// @throws std::invalid_argument for an interval that is not > 0, or gives more than 10⁷ samples.
std::vector<double> regular_times(double interval, double duration);

}  // namespace rockstack
