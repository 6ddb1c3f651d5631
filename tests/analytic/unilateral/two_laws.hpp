#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "tests/analytic/unilateral/track.hpp"

namespace rockstack::testing {

/// The random stack of a seed, of one to four blocks, with friction of 0.1 … 1000 at each interface; one in
/// four moves freely, of the others the ground moves.
Scene gripping_scene(std::uint64_t seed);

/// Compares the laws on scene after scene, up to where the motions part.
///
/// Sizes are natural ones: √(H/g) for times, with H the stack's height, a radian, and for velocities the
/// largest so far. Moments of both motions agree to 10⁻¹² times what the motion itself makes of its scene's
/// numbers: by how much more than they it changes under law `consistent`. To that comes what rounding an
/// angle makes of the time at which it closes, ε over its speed; and of forces, which end a pattern, what
/// they lose as second derivatives.
struct LawTally {
  std::array<std::size_t, partings> scenes{};
  std::size_t compared = 0;  ///< events and samples
  std::size_t beyond = 0;    ///< that are so sensitive that a change of some roundings takes them elsewhere
  double worst = 0;          ///< the largest deviation, in shares of its bound

  /// @returns a line where the motions of a seed's scene part without a reason or deviate too much, or
  /// nothing.
  std::string add(std::uint64_t seed, const Scene& scene);
  std::string summary() const;
};

}  // namespace rockstack::testing
