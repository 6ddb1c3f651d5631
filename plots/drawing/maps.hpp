#pragma once

#include "plots/drawing/layout.hpp"

namespace rockstack::plots {

// Maps whose cells have the colour of what becomes of a run there.

/// What may become of a run: what a table calls it, and how a map shows it.
struct MapKind {
  const char* name;
  const char* colour;
  const char* label;
};

/// One cell: its edges and the index of its kind.
struct MapCell {
  double left = 0, right = 0, low = 0, high = 0;
  std::size_t kind = 0;
};

struct CellMap {
  std::vector<std::string> elements;  ///< of a plot command
  std::string data;                   ///< the blocks that they draw
  std::vector<bool> there;            ///< which kinds have a cell
  MapCell bounds;                     ///< of all cells
};

/// `name` heads the data blocks; cells are framed by `border`, a colour, or without one by nothing.
/// Precondition: there are cells.
CellMap cell_map(const std::string& name, const std::vector<MapCell>& cells,
                 const std::vector<MapKind>& kinds, const std::string& border = "");

/// The kinds that have cells.
Legend map_legend(const std::vector<MapKind>& kinds, const std::vector<bool>& there);

/// Ticks outside, and the ranges of the axes.
std::string map_axes(const CellMap& map);

}  // namespace rockstack::plots
