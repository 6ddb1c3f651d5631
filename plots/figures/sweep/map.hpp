#pragma once

#include <string>
#include <utility>
#include <vector>

#include "plots/drawing/layout.hpp"

namespace rockstack::plots {

/// What may become of a run: a column of counts, and how a map shows it.
struct MapKind {
  const char* column;
  const char* colour;
  const char* label;
};

/// The ends of an axis.
using Range = std::pair<double, double>;

/// A map whose cells have the colour of what most of their runs come to; the first kind wins a draw.
struct CellMap {
  std::vector<std::string> elements;  ///< of a plot command
  std::string data;                   ///< the blocks that they draw
  std::vector<bool> there;            ///< which kinds have a cell
  Range across, up;                   ///< of the axes
};

/// The index of the largest count of a row of columns.
std::size_t commonest(const std::vector<std::vector<double>>& counts, std::size_t row);

/// Rows go up first, then across. `name` heads those of the data blocks. Precondition: there are rows.
CellMap cell_map(const std::string& name, const std::vector<double>& across, const std::vector<double>& up,
                 const std::vector<std::vector<double>>& counts, const std::vector<MapKind>& kinds);

/// The kinds that have cells.
Legend map_legend(const std::vector<MapKind>& kinds, const std::vector<bool>& there);

/// "set xrange …" and "set yrange …".
std::string map_ranges(const CellMap& map);

}  // namespace rockstack::plots
