#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "comparisons/measures/results/csv.hpp"
#include "plots/drawing/maps.hpp"
#include "plots/figures/figure.hpp"
#include "plots/figures/studies/sweep_facts.hpp"

namespace rockstack::plots {
namespace {

/// What may become of a stack, as columns of overturning.csv.
const std::vector<MapKind>& outcomes() {
  static const std::vector<MapKind> list{{"rest", "#FFFFFF", "stays at rest"},
                                         {"rocking", "#C6DBEF", "rocks and stands"},
                                         {"toppled_after_impact", "#F2A65A", "topples after an impact"},
                                         {"toppled_without_impact", "#9E2A2B", "topples without an impact"},
                                         {"failed", "#808080", "could not be solved"}};
  return list;
}

/// The least intensity that topples in more than half of its runs.
std::string answer_of(const std::vector<double>& frequencies, const std::vector<double>& intensities,
                      const std::vector<std::vector<double>>& counts, const SweepFacts& facts) {
  double least = std::numeric_limits<double>::infinity(), at = 0;
  for (std::size_t row = 0; row < frequencies.size(); ++row) {
    const std::string kind = outcomes()[commonest(counts, row)].name;
    if (kind.starts_with("toppled") && intensities[row] < least)
      least = intensities[row], at = frequencies[row];
  }
  if (!std::isfinite(least)) return "Nothing within these bounds";
  std::string answer = fmt::format("No less than {}, at {:.3g} Hz", value_on(facts.intensity, least), at);
  if (facts.least_acceleration > 0)
    answer += fmt::format(": {:.3g} times g tan α at ω/p = {:.3g}", least / facts.least_acceleration,
                          2 * std::numbers::pi * at / facts.frequency_parameter);
  return answer;
}

}  // namespace

Drawings overturning(const FolderSubject& subject) {
  const std::filesystem::path& results = subject.folder;
  const SweepFacts facts = sweep_facts(results);
  std::vector<std::string> names;
  for (const MapKind& kind : outcomes()) names.emplace_back(kind.name);
  const std::filesystem::path file = results / "overturning.csv";
  const auto places = read_columns(file, {"frequency", "intensity"});
  const auto counts = read_columns(file, names);
  if (places[0].empty()) return {{"", empty_sheet(facts.title, "There are no runs.")}};
  const CellMap map = cell_map("kind", counted_cells(places[0], places[1], counts), outcomes());
  Sheet sheet = subject.sheet(facts.title, map_legend(outcomes(), map.there),
                              answer_of(places[0], places[1], counts, facts));
  if (facts.least_acceleration > 0) {
    sheet.leave_room_above(axis_above);
    sheet.leave_room_beside();
  }
  sheet.data(map.data);
  sheet.panel(620, 0,
              map_axes(map) +
                  fmt::format("set xlabel 'frequency of the pulse (Hz)'\nset ylabel {} noenhanced\n",
                              in_quotes(facts.intensity)) +
                  dimensionless_axis("x", map.bounds.left, map.bounds.right,
                                     facts.frequency_parameter / (2 * std::numbers::pi), "ω/p") +
                  dimensionless_axis("y", map.bounds.low, map.bounds.high, facts.least_acceleration,
                                     "over g tan α, of uplift"),
              map.elements);
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
