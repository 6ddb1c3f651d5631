#pragma once

#include <optional>
#include <vector>

namespace rockstack {

/// One number of several replicates, those of the first sample before those of the second; empty where a
/// replicate has none.
using ReplicatedNumber = std::vector<std::optional<double>>;

/// In how many ways so many replicates can be shared out to two samples of these sizes.
double ways_to_share(std::size_t first, std::size_t second);

/// The least chance that joint_chances() can give: that of samples which lie apart, on either side.
double least_joint_chance(std::size_t first, std::size_t second);

/// p-values of several numbers of the same replicates, such that where both samples are of one distribution
/// the chance that any is at or below a level is at most that level, however the numbers hang together: the
/// share of all ways to share out the replicates in which the largest standardized rise or fall of any number
/// is at least this one's (P. H. Westfall & S. S. Young, "Resampling-based multiple testing", 1993, maxT).
/// Numbers are compared by ln(1 + |v|/s) with their signs, where s is the median of |v|: a rise by factors
/// is far beyond what chance makes of other numbers, and spreads below a hundredth are no rise. Precondition:
/// all numbers have as many replicates, of which both samples have some.
std::vector<double> joint_chances(const std::vector<ReplicatedNumber>& numbers, std::size_t first);

}  // namespace rockstack
