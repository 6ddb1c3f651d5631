#include "plots/drawing/maps.hpp"

#include <fmt/core.h>

namespace rockstack::plots {
CellMap cell_map(const std::string& name, const std::vector<MapCell>& cells,
                 const std::vector<MapKind>& kinds, const std::string& border) {
  CellMap map{{}, {}, std::vector<bool>(kinds.size()), cells.front()};
  MapCell& all = map.bounds;
  for (const MapCell& cell : cells)
    all = {std::min(all.left, cell.left), std::max(all.right, cell.right), std::min(all.low, cell.low),
           std::max(all.high, cell.high)};
  // Cells without a frame reach into the next by a pixel or so, or the white behind them shines through.
  const double overlap = border.empty() ? 1.5e-3 * (all.right - all.left) : 0;
  const std::string frame = border.empty() ? "noborder" : fmt::format("border lc rgb '{}'", border);
  std::vector<std::string> lines(kinds.size());
  for (const MapCell& cell : cells)
    lines[cell.kind] += fmt::format("{0} {2} {0} {1} {2} {3}\n", plain(cell.left),
                                    plain(cell.right + overlap), plain(cell.low), plain(cell.high));
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    map.there[k] = !lines[k].empty();
    if (!map.there[k]) continue;
    map.elements.push_back(
        fmt::format("${}_{} using 1:2:3:4:5:6 with boxxyerror fs solid 1.0 {} fc rgb '{}' notitle", name, k,
                    frame, kinds[k].colour));
    map.data += fmt::format("${}_{} << END\n{}END\n", name, k, lines[k]);
  }
  return map;
}

Legend map_legend(const std::vector<MapKind>& kinds, const std::vector<bool>& there) {
  Legend legend;
  for (std::size_t k = 0; k < kinds.size(); ++k)
    if (there[k])
      legend.emplace_back(
          fmt::format("with boxes fs solid 1.0 border lc rgb '#606060' fc rgb '{}'", kinds[k].colour),
          kinds[k].label);
  return legend;
}

std::string map_axes(const CellMap& map) {
  return fmt::format("set tics out nomirror\nset xrange [{}:{}]\nset yrange [{}:{}]\n",
                     plain(map.bounds.left), plain(map.bounds.right), plain(map.bounds.low),
                     plain(map.bounds.high));
}

}  // namespace rockstack::plots
