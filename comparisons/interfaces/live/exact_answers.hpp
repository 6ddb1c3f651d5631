#pragma once

#include "analytic/scene/input/json.hpp"
#include "comparisons/measures/metrics/impacts.hpp"

namespace rockstack::live {

// What a page is told of a motion: a track as the player's script reads it, energies as parts of
// energy_scale() at "energy_times", impacts as [time, interface, side], a verdict. Lists of numbers are as
// plots::packed().

/// To {"scene", "interval", "member", "spread"}: the exact motion at multiples of `interval`, s, with what
/// the player draws it by. A motion that cannot be followed to its end is told up to there, with "failure".
/// A member from 1 on, whose scene is perturbed by `spread`, has times and angles alone. With "branches":
/// true also "others", tracks of up to three more motions that obey, where there are such, as
/// solve_branches().
/// @throws InputError for a scene that is none, nlohmann::json::exception for another question.
std::string exact_answer(const std::string& question);

/// Adds a track and its impacts, which it has the times of.
void add_track(Json& answer, Json track, const std::vector<ImpactTime>& impacts);

/// Adds energies, J, every `stride`-th.
void add_energies(Json& answer, const Scene& scene, const std::vector<double>& times,
                  std::vector<double> values, std::size_t stride);

}  // namespace rockstack::live
