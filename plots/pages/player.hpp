#pragma once

#include <string>
#include <vector>

#include "plots/data/events.hpp"
#include "plots/data/json_file.hpp"
#include "plots/data/results.hpp"

namespace rockstack::plots {

/// The player of a scene as a part of a page, with the motions of the runs that figures over time show,
/// thinned so that a page of `players` of them stays small. `id` names its element, `start` how it stands at
/// first, by the names of lesson.json; null: at the beginning. Precondition:
/// has_motion().
/// @throws InputError naming the file that is missing or malformed.
std::string player(const Comparison& comparison, const ComparedScene& scene, std::size_t players,
                   const std::string& id, const Json& start = {});

/// The pattern band and the events of an exact motion, as the player's script reads them: "spans" and
/// "stops". Impacts slower than `chatter_speed`, rad/s, are chatter.
Json player_events(const std::vector<PatternSpan>& spans, const std::vector<PatternChange>& changes,
                   double chatter_speed, int blocks);

/// Text that ends no element, whatever it holds.
std::string for_script(const Json& data);

}  // namespace rockstack::plots
