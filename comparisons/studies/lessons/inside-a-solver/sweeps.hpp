#pragma once

#include <cstddef>
#include <vector>

namespace rockstack {

// What a solver by sequential impulses does with a stack at rest, whose blocks move up and down alone, on one
// contact each: projected Gauss–Seidel, in velocities (Catto 2005, Iterative dynamics with temporal
// coherence).

/// Blocks and the contacts under them, from the ground up. SI units; upwards is positive.
struct SweptStack {
  std::vector<double> masses;
  std::vector<double> velocities;
  std::vector<double> impulses;  ///< of the contacts in this step; none pulls
};

/// Equal blocks at rest, of 1 kg.
SweptStack equal_blocks(std::size_t count);

/// Impulses by which each contact carries what is above it: the mass times g Δt, `fall`.
std::vector<double> carrying_impulses(const SweptStack& stack, double fall);

/// Gravity's share of a step, and a share of the last step's impulses to begin with: 0 is a cold start.
void begin_step(SweptStack& stack, double fall, double kept);

/// Visits each contact once, from the ground up or from the top down: its impulse becomes what stops its two
/// blocks from approaching, as far as it pushes.
void sweep(SweptStack& stack, bool from_below);

/// Share of the error that one sweep leaves in the long run, of equal blocks: cos²(π/2n), the square of the
/// largest eigenvalue of Jacobi's iteration, a walk between n places with one end closed and the other open.
double left_by_sweep(std::size_t blocks);

/// Sweeps from below and from rest until no contact lacks more than that share of what it has to carry.
int sweeps_until(SweptStack stack, double share);

/// How far the top block sinks within a time from rest, m; overlaps are not taken back.
double sinking(SweptStack stack, int sweeps, double kept, double step, double time, double gravity);

}  // namespace rockstack
