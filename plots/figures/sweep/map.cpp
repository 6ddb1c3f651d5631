#include "plots/figures/sweep/map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

namespace rockstack::plots {
namespace {

using Edges = std::map<double, Range>;

/// Lower and upper edge of the cell around each value: halfway to its neighbours.
Edges cells(std::vector<double> values) {
  std::sort(values.begin(), values.end());
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

/// A stretch of cells above each other that have the same colour.
struct Box {
  std::size_t kind;
  double left, right, low, high;
};

Range ends(const Edges& edges) {
  return {edges.begin()->second.first, edges.rbegin()->second.second};
}

}  // namespace

std::size_t commonest(const std::vector<std::vector<double>>& counts, std::size_t row) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < counts.size(); ++k) {
    if (counts[k][row] > counts[best][row]) best = k;
  }
  return best;
}

CellMap cell_map(const std::string& name, const std::vector<double>& across, const std::vector<double>& up,
                 const std::vector<std::vector<double>>& counts, const std::vector<MapKind>& kinds) {
  const Edges columns = cells(across), rows = cells(up);
  CellMap map{{}, {}, std::vector<bool>(kinds.size()), ends(columns), ends(rows)};
  // Boxes reach into the next by a pixel or so, or the white behind them shines through.
  const double overlap = 1.5e-3 * (map.across.second - map.across.first);
  std::vector<Box> boxes;
  for (std::size_t row = 0; row < across.size(); ++row) {
    const auto [left, right] = columns.at(across[row]);
    const auto [low, high] = rows.at(up[row]);
    const std::size_t kind = commonest(counts, row);
    const bool goes_on =
        !boxes.empty() && boxes.back().kind == kind && boxes.back().left == left && boxes.back().high == low;
    if (goes_on) {
      boxes.back().high = high;
    } else {
      boxes.push_back({kind, left, right + overlap, low, high});
    }
  }
  std::vector<std::string> lines(kinds.size());
  for (const Box& box : boxes)
    lines[box.kind] += fmt::format("{} {} {} {} {} {}\n", plain(box.left), plain(box.low), plain(box.left),
                                   plain(box.right), plain(box.low), plain(box.high));
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    map.there[k] = !lines[k].empty();
    if (!map.there[k]) continue;
    map.elements.push_back(
        fmt::format("${}_{} using 1:2:3:4:5:6 with boxxyerror fs solid 1.0 noborder lc rgb '{}' notitle",
                    name, k, kinds[k].colour));
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

std::string map_ranges(const CellMap& map) {
  return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", plain(map.across.first),
                     plain(map.across.second), plain(map.up.first), plain(map.up.second));
}

}  // namespace rockstack::plots
