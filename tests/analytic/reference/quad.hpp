#pragma once

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/float128.hpp>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack::testing {

/// 113 binary digits.
using Quad = boost::multiprecision::float128;
using QuadHistory = BasicHistory<Quad>;

/// The reference: the solver's templates at 113 bits. Chatter ends by double's rule, at flights below the
/// rounding of an angle in double, so that both count the same events. Under law unilateral events decide for
/// `look_ahead` √(H/g) later; 0: for what goes with 113 bits.
/// @throws std::runtime_error where the model cannot go on.
QuadHistory reference(const Scene& scene, std::vector<double> sample_times = {}, double look_ahead = 0);

}  // namespace rockstack::testing
