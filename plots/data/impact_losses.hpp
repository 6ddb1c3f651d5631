#pragma once

#include <vector>

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// The energy that an impact loses, J, exact and in an engine with what its contacts store: from halfway to
/// the matched impact before to halfway to that after, so that both are counted over the same impacts,
/// whenever each comes.
struct ImpactLoss {
  double number = 0;  ///< of the exact impact, from 1
  double exact = 0, engine = 0;
};

/// The losses at a run's matched impacts, by time, from its impacts.csv and energy.csv; those are left out
/// whose halfway times do not rise in both. Meaningful where the ground does not move.
/// @throws InputError naming the file and what is wrong in it.
std::vector<ImpactLoss> impact_losses(const Run& run);

}  // namespace rockstack::plots
