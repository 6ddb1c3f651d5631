#pragma once

#include "analytic/mechanics/constrained_mass.hpp"

namespace rockstack {

/// What a stack is while its pattern lasts: a chain of pendulums. Block k turns by ψₖ about its pivot. With
/// constant Lₖ (from its pivot to the next) and the first moment of mass Sₖ = mₖrₖ + (mass above) Lₖ in its
/// own frame, both turned by ψₖ, a dot a time derivative and ⊥ a quarter turn, Lagrange's equation of ψₖ is
///
///     Jₖ ψ̈ₖ + Lₖ⊥ · Σ_{j>k} S̈ⱼ + Sₖ⊥ · (Σ_{j<k} L̈ⱼ − body force) = moment about the pivot of k − that about
///     k + 1
///
/// so that the left sides from k up add up to the moment about pivot k: zero where that interface is open.
template <class Real, int N>
struct Linkage {
  int blocks = 0;
  PerBlock<Real, N> moment_x, moment_y;  ///< S, kg·m
  PerBlock<Real, N> link_x, link_y;      ///< L, m
  PerBlock<Real, N> inertia;             ///< J = I + m r² + (mass above) L², kg·m²
  PerBlock<Real, N> mass;                ///< of the block and all above, kg
  PerBlock<Real, N> width;               ///< w, m
  PerBlock<Real, N> free;                ///< 1 where the interface below is open, 0 where it is closed
  PerBlock<Real, N> lever;  ///< of small angles alone: what would be Sₓ, which bears weight alone, kg·m

  std::size_t size() const { return static_cast<std::size_t>(N == Eigen::Dynamic ? blocks : N); }
};

/// `pattern` as side() takes it.
template <class Real, int N, class Sides>
Linkage<Real, N> make_linkage(const Stack<Real, N>& stack, const Sides& pattern) {
  Linkage<Real, N> linkage;
  linkage.blocks = stack.size();
  Real above = 0;  // mass, kg
  Real next = 0;   // where the pivot above is, from the middle, m
  for (std::size_t k = linkage.size(); k-- > 0;) {
    const auto block = static_cast<int>(k);
    const Real mass = stack.mass[block];
    const Real pivots = side<Real>(pattern, block);
    const Real pivot = pivots * stack.half_width[block];
    const Real height = stack.half_height[block];
    const Real link = next - pivot;
    const Real centre_x = stack.centre_x[block] - pivot;
    const Real centre_y = stack.centre_y[block];
    linkage.moment_x[k] = above * link + mass * centre_x;
    linkage.moment_y[k] = above * (2 * height) + mass * centre_y;
    linkage.link_x[k] = link;
    linkage.link_y[k] = 2 * height;
    linkage.inertia[k] = stack.inertia[block] + mass * (centre_x * centre_x + centre_y * centre_y) +
                         above * (link * link + 4 * height * height);
    above += mass;
    linkage.mass[k] = above;
    linkage.width[k] = stack.half_width[block];
    linkage.free[k] = pivots * pivots;
    next = pivot;
    if (!stack.small_angles) continue;
    linkage.lever[k] = linkage.moment_x[k];
    linkage.moment_x[k] = linkage.link_x[k] = 0;
    linkage.inertia[k] = stack.inertia[block] + (mass + 4 * (above - mass)) * (height * height);
  }
  return linkage;
}

}  // namespace rockstack
