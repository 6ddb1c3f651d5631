#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rockstack::plots {

/// Words beside the rows of a panel, each row's in as many lines as it needs.
struct RowWords {
  std::string tics;       ///< "set ytics …", rows counted from 0
  std::string blank;      ///< the same without words, beside further panels
  double left = 0;        ///< where panels begin, a share of the figure's width
  std::size_t lines = 1;  ///< of the row that has most
};

RowWords row_words(const std::vector<std::string>& rows);

/// A page shows no more rows than these.
inline constexpr std::size_t most_rows = 36;

/// The height of a row, in pixels of a sheet.
double row_height(const RowWords& words);

}  // namespace rockstack::plots
