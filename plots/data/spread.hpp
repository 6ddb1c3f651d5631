#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

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
  int of = 0;       ///< scenes that were solved
  int toppled = 0;  ///< of these
  int agree = 0;    ///< whose answer is that of the exact solution, of those that both solved

  double value() const { return static_cast<double>(toppled) / of; }
  /// Bounds of the share with 95 % confidence (Wilson 1927).
  double lower() const;
  double upper() const;
};

/// How many of a run's perturbed scenes topple, and agree with the exact ones, from their perturbed.csv.
/// @throws InputError likewise.
Share toppled_share(const Run& run, const Run& exact);

}  // namespace rockstack::plots
