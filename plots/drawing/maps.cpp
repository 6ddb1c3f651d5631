#include "plots/drawing/maps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

namespace rockstack::plots {
namespace {

using Edges = std::map<double, std::pair<double, double>>;

/// Lower and upper edge of the cell around each value: halfway to its neighbours.
Edges edges_of(std::vector<double> values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  Edges edges;
  const std::size_t n = values.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double first = i > 0   ? (values[i - 1] + values[i]) / 2
                         : n > 1 ? (3 * values[0] - values[1]) / 2
                                 : values[0] - 0.5;
    const double last = i + 1 < n ? (values[i] + values[i + 1]) / 2 : 2 * values[i] - first;
    edges[values[i]] = {first, last};
  }
  return edges;
}

}  // namespace

std::size_t commonest(const std::vector<std::vector<double>>& counts, std::size_t row) {
  const auto of_row = [&](const std::vector<double>& column) { return column[row]; };
  return static_cast<std::size_t>(std::ranges::max_element(counts, {}, of_row) - counts.begin());
}

std::vector<MapCell> counted_cells(const std::vector<double>& across, const std::vector<double>& up,
                                   const std::vector<std::vector<double>>& counts) {
  const Edges columns = edges_of(across), rows = edges_of(up);
  std::vector<MapCell> cells;
  for (std::size_t row = 0; row < across.size(); ++row) {
    const auto [left, right] = columns.at(across[row]);
    const auto [low, high] = rows.at(up[row]);
    const std::size_t kind = commonest(counts, row);
    if (!cells.empty() && cells.back().kind == kind && cells.back().left == left && cells.back().high == low)
      cells.back().high = high;
    else
      cells.push_back({left, right, low, high, kind});
  }
  return cells;
}

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
