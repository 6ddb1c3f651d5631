#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "comparisons/measures/statistics/distributions.hpp"
#include "comparisons/measures/statistics/fragility.hpp"
#include "plots/data/results.hpp"

namespace rockstack::plots {

/// A number of each draw of a run, rising; empty where the run has no draws. @throws InputError naming the
/// file and what is wrong in it.
std::vector<double> draws_of(const Run& run, const std::string& quantity);

/// The whole range of a number over draws.
struct SpreadRange {
  double least = 0, greatest = 0;
};

/// The ranges of one number by the names of the runs that have draws. @throws InputError likewise.
std::map<std::string, SpreadRange> ranges_of(const std::filesystem::path& results,
                                             const std::string& quantity);

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
