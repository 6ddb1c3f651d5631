#pragma once

#include <string_view>
#include <vector>

namespace rockstack::records {

/// A line of a file, its number from 1.
struct Line {
  std::size_t number = 0;
  std::string_view text;
};

/// How a file parts its columns and writes its numbers.
struct Dialect {
  char separator = ' ';  ///< ' ': blanks, and commas where these are no decimal points
  bool decimal_comma = false;
};

using Cells = std::vector<std::string_view>;

/// The cells of a row.
Cells split(std::string_view line, const Dialect& dialect);

/// Whether a cell is a date or a time of day, or both: "2014-08-24T10:20:44.025", "10:20:44.025".
bool is_clock(std::string_view cell);

/// By what the lines of numbers of a file part their columns.
Dialect dialect_of(const std::vector<Line>& lines);

}  // namespace rockstack::records
