#pragma once

#include <cstdint>
#include <string>

#include "analytic/scene/scene.hpp"

namespace rockstack::testing {

/// The scene of a seed, drawn to where numbers break. Slenderness 0.02 … 1.5, sizes 1 mm … 100 m, mass ratios
/// 1e-6 … 1e6, equal widths and blocks wider than those below, up to 20 blocks, gravity 0.01 … 1000 m/s².
/// Released at 1e-9 rad, 1e-9 short of the unstable balance, at rest, or anywhere between. Ground of
/// 1e-6 … 100 g as pulses of 0.01 Hz … 1 kHz or as records with jumps, sampled each 1e-5 … 0.1 s. Both laws,
/// both equations. Durations go with √(H/g), H the stack's height.
Scene extreme_scene(std::uint64_t seed);

/// Extreme scene under law `unilateral` with friction of 0 … 10 at each interface.
Scene slippery_extreme_scene(std::uint64_t seed);

/// The column of a seed under law `unilateral`: 2 to 20 unequal blocks of friction 0.1 … 1.5, which lean as
/// one, from some block on, or each by itself.
Scene unequal_column(std::uint64_t seed);

/// What is extreme about a scene, in a few words.
std::string features(const Scene& scene);

}  // namespace rockstack::testing
