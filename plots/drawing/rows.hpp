#pragma once

#include "plots/drawing/layout.hpp"

namespace rockstack::plots {

// Marks with ranges, a row each beside its words, over a logarithmic axis unless a column has a linear one;
// columns side by side share the rows. Panels taller than a screen have their axis above as well.

/// A page shows no more rows than these.
inline constexpr std::size_t most_rows = 36;

/// Words beside the rows of a panel, in as many lines as they need.
struct RowWords {
  std::string tics;       ///< "set ytics …"
  std::string blank;      ///< the same without words, beside further panels
  double left = 0;        ///< where panels begin, a share of the figure's width
  std::size_t lines = 1;  ///< of the row that has most

  double row_height() const { return 10 + 16 * static_cast<double>(lines); }  ///< pixels
};

/// Rows are at whole numbers from `first` on, or down where `step` is −1.
RowWords row_words(const std::vector<std::string>& rows, const Sheet& sheet, int first = 0, int step = 1);

/// Rows are counted from 0, downwards.
struct RowColumn {
  std::string across;              ///< words of its axis
  std::vector<std::string> plots;  ///< elements of its plot command
  std::string title = {};          ///< above it, and under that a few lines more
  std::string subtitle = {};
  double end = 0;             ///< of a linear axis from nought; 0: the axis is the panel's
  std::string settings = {};  ///< further gnuplot commands
};

struct RowPanel {
  std::vector<std::string> words;  ///< of each row, in as many lines as they need
  double low = 0, high = 0;        ///< ends of the axis
  std::string grid = "x y";        ///< along which axes there are lines
  double row_height = 0;           ///< pixels; 0: what the words need
  std::string order = {};          ///< words above those of the rows
};

void add_rows(Sheet& sheet, const RowPanel& panel, const std::vector<RowColumn>& columns);

}  // namespace rockstack::plots
