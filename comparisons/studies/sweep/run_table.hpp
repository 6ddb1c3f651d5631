#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/studies/sweep/ensemble.hpp"

namespace rockstack {

/// A column of runs.csv and what it means.
using ColumnMeaning = std::pair<std::string, std::string>;

/// All columns in order: the run's number, a column a variation, then what came out.
std::vector<ColumnMeaning> run_columns(const Ensemble& ensemble);

/// The first line of runs.csv.
std::string header_line(const Ensemble& ensemble);

/// Runs `first` up to and without `last`, one line each. A run whose scene is out of range or that the solver
/// cannot finish says so in its line. May be called from several threads at once.
std::string run_lines(const Ensemble& ensemble, std::size_t first, std::size_t last, MotionLibrary& library);

}  // namespace rockstack
