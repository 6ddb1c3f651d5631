#pragma once

#include <vector>

#include "analytic/mechanics/impact.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// The energies of an impact, J.
struct ImpactEnergies {
  double before = 0;  ///< kinetic
  double after = 0;
  double jump = 0;  ///< kinetic energy of the change of velocity
};

/// Precondition: the event is an impact of that scene.
ImpactEnergies impact_energies(const Scene& scene, const Event& impact);

/// The state just before an impact, with its gaps closed.
Impact<double> impact_of(const Event& event);

/// Kinetic energy and height times weight at a state of absolute angles and velocities, less that of the
/// stack at rest, J.
double energy_above_rest(const Scene& scene, const Pattern& pattern, const std::vector<double>& angles,
                         const std::vector<double>& velocities);

// Two blocks that turn as one body and land on the ground: pattern 3a becomes 1b. Spanos et al. 2001,
// Eqs. (126)–(140). The print has the base's inertias where the top block's belong, in Eqs. (137) and (138).

/// Which of the two misprints to keep.
struct Misprints {
  bool eq137 = false, eq138 = false;
};

/// Angular velocities after the landing over that before; and kinetic energy after over before.
struct Landing {
  double base = 0, top = 0, energy = 0;
};

/// Precondition: two blocks, the upper one not wider.
Landing land(const Scene& scene, const Misprints& misprints);

/// The two blocks welded into one: their mass, common centre and inertia, on the base's width.
Block welded(const Scene& scene);

}  // namespace rockstack
