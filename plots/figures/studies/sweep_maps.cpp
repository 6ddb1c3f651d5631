#include <numbers>
#include <numeric>

#include "comparisons/measures/results/long_table.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "plots/drawing/maps.hpp"
#include "plots/figures/figure.hpp"
#include "plots/figures/studies/sweep_facts.hpp"

// What becomes of a stack, over two of a sweep's keys.

namespace rockstack::plots {
namespace {

using Columns = std::vector<std::vector<double>>;

/// Lower and upper edge of the cell around each value: halfway to its neighbours.
std::map<double, std::pair<double, double>> edges_of(std::vector<double> values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::map<double, std::pair<double, double>> edges;
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

/// The column with the largest count in a row; the first wins a draw.
std::size_t commonest(const Columns& counts, std::size_t row) {
  const auto of_row = [&](const std::vector<double>& column) { return column[row]; };
  return static_cast<std::size_t>(std::ranges::max_element(counts, {}, of_row) - counts.begin());
}

/// The value that stands for each along an axis: itself, or of more than a picture shows one of some
/// neighbours.
std::map<double, double> shown_values(std::vector<double> values) {
  constexpr std::size_t most = 250;
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  const std::size_t stride = 1 + (values.size() - 1) / most;
  std::map<double, double> shown;
  for (std::size_t i = 0; i < values.size(); ++i)
    shown[values[i]] = values[std::min(values.size() - 1, i / stride * stride + stride / 2)];
  return shown;
}

/// Puts places together that a picture does not show apart, with all that is counted there.
void join_neighbours(Columns& places, Columns& counts) {
  const auto across = shown_values(places[0]), up = shown_values(places[1]);
  std::map<std::pair<double, double>, std::vector<double>> joined;
  for (std::size_t row = 0; row < places[0].size(); ++row) {
    std::vector<double>& sums = joined[{across.at(places[0][row]), up.at(places[1][row])}];
    sums.resize(counts.size());
    for (std::size_t k = 0; k < counts.size(); ++k) sums[k] += counts[k][row];
  }
  if (joined.size() == places[0].size()) return;
  places = Columns(2);
  counts = Columns(counts.size());
  for (const auto& [place, sums] : joined) {
    places[0].push_back(place.first);
    places[1].push_back(place.second);
    for (std::size_t k = 0; k < counts.size(); ++k) counts[k].push_back(sums[k]);
  }
}

/// The cells around the values along both axes, each of its commonest kind, a column of counts a kind. Rows
/// go up first, then across; cells above each other of one kind are one.
std::vector<MapCell> counted_cells(Columns places, Columns counts) {
  join_neighbours(places, counts);
  const auto columns = edges_of(places[0]), rows = edges_of(places[1]);
  std::vector<MapCell> cells;
  for (std::size_t row = 0; row < places[0].size(); ++row) {
    const auto [left, right] = columns.at(places[0][row]);
    const auto [low, high] = rows.at(places[1][row]);
    const std::size_t kind = commonest(counts, row);
    if (!cells.empty() && cells.back().kind == kind && cells.back().left == left && cells.back().high == low)
      cells.back().high = high;
    else
      cells.push_back({left, right, low, high, kind});
  }
  return cells;
}

/// What may become of a stack, as columns of overturning.csv.
const std::vector<MapKind> outcomes{{"rest", "#FFFFFF", "stays at rest"},
                                    {"rocking", "#C6DBEF", "rocks and stands"},
                                    {"toppled_after_impact", "#F2A65A", "topples after an impact"},
                                    {"toppled_without_impact", "#9E2A2B", "topples without an impact"},
                                    {"failed", "#808080", "could not be solved"}};

/// The least intensity that topples in more than half of its runs.
std::string answer_of(const Columns& places, const Columns& counts, const SweepFacts& facts) {
  double least = std::numeric_limits<double>::infinity(), at = 0;
  for (std::size_t row = 0; row < places[0].size(); ++row) {
    const std::string kind = outcomes[commonest(counts, row)].name;
    if (kind.starts_with("toppled") && places[1][row] < least) least = places[1][row], at = places[0][row];
  }
  if (!std::isfinite(least)) return "Nothing within these bounds";
  std::string answer = fmt::format("No less than {}, at {:.3g} Hz", value_on(facts.intensity, least), at);
  if (facts.least_acceleration > 0)
    answer += fmt::format(": {:.3g} times g tan α at ω/p = {:.3g}", least / facts.least_acceleration,
                          2 * std::numbers::pi * at / facts.frequency_parameter);
  return answer;
}

/// What may become of a stack, as columns of modes.csv.
const std::vector<MapKind> mode_kinds{{"rest", "#FFFFFF", "rest"},
                                      {"slide", "#FEE391", "slide"},
                                      {"rock", "#C6DBEF", "rock"},
                                      {"slide_rock", "#6A9FB5", "slide-rock"},
                                      {"free_flight", "#B9A3D0", "free flight"},
                                      {"topple", "#9E2A2B", "topple"},
                                      {"fall", "#F2A65A", "fall off"},
                                      {"failed", "#808080", "could not be solved"}};

/// The columns of every kind; without a column of that name, as of ends that no motion begins with, zeros.
Columns mode_counts(const fs::path& file, const std::string& prefix) {
  const std::vector<std::string> names = column_names(file);
  const std::size_t rows = table_columns(file, {"failed"})[0].size();
  Columns list;
  for (const MapKind& kind : mode_kinds) {
    const std::string name = std::string(kind.name) == "failed" ? "failed" : prefix + kind.name;
    const bool there = std::ranges::find(names, name) != names.end();
    list.push_back(there ? table_columns(file, {name})[0] : std::vector<double>(rows, 0));
  }
  return list;
}

/// "Of 3024 runs 610 rest, …", without what does not happen.
std::string answer_of(const Columns& counts) {
  constexpr std::array words{"rest", "slide", "rock", "slide and rock", "fly", "topple", "fall off", "fail"};
  double all = 0;
  std::string text;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const double count = std::accumulate(counts[k].begin(), counts[k].end(), 0.0);
    all += count;
    if (count > 0) text += fmt::format("{}{:.0f} {}", text.empty() ? "" : ", ", count, words.at(k));
  }
  return fmt::format("Of {:.0f} runs {}", all, text);
}

}  // namespace

Drawings overturning(const FolderSubject& subject) {
  const SweepFacts facts = sweep_facts(subject.folder);
  const fs::path file = subject.folder / "overturning.csv";
  const auto places = table_columns(file, {"frequency", "intensity"});
  const auto counts =
      table_columns(file, mapped(outcomes, [](const MapKind& kind) { return std::string(kind.name); }));
  if (places[0].empty()) return {{"", empty_sheet(facts.title, "There are no runs.")}};
  const CellMap map = cell_map("kind", counted_cells(places, counts), outcomes);
  Sheet sheet = subject.sheet(facts.title, map_legend(outcomes, map.there), answer_of(places, counts, facts));
  if (facts.least_acceleration > 0) {
    sheet.leave_room_above(axis_above);
    sheet.leave_room_beside();
  }
  sheet.data(map.data);
  sheet.panel(subject.height(620), 0,
              map_axes(map) +
                  fmt::format("set xlabel 'frequency of the pulse (Hz)'\nset ylabel {} noenhanced\n",
                              in_quotes(facts.intensity)) +
                  dimensionless_axis("x", map.bounds.left, map.bounds.right,
                                     facts.frequency_parameter / (2 * std::numbers::pi), "ω/p") +
                  dimensionless_axis("y", map.bounds.low, map.bounds.high, facts.least_acceleration),
              map.elements);
  sheet.note(facts.caution());
  return {{"", sheet.finish()}};
}

Drawings modes(const FolderSubject& subject) {
  const SweepFacts facts = sweep_facts(subject.folder);
  const fs::path file = subject.folder / "modes.csv";
  const auto places = table_columns(file, {"intensity", "friction"});
  if (places[0].empty()) return {{"", empty_sheet(facts.title, "There are no runs.")}};
  CellMap onset = cell_map("onset", counted_cells(places, mode_counts(file, "onset_")), mode_kinds);
  const auto motions = mode_counts(file, "");
  const CellMap whole = cell_map("whole", counted_cells(places, motions), mode_kinds);
  std::vector<bool> there = onset.there;
  for (std::size_t k = 0; k < there.size(); ++k) there[k] = there[k] || whole.there[k];
  Legend legend = map_legend(mode_kinds, there);
  if (facts.struck) {
    const char* style = "with lines lw 3 lc rgb '#000000'";
    onset.data += fmt::format("$boundaries << END\n{}END\n",
                              initiation_boundaries(*facts.struck, onset.bounds.right, onset.bounds.high));
    onset.elements.push_back(fmt::format("$boundaries {} notitle", style));
    legend.emplace_back(style, "boundaries of Shenton 1996");
  }
  Sheet sheet = subject.sheet(facts.title, legend, answer_of(motions));
  sheet.data(onset.data + whole.data);
  sheet.leave_room_above(18);
  const std::string axes =
      map_axes(onset) + fmt::format("set xlabel {} noenhanced\n", in_quotes(facts.intensity));
  const std::string first = axes + "set title 'onset' offset 0,-0.7\nset ylabel 'friction coefficient'\n",
                    second = axes + "set title 'whole motion' offset 0,-0.7\n";
  constexpr double beside = 800;  // pixels that two maps need
  const double height = subject.height(460);
  if (sheet.width() < beside) {
    sheet.panel(height, 0, first, onset.elements);
    sheet.panel(height, 110, second + "set ylabel 'friction coefficient'\n", whole.elements);
  } else {
    sheet.row(height, 0,
              {{first, onset.elements}, {second + "set ylabel ''\nset format y ''\n", whole.elements}}, 2,
              left_edge);
  }
  sheet.note(facts.caution());
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
