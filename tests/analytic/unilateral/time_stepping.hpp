#pragma once

#include "tests/analytic/unilateral/solve_unilateral.hpp"

namespace rockstack::testing {

/// Moreau's time stepping for free bodies (Moreau 1988; Jean 1999, Comput. Methods Appl. Mech. Engng 177,
/// 235–257): positions are moved by half a step, points that touch there get impulses within Coulomb's cone
/// that leave them by Newton's or Poisson's law, pairs of corners without bounce, found by projected
/// Gauss–Seidel sweeps, and positions move by the other half. Nothing of it is shared with the solver but the
/// problem. It converges with order one. Sweeps go on until they change impulses by less than `stop` times
/// that of all weight in a step: over T seconds they leave out some stop · gT² of positions.
/// @returns poses and rates at the end.
Bodies<> time_stepped(const Scene& scene, double step, double stop = 1e-9);

}  // namespace rockstack::testing
