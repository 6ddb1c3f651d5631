#pragma once

#include <vector>

#include "analytic/mechanics/impact.hpp"

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

}  // namespace rockstack
