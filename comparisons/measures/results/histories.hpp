#pragma once

#include <map>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// time,normal_1,…,tangential_1,…,centre_1,…: what each interface carries from the block below to the block
/// above at every sample, in N along the normal of its face and along the face; and where a closed interface
/// carries it, in m from its middle (empty where it is open: there it is the pivot).
/// Precondition: the history has patterns.
std::string reactions_csv(const Scene& scene, const History& history);

/// What a solution may keep of its samples besides history.csv: "forces", "energies", "corners".
std::vector<std::string> kinds_of_histories();

/// Their files by name: reactions.csv (reactions_csv()), energies.csv and corners.csv, of the kinds asked
/// for.
/// @throws InputError for another kind. Precondition: the history has patterns.
std::map<std::string, std::string> histories_csv(const Scene& scene, const History& history,
                                                 const std::vector<std::string>& kinds);

/// time,kinetic_1,…,potential_1,…: of each block, J; the potential energy is that of its weight above the
/// place where it rests. Under law `compliant` also elastic_k, damped_k and rubbed_k: what the springs of
/// each interface hold, and what has been lost there in dashpots and by friction, J.
std::string energies_csv(const Scene& scene, const History& history);

/// time, then of each block k lower_left_x_k,lower_left_y_k and so on for lower_right, upper_left and
/// upper_right: how far its corners are from where they rest, in the axes of the ground, m.
std::string corners_csv(const Scene& scene, const History& history);

}  // namespace rockstack
