#pragma once

#include "analytic/scene/scene.hpp"

namespace rockstack {

/// Values in a range, one of each interface; `allowed` goes on with their number. @throws FieldError.
void require_one_each(const std::string& key, const std::vector<double>& values, std::size_t blocks,
                      double least, double most = largest_number,
                      const std::string& allowed = "a number, or as many as there are blocks, ");

/// Steps on springs are no longer than this over their fastest rate, so that series of any order that double
/// or quadruple numbers have are stable.
inline constexpr double steps_per_rate = 8;

/// Checks the springs and beds of a scene: the ranges of their numbers; that none is given that does nothing;
/// that no interface gives way under the weight above it, W/(2k) on two springs and W/(2bκ) on a bed, by more
/// than a tenth of the height of the lower of the two blocks that meet there; and that springs are not too
/// fast to be followed for the duration. @throws FieldError.
void validate_springs(const Scene& scene);

/// What springs of unit stiffness at a corner add to tr M⁻¹K of a block, 1/kg: one across a face, the corner
/// at the end of a face of that half width, and `tangential` along it.
double spring_compliance(const Block& block, double half_width, double tangential);

}  // namespace rockstack
