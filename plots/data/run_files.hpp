#pragma once

#include "comparisons/measures/results/tables.hpp"
#include "comparisons/measures/statistics/fragility.hpp"
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

/// The times of the impacts at an interface, s.
std::vector<double> impact_times(const History& history, int interface);

/// The energy that an impact loses, J, exact and in an engine with what its contacts store: from halfway to
/// the matched impact before to halfway to that after, so that both count the same, whenever each comes.
struct ImpactLoss {
  double number = 0;  ///< of the exact impact, from 1
  double exact = 0, engine = 0;
};

/// The losses at a run's matched impacts, by time, from its impacts.csv and energy.csv; those are left out
/// whose halfway times do not rise in both. Meaningful where the ground does not move.
/// @throws InputError naming the file and what is wrong in it.
std::vector<ImpactLoss> impact_losses(const Run& run);

/// A number of each draw of a run, rising; none without draws. @throws InputError naming file and fault.
std::vector<double> replicates_of(const Run& run, const std::string& quantity);

/// How many perturbed scenes of a run end one way.
struct Share {
  std::size_t of = 0;       ///< scenes that were solved
  std::size_t toppled = 0;  ///< of these
  std::size_t agree = 0;    ///< whose answer is that of the exact solution, of those that both solved

  double value() const { return static_cast<double>(toppled) / static_cast<double>(of); }
  /// With 95 % confidence.
  Bounds bounds() const { return wilson_bounds(toppled, of); }
};

/// How many perturbed scenes of a run topple, and agree with the exact ones, which are the same.
Share toppled_share(const std::vector<MotionTally>& tallies, const std::vector<MotionTally>& exact);

}  // namespace rockstack::plots
