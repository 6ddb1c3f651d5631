#pragma once

#include <functional>

#include "comparisons/measures/results/long_table.hpp"

namespace rockstack {

/// The columns of a sweep's runs that are varied values: they stand between the run's number and peak_1.
std::vector<std::string> varied_columns(const std::filesystem::path& runs);

/// Calls `take` with each row of the runs that count, which stands at the columns of `names`: of Saltelli's
/// design, whose runs share inputs, those of A and B alone.
void each_counted(const std::filesystem::path& runs, std::vector<std::string> names,
                  const std::function<void(const TableRows&)>& take);

}  // namespace rockstack
