#pragma once

#include <string_view>
#include <vector>

#include "analytic/scene/ground/records/table.hpp"

namespace rockstack::records {

using Cells = std::vector<std::string_view>;

/// The cells of a row.
Cells split(std::string_view line, const Dialect& dialect);

/// Whether a cell is a date or a time of day, or both: "2014-08-24T10:20:44.025", "10:20:44.025".
bool is_clock(std::string_view cell);

/// By what the lines of numbers of a file part their columns.
Dialect dialect_of(const std::vector<Line>& lines);

}  // namespace rockstack::records
