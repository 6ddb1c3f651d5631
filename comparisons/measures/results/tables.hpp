#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "comparisons/measures/metrics/forces.hpp"
#include "comparisons/measures/metrics/sampled_patterns.hpp"
#include "comparisons/measures/results/run_metrics.hpp"
#include "engines/body_record.hpp"

namespace rockstack {

/// A table of results: its file's name, and flat rows with the same keys.
struct ResultTable {
  std::string file;
  Json rows;
};

/// A cell of a table as text; empty where it is null.
std::string cell_text(const Json& cell);

/// A list of flat objects with the same keys as comma-separated values with a header; nulls are empty cells.
/// Precondition: at least one.
std::string csv_of(const Json& list);

/// time,theta_1,…,omega_1,… and, where known, pattern.
std::string history_csv(const History& history);

/// time,kind,interface,from,to,theta_1,…,omega_before_1,…,omega_after_1,…,consistency and, of laws that leave
/// pivots, approach.
std::string events_csv(const History& history);

/// time,horizontal,vertical in s and m/s²: where samples lie, and every millisecond of a pulse.
std::string ground_csv(const Scene& scene);

/// time,difference_1,…
std::string difference_csv(const Difference& difference);

/// time,model_1,…,softness_1,…,step_1,…
std::string parts_csv(const DifferenceParts& parts);

/// number,interface,exact_time,engine_time,difference,verdict,exact_side,engine_side.
std::string impacts_csv(const std::vector<AlignedImpact>& alignment);

/// number,interface,exact_time,engine_time,exact_normal,engine_normal,exact_tangential,engine_tangential: in
/// s and N·s.
std::string impulses_csv(const std::vector<ImpactImpulse>& impulses);

/// exact,engine,share: the share of time that both spend in a pair of patterns.
std::string patterns_csv(const std::vector<PatternShare>& shares);

/// time,exact,engine,input,elastic,balance,penetration: kinetic and potential energies, the work of the
/// ground's motion, ½kd² of the engine's contacts and energy_balance() of these, J; largest overlap, m.
/// Precondition: all as long as times, or longer.
std::string energy_csv(const std::vector<double>& times, const std::vector<double>& exact,
                       const BodyRecord& engine);

/// time,normal_1,…,tangential_1,…,centre_1,…: what each interface carries from the block below to the block
/// above at every sample, in N along the normal of its face and along the face; and where a closed interface
/// carries it, in m from its middle (empty where it is open: there it is the pivot).
/// An engine's are means over the step before, and empty at the start.
/// Precondition: the history has patterns, or reactions.
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
/// each interface hold, and what has been lost there in dashpots and by friction; of a scene with tendons
/// tendon_i, what each holds, J.
std::string energies_csv(const Scene& scene, const History& history);

/// time, then of each block k lower_left_x_k,lower_left_y_k and so on for lower_right, upper_left and
/// upper_right: how far its corners are from where they rest, in the axes of the ground, m.
std::string corners_csv(const Scene& scene, const History& history);

// What is written of a run, read back. All throw InputError with file and line of what is missing or
// malformed.

/// FOLDER/history.csv, and FOLDER/events.csv where it is there.
History read_history(const std::filesystem::path& folder);

/// A file that impacts_csv() has written, but for the sides.
std::vector<AlignedImpact> read_impacts(const std::filesystem::path& file);

}  // namespace rockstack
