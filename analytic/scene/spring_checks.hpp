#pragma once

#include "analytic/scene/scene.hpp"

namespace rockstack {

/// Values of all interfaces, one a block. @throws FieldError.
void require_one_each(const char* key, const std::vector<double>& values, std::size_t blocks);

/// By how much springs give way under the weight above them, at most, as a share of the height of the lower
/// of the two blocks that meet there.
inline constexpr double deepest_share = 0.1;

/// Steps on springs are no longer than this over their fastest rate, so that series of any order that double
/// or quadruple numbers have are stable.
inline constexpr double steps_per_rate = 8;

/// More steps than these are not taken: some minutes.
inline constexpr double most_spring_steps = 1e7;

/// Checks the springs and beds of a scene: the ranges of their numbers; that none is given that does nothing;
/// that no interface gives way under the weight above it, W/(2k) on two springs and W/(2bκ) on a bed, by more
/// than that share; and that springs are not too fast to be followed for the duration. @throws FieldError.
void validate_springs(const Scene& scene);

/// What springs of unit stiffness at a corner add to tr M⁻¹K of a block, 1/kg: one across a face, the corner
/// at the end of a face of that half width, and `tangential` along it.
double spring_compliance(const Block& block, double half_width, double tangential);

/// Bounds on how fast the springs of a stack may be, 1/s, as it stands upright: nothing swings faster than
/// √tr M⁻¹K, dies out faster than tr M⁻¹C, or relaxes faster than k/c, where sliders may move. And the scene
/// file's key of what the largest of them is due to most.
struct SpringRate {
  double rate = 0;
  std::string key;
  double value = 0;  ///< of that key
};
SpringRate fastest_spring_rate(const Scene& scene);

}  // namespace rockstack
