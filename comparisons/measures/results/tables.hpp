#pragma once

#include <filesystem>

#include "comparisons/measures/metrics/alignment.hpp"
#include "comparisons/measures/results/run_metrics.hpp"
#include "engines/body_record.hpp"

namespace rockstack {

/// A cell of a table as text; empty where it is null.
std::string cell_text(const Json& cell);

/// A list of flat objects with the same keys as comma-separated values with a header; nulls are empty cells.
/// Precondition: at least one.
std::string csv_of(const Json& list);

/// time,theta_1,…,omega_1,… and, where known, pattern.
std::string history_csv(const History& history);

/// time,kind,interface,from,to,theta_1,…,omega_before_1,…,omega_after_1,…,consistency.
std::string events_csv(const History& history);

/// time,horizontal,vertical in s and m/s²: where samples lie, and every millisecond of a pulse.
std::string ground_csv(const Scene& scene);

/// time,difference_1,…
std::string difference_csv(const Difference& difference);

/// time,model_1,…,softness_1,…,step_1,…
std::string parts_csv(const DifferenceParts& parts);

/// number,interface,exact_time,engine_time,difference,verdict,exact_side,engine_side.
std::string impacts_csv(const std::vector<AlignedImpact>& alignment);

/// exact,engine,share: the share of time that both spend in a pair of patterns.
std::string patterns_csv(const std::vector<PatternShare>& shares);

/// time,exact,engine,input,elastic,balance,penetration: kinetic and potential energies, the work of the
/// ground's motion, ½kd² of the engine's contacts and energy_balance() of these, J; largest overlap, m.
/// Precondition: all as long as times, or longer.
std::string energy_csv(const std::vector<double>& times, const std::vector<double>& exact,
                       const BodyRecord& engine);

// What is written of a run, read back. All throw InputError with file and line of what is missing or
// malformed.

/// FOLDER/history.csv, and FOLDER/events.csv where it is there.
History read_history(const std::filesystem::path& folder);

/// A file that impacts_csv() has written, but for the sides.
std::vector<AlignedImpact> read_impacts(const std::filesystem::path& file);

}  // namespace rockstack
