#pragma once

#include <vector>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/runs/compare.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

// The table of a comparison on standard output; nothing where it is not wanted.

/// What the columns mean, and how many runs there will be.
void print_legend(const std::vector<Suite>& suites, const Common& common);

/// Has rows printed as they are told. `common` must outlive the options.
void print_rows(const std::vector<Suite>& suites, const Common& common, CompareOptions& options);

}  // namespace rockstack
