#pragma once

#include <optional>

#include "analytic/unilateral/bodies.hpp"

namespace rockstack {

// Motion and impact are one rule for free bodies: M (v' − v) = Wᵀ λ, with v' the accelerations or the
// velocities after, v those that there would be without contact, and W the gradients of gaps and slips.
// Points push or part, 0 ≤ λ_N ⟂ gap' ≥ 0, and rub by Coulomb's law, |λ_T| ≤ μ λ_N, λ_T = −μ λ_N sgn slip'
// where they slide (Moreau 1988; Stewart & Trinkle 1996). Both ends of a flat contact slide alike, so that
// they share λ_T.

/// The stack that contacts hold, with the friction coefficient of each interface.
struct FrictionStack {
  std::vector<Block> blocks;
  std::vector<double> friction;
  Eigen::VectorXd inverse_mass;  ///< three a block

  FrictionStack(std::vector<Block> stacked, std::vector<double> coefficients);
  int size() const { return static_cast<int>(blocks.size()); }
};

/// What one interface does to the block above it: forces in N and N·m, or impulses; the moment is about its
/// held point, and that of a pivot is zero.
struct ContactForce {
  double normal = 0, tangential = 0, moment = 0;
};

/// What a mode leads to.
struct ModeResponse {
  FreeVector motion;
  std::vector<ContactForce> forces;
};

/// Whether velocities or accelerations are sought: the latter have a part that velocities alone make.
enum class Sought { velocities, accelerations };

/// The overlap of a flat contact from the middle of the block above, m.
struct Overlap {
  double left, right;
};
Overlap overlap(const FrictionStack& stack, int interface, double offset);

/// A pivot at an end of a flat contact: which block has the corner. Even ends: the upper one.
bool corner_is_below(const FrictionStack& stack, int interface, double offset, int side);

/// The motion that is left of a free one where joints hold as they say.
ModeResponse respond(const FrictionStack& stack, const std::vector<Joint>& joints, const Bodies& bodies,
                     const FreeVector& free, Sought sought);

/// The mode that obeys all laws of contact among those in which what touches may stay, part or pivot, and
/// what sticks may slide; of velocities everything may stick. Where several do, the one in which all that
/// sticks goes on to stick comes first, then the one that Lemke's method finds. Nothing where there is none,
/// which happens for accelerations alone (Painlevé).
std::optional<std::vector<Joint>> find_mode(const FrictionStack& stack, const std::vector<Joint>& joints,
                                            const Bodies& bodies, const FreeVector& free, Sought sought);

/// True where every law of contact holds in a mode, of `joints` that could be in another.
bool obeys(const FrictionStack& stack, const std::vector<Joint>& joints, const std::vector<Joint>& mode,
           const Bodies& bodies, const FreeVector& free, Sought sought);

}  // namespace rockstack
