#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "comparisons/interfaces/program/arguments.hpp"
#include "comparisons/runs/compare.hpp"

namespace rockstack {

// What `compare` says on standard output: a table whose rows appear as they are done, and the verdict.

/// What the columns mean, and how many runs there will be; nothing where rows are not wanted.
void print_legend(const std::vector<Suite>& suites, const Common& common);

/// Prints rows as CompareOptions::rows has them.
std::function<void(const std::vector<RunMetrics>&)> row_printer(const Common& common);

/// The verdict, what was left out, and where the results are; or all of it as JSON.
void print_comparison(const CompareResult& result, const std::filesystem::path& folder, const Common& common);

}  // namespace rockstack
