#pragma once

#include "analytic/scene/scene.hpp"

namespace rockstack {

/// What a strike at the wall leaves of a block's angular velocity, backwards: the ratio that a scene gives,
/// or that of Sorrentino, AlShawa & Decanini 2011 (Bulletin of Earthquake Engineering 9, 1617–1642), three
/// impacts that follow each other, each of which keeps the angular momentum about the corner that is met.
/// With I the inertia about the centre of mass and R² = b² + h²:
///
/// - the other corner meets the ground and becomes the pivot: e₁ = (I + m (h² − b²))/(I + m R²), Housner's;
/// - the top corner above it meets the wall: e₂ = (I + m (b² − h²))/(I + m R²), which is negative where the
///   block is thrown back;
/// - the first corner meets the ground again: e₁.
///
/// The ratio is −e₁² e₂, of a uniform block (1 − 3/2 sin²α)² (3/2 cos²α − 1), and zero where that is
/// negative: squat blocks stay. Precondition: a scene with a wall, of one block with its centre of mass in
/// the middle.
double wall_restitution(const Scene& scene);

}  // namespace rockstack
