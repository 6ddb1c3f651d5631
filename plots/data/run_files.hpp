#pragma once

#include <memory>
#include <vector>

#include "comparisons/measures/results/recorded_history.hpp"
#include "comparisons/measures/statistics/distributions.hpp"
#include "plots/data/results.hpp"

namespace rockstack::plots {

/// The energies of an engine's run at its samples, J: the exact one's, its own, what the ground's motion put
/// in, and its own with what its contacts store.
struct EnergyHistory {
  std::vector<double> times, exact, engine, input, balance;
};

// All throw InputError naming file and line of what is missing or malformed.

/// A run's motion with its events.
std::shared_ptr<const History> history_of(const Run& run);

/// The impacts of an engine's run beside the exact ones; none where they were not asked for.
std::shared_ptr<const std::vector<AlignedImpact>> impacts_of(const Run& run);

std::shared_ptr<const EnergyHistory> energies_of(const Run& run);

/// What perturbed scenes came to; none where there are none.
std::shared_ptr<const std::vector<MotionTally>> tallies_of(const Run& run);

/// What a history has row by row of one block, from 0. @throws InputError where it has no such block.
std::vector<double> column_of(const History& history, std::vector<double> History::*rows, int block);

}  // namespace rockstack::plots
