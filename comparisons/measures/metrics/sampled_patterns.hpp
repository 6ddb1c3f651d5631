#pragma once

#include "comparisons/measures/metrics/impacts.hpp"

// The patterns of sampled motion, read from angles and gaps alone, so that engines and the exact solution are
// judged alike.

namespace rockstack {

/// The pattern at each sample. An interface is closed where it stays within open_angle for at least
/// settling_duration(scene), and at the history's ends; in shorter stretches it changes sides as its relative
/// angle reaches the other side, or stays on the one that it comes back to. It is apart where it flies().
std::vector<Pattern> sampled_patterns(const Scene& scene, const History& history);

/// Share of time that both histories spend in a pair of patterns.
struct PatternShare {
  Pattern exact, engine;
  double share = 0;  ///< of 1
};

/// All pairs that occur in patterns at the same times (s), in the order in which they first do.
/// Precondition: at least one sample.
std::vector<PatternShare> pattern_shares(const std::vector<double>& times, const std::vector<Pattern>& exact,
                                         const std::vector<Pattern>& engine);

/// The share of time in which both are equal.
double agreement(const std::vector<PatternShare>& shares);

/// The time until which two histories pass through the same patterns in the same order: the earlier of both
/// times at which the first patterns begin that differ, the last time where none do. s.
double sequence_time(const std::vector<double>& times, const std::vector<Pattern>& exact,
                     const std::vector<Pattern>& engine);

}  // namespace rockstack
