#pragma once

#include "analytic/unilateral/mode_response.hpp"

namespace rockstack {

// Points push or part, 0 ≤ λ_N ⟂ gap' ≥ 0, and rub by Coulomb's law, |λ_T| ≤ μ λ_N, λ_T = −μ λ_N sgn slip'
// where they slide (Moreau 1988; Stewart & Trinkle 1996). Both ends of a flat contact slide alike, so that
// they share λ_T.

/// True where every law of contact holds in a mode, of `joints` that could be in another.
bool obeys(const FrictionStack& stack, const std::vector<Joint>& joints, const std::vector<Joint>& mode,
           const Bodies& bodies, const FreeVector& free, Sought sought);

/// All modes that obey, each tried: of what touches, each part, pivot or stay, and what sticks may slide.
/// Nothing is tried where that were more than `most`.
std::vector<std::vector<Joint>> modes_that_obey(const FrictionStack& stack, const std::vector<Joint>& joints,
                                                const Bodies& bodies, const FreeVector& free, Sought sought,
                                                std::size_t most);

}  // namespace rockstack
