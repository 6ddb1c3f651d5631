#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "comparisons/results/csv.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/figures/sweep/drawings.hpp"

namespace rockstack::plots {
namespace {

/// What may become of a stack, as columns of overturning.csv, in the order in which they win a draw.
struct Kind {
  const char* column;
  const char* colour;
  const char* label;
};
constexpr std::array<Kind, 5> kinds{{{"rest", "#FFFFFF", "stays at rest"},
                                     {"rocking", "#C6DBEF", "rocks and stands"},
                                     {"toppled_after_impact", "#F2A65A", "topples after an impact"},
                                     {"toppled_without_impact", "#9E2A2B", "topples without an impact"},
                                     {"failed", "#808080", "could not be solved"}}};

using Edges = std::map<double, std::pair<double, double>>;

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

std::size_t commonest(const std::vector<std::vector<double>>& columns, std::size_t row) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < kinds.size(); ++k) {
    if (columns[2 + k][row] > columns[2 + best][row]) best = k;
  }
  return best;
}

/// A stretch of cells of one frequency that have the same colour.
struct Box {
  std::size_t kind;
  double left, right, low, high;
};

std::vector<Box> boxes(const std::vector<std::vector<double>>& columns, const Edges& across,
                       const Edges& up) {
  // Boxes reach into the next by half a pixel or so, or the white behind them shines through.
  const double overlap = 5e-4 * (across.rbegin()->second.second - across.begin()->second.first);
  std::vector<Box> list;
  for (std::size_t row = 0; row < columns[0].size(); ++row) {
    const auto [left, right] = across.at(columns[0][row]);
    const auto [low, high] = up.at(columns[1][row]);
    const std::size_t kind = commonest(columns, row);
    const bool goes_on =
        !list.empty() && list.back().kind == kind && list.back().left == left && list.back().high == low;
    if (goes_on) {
      list.back().high = high;
    } else {
      list.push_back({kind, left, right + overlap, low, high});
    }
  }
  return list;
}

/// The least intensity that topples in more than half of its runs.
std::string question(const std::vector<std::vector<double>>& columns, const SweepFacts& facts) {
  double least = std::numeric_limits<double>::infinity(), at = 0;
  for (std::size_t row = 0; row < columns[0].size(); ++row) {
    const std::string kind = kinds.at(commonest(columns, row)).column;
    if (kind.starts_with("toppled") && columns[1][row] < least) least = columns[1][row], at = columns[0][row];
  }
  if (!std::isfinite(least)) return "What topples? Nothing within these bounds";
  std::string answer =
      fmt::format("What topples? At least {:.3g}, {}, at {:.3g} Hz", least, facts.intensity, at);
  if (facts.least_acceleration > 0)
    answer += fmt::format(": {:.3g} times g tan α at ω/p = {:.3g}", least / facts.least_acceleration,
                          2 * std::numbers::pi * at / facts.frequency_parameter);
  return answer;
}

}  // namespace

Drawing overturning(const std::filesystem::path& results, const SweepFacts& facts) {
  std::vector<std::string> names{"frequency", "intensity"};
  for (const Kind& kind : kinds) names.emplace_back(kind.column);
  const auto columns = read_columns(results / "overturning.csv", names);
  const auto across = cells(columns[0]);
  const auto up = cells(columns[1]);
  if (across.empty()) return empty_sheet(facts.title, "There are no runs.");
  std::array<std::string, kinds.size()> lines;
  for (const Box& box : boxes(columns, across, up)) {
    lines.at(box.kind) += fmt::format("{} {} {} {} {} {}\n", plain(box.left), plain(box.low), plain(box.left),
                                      plain(box.right), plain(box.low), plain(box.high));
  }
  Legend legend;
  std::vector<std::string> elements;
  std::string data;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (lines.at(k).empty()) continue;
    const std::string fill = fmt::format("fs solid 1.0 noborder lc rgb '{}'", kinds.at(k).colour);
    legend.emplace_back(
        "with boxes fs solid 1.0 border lc rgb '#606060' fc rgb '" + std::string(kinds.at(k).colour) + "'",
        kinds.at(k).label);
    elements.push_back(fmt::format("$kind_{} using 1:2:3:4:5:6 with boxxyerror {} notitle", k, fill));
    data += fmt::format("$kind_{} << END\n{}END\n", k, lines.at(k));
  }
  Sheet sheet(facts.title, legend, question(columns, facts));
  if (facts.least_acceleration > 0) sheet.leave_room_for_second_axes();
  sheet.data(data);
  sheet.panel(620, 0,
              fmt::format("set tics out nomirror\nset xrange [{}:{}]\nset yrange [{}:{}]\n"
                          "set xlabel 'frequency of the pulse (Hz)'\nset ylabel {} noenhanced\n",
                          plain(across.begin()->second.first), plain(across.rbegin()->second.second),
                          plain(up.begin()->second.first), plain(up.rbegin()->second.second),
                          in_quotes(facts.intensity)) +
                  dimensionless_axis("x", across.begin()->second.first, across.rbegin()->second.second,
                                     facts.frequency_parameter / (2 * std::numbers::pi), "ω/p") +
                  dimensionless_axis("y", up.begin()->second.first, up.rbegin()->second.second,
                                     facts.least_acceleration, "over g tan α, of uplift"),
              elements);
  return sheet.finish();
}

}  // namespace rockstack::plots
