#pragma once

#include <cstddef>
#include <string>

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// The player of a scene as a part of a page, with the motions of the runs that figures over time show,
/// thinned so that a page of `players` of them stays small. `id` names its element, `start` how it stands at
/// first, by the names of lesson.json; null: at the beginning. Precondition:
/// has_motion().
/// @throws InputError naming the file that is missing or malformed.
std::string player(const Comparison& comparison, const ComparedScene& scene, std::size_t players,
                   const std::string& id, const Json& start = {});

}  // namespace rockstack::plots
