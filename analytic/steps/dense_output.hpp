#pragma once

#include "analytic/mechanics/pattern_solution.hpp"

namespace rockstack {

/// Along a step, up to a positive factor; without terms where nobody watches.
template <class Real>
using MarginPolynomials = Margins<Polynomial<Real>>;

/// The forces on the block above an interface, N, as polynomials. Without terms where nobody asks.
template <class Real>
struct ForcePolynomials {
  Polynomial<Real> normal, tangential;
};

/// What bounds on a whole step have told before it is looked at: where there is nothing to find.
struct ExcludedEvents {
  Interfaces contacts;  ///< of interfaces that stay open, or closed
  Interfaces angles;    ///< of blocks that neither topple, nor lean more or come further off than before
  Interfaces forces;    ///< that demand no more than before
};

/// The dense output of a step: its motion as polynomials in s = τ/length, 0 ≤ s ≤ 1: one a relative angle,
/// rad. Events and samples are read from these alone, whatever integrator made them.
template <class Real, int N = Eigen::Dynamic>
struct DenseOutput {
  Real length;  ///< s
  State<Real, N> start;
  std::array<Polynomial<Real>, capacity(N)> angles{};  ///< of open interfaces; without terms where closed
  std::array<MarginPolynomials<Real>, capacity(N)> margins{};  ///< of closed interfaces
  std::array<ForcePolynomials<Real>, capacity(N)> forces{};    ///< of all interfaces
  std::vector<Polynomial<Real>> lengths{};                     ///< of restraints, m

  State<Real, N> at(const Real& s) const {
    State<Real, N> state = start;
    for (int k = 0; k < state.size(); ++k) {
      if (state.pattern[k] == Contact::closed) continue;
      const auto [angle, advance] = tangent(angles[k], s);
      state.angles[k] = angle;
      state.velocities[k] = advance / length;
    }
    return state;
  }
};

}  // namespace rockstack
