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

/// The largest rise of energy less input above its least value before, J. Precondition: of equal size.
double largest_gain(const std::vector<double>& energy, const std::vector<double>& input);

}  // namespace rockstack
