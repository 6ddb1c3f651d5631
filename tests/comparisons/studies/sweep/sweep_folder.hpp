#pragma once

#include <string>

#include "comparisons/studies/sweep/sweep.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {

/// An ensemble's text: one block under one sine; what varies is added to it.
std::string ensemble_of_one_block(const std::string& variations);

/// Reads an ensemble from a text, as a file ensemble.toml in a folder that is gone afterwards.
Ensemble ensemble_from(const std::string& text);

/// The InputError for an ensemble of that text, without the folder before the file's name.
std::string ensemble_error(const std::string& text);

/// How a sweep of a test is made.
struct SweepPlan {
  std::size_t threads = 1;
  std::size_t blocks = 1000000;  ///< after how many it is stopped
  RunsFormat format = RunsFormat::csv;
};

/// Sweeps into a folder.
SweepResult sweep_into(const std::filesystem::path& folder, const Ensemble& ensemble,
                       const SweepPlan& plan = {});

/// The bytes of a file.
std::string bytes_in(const std::filesystem::path& file);

}  // namespace rockstack
