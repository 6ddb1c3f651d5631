#pragma once

#include <string>

#include "plots/look.hpp"
#include "plots/results.hpp"

namespace rockstack::plots {

/// True where a scene's motion can be played: the results say how large its blocks are, and a run is done.
bool has_player(const Comparison& comparison, const ComparedScene& scene);

/// The player of a scene as a part of a page, with the motions of the runs that figures over time show,
/// thinned so that a page of `players` of them stays small. `id` names its element. Precondition:
/// has_player().
/// @throws InputError naming the file that is missing or malformed.
std::string player(const Comparison& comparison, const ComparedScene& scene, const Looks& looks,
                   std::size_t players, const std::string& id);

}  // namespace rockstack::plots
