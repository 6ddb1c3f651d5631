#pragma once

#include <filesystem>
#include <string>

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// What `rockstack solve` or `simulate` has written: a comparison of one scene with one run, whose files lie
/// in the results folder itself.
struct Motion {
  Comparison comparison;
  std::string verdict;  ///< in one line; why it was given up where it was
  Facts summary;        ///< everything that summary.json says besides
};

/// True where a folder holds one motion.
bool has_one_motion(const std::filesystem::path& results);

/// Reads summary.json. @throws InputError naming the file that is missing or malformed.
Motion read_motion(const std::filesystem::path& results);

}  // namespace rockstack::plots
