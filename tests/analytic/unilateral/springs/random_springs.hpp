#pragma once

#include <cstdint>

#include "tests/analytic/unilateral/solve_unilateral.hpp"

namespace rockstack::testing {

/// The random stack of a seed, of one to four blocks, on springs: stiffness 10⁵ … 10⁹ N/m a tonne of the
/// stack and damping of up to critical by decades, friction of 0.2 … 1 or none that slips. One interface in
/// three is rigid where another is not. One scene in three has the ground move.
Scene springy_scene(std::uint64_t seed);

/// Random scene on Winkler beds that are as stiff in all as the two springs of an interface.
Scene bedded_scene(std::uint64_t seed);

/// A random stack of one to three blocks at some angles and velocities, on springs or beds that bear nothing
/// yet, soft enough for explicit steps of 10⁻⁵ s.
Scene soft_scene(std::uint64_t seed, bool beds);

/// The energy of a sample, with what springs hold and what dashpots and friction have taken, J.
double energy_with_losses(const Scene& scene, const Sample& sample);

/// Weight times height of an upright stack, J.
double weight_times_height(const Scene& scene);

}  // namespace rockstack::testing
