#pragma once

#include "analytic/dynamics.hpp"
#include "analytic/polynomial.hpp"

namespace rockstack {

/// Motion over one step as polynomials in s = τ/length, 0 ≤ s ≤ 1: one a relative angle, rad. Events and
/// samples are read from these alone, whatever integrator made them.
template <class Real>
struct Flow {
  static constexpr std::size_t terms = 6;
  Real length;  ///< s
  State<Real> start;
  std::array<Polynomial<Real, terms>, max_blocks> angles;  ///< of open interfaces; zero where closed

  State<Real> at(const Real& s) const {
    State<Real> state = start;
    for (int k = 0; k < state.pattern.size; ++k) {
      if (state.pattern[k] == Contact::closed) continue;
      const auto& angle = angles[static_cast<std::size_t>(k)];
      state.angles[k] = value(angle, s);
      state.velocities[k] = slope(angle, s) / length;
    }
    return state;
  }
};

}  // namespace rockstack
