#pragma once

#include <optional>

#include "analytic/unilateral/contact_laws.hpp"

namespace rockstack {

/// The mode that obeys all laws of contact among those in which what touches may stay, part or pivot, and
/// what sticks may slide; of velocities everything may stick. Where several do, the one in which all that
/// sticks goes on to stick comes first, then the one that Lemke's method finds, then, where rounding leads
/// that astray, of all others the one nearest to the motion without contact in the metric of kinetic energy.
/// Nothing where there is none, which happens for accelerations alone (Painlevé).
std::optional<std::vector<Joint>> find_mode(const FrictionStack& stack, const std::vector<Joint>& joints,
                                            const Bodies& bodies, const FreeVector& free, Sought sought);

}  // namespace rockstack
