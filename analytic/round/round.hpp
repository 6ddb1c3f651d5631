#pragma once

#include "analytic/round/plane.hpp"

namespace rockstack {

/// The exact motion by Taylor series to rounding; times rise. A column that rolls never comes to rest, as
/// nothing in the model takes energy; one that all that acts keeps in a plane has Housner's impacts there, as
/// a limit of motions out of it does not. @throws std::domain_error where the base lands flat although
/// sideways motion is to come: what follows is open; std::runtime_error where there are too many steps.
RoundMotion solve_round(const RoundScene& scene, const std::vector<double>& times);

}  // namespace rockstack
