#pragma once

#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// Kinetic and potential energy of a stack in the ground's frame, zero at rest upright, at each sample, J.
/// Precondition: a solver's history, which knows its patterns.
std::vector<double> energies(const Scene& scene, const History& history);

/// Weight times the height of the centre of mass at rest, J: what energies are measured by.
double energy_scale(const Scene& scene);

/// Energy of the bodies, less the work done on them (`input`), and with what their contacts have stored: J,
/// at each sample. The true motion never makes it rise. Precondition: of equal size.
std::vector<double> energy_balance(const std::vector<double>& energy, const std::vector<double>& input,
                                   const std::vector<double>& elastic);

/// The largest rise above the least value before, J.
double largest_gain(const std::vector<double>& energy);

}  // namespace rockstack
