#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "comparisons/results.hpp"
#include "comparisons/suite.hpp"

namespace rockstack {

/// Called before each run with its number from 1, how many there are, and its name.
using Progress = std::function<void(std::size_t number, std::size_t total, const std::string& run)>;

/// Runs suites and writes DIR/runs/, DIR/ground/ (where it moves), DIR/comparison.csv and
/// DIR/comparison.json. A run that fails costs its own row. `command` is written into the results. The folder
/// must be there (files.hpp).
/// @throws InputError where two scenes share a name or suites differ in their tolerance; std::runtime_error
/// where a file cannot be written.
std::vector<Row> compare(const std::vector<Suite>& suites, const std::filesystem::path& folder,
                         const std::string& command, const Progress& progress);

}  // namespace rockstack
