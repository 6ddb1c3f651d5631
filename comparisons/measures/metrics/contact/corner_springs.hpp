#pragma once

#include "analytic/scene/scene.hpp"

namespace rockstack {

/// Spring and dashpot of a block's corner.
struct CornerSpring {
  double stiffness = 0;  ///< N/m
  double damping = 0;    ///< N·s/m
};

/// ζ = c/(2√(km)) of a block that lands on that corner by itself: 1/m = 1/mass + (half width)²/inertia.
double damping_ratio(const CornerSpring& spring, const Block& block);

/// What is left of the speed with which one damped corner lands, as it leaves again: its force is cut at
/// zero and weight left out. From 1 for ζ = 0 down to 0; e⁻² for ζ = 1.
double restitution_of(double damping_ratio);

/// The scene on rigid contacts with Coulomb's friction, a coefficient for each interface: law `unilateral`.
Scene with_rigid_contacts(Scene scene, const std::vector<double>& friction);

/// The same on springs at all corners, not loaded at the start, as engines place blocks: law `compliant`.
Scene with_springs(Scene scene, const std::vector<double>& friction, const CornerSpring& spring);

/// By how much that spring and dashpot have to be less, at the same relaxation time c/k, for the exact motion
/// to take about `most` steps; at least 1. Steps are 8 over the fastest rate of √tr M⁻¹K and tr M⁻¹C.
double spring_factor(const Scene& scene, const CornerSpring& spring, double most);

}  // namespace rockstack
