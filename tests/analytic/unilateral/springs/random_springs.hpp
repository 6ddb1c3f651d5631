#pragma once

#include <cstdint>

#include "analytic/scene/scene.hpp"

namespace rockstack::testing {

/// The random stack of a seed, of one to four blocks, on springs: stiffness 10⁵ … 10⁹ N/m a tonne of the
/// stack and damping of up to critical by decades, friction of 0.2 … 1 or none that slips. One interface in
/// three is rigid where another is not. One scene in three has the ground move.
Scene springy_scene(std::uint64_t seed);

/// The same on Winkler beds that are as stiff in all as the two springs of an interface.
Scene bedded_scene(std::uint64_t seed);

}  // namespace rockstack::testing
