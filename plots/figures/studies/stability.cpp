#include "comparisons/measures/results/csv.hpp"
#include "plots/drawing/maps.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// From light to dark, so that they are told apart in grey and by everyone.
const std::vector<MapKind> verdict_kinds{
    {"sound", "#D3EDE0", "sound: within all limits"},
    {"inexact", "#EDB93A", "inexact: physical, but off"},
    {"unstable", "#C43C4E", "unstable: gains energy, or topples what stands"},
    {"failed", "#2F2F2F", "failed: the run did not end well"}};

struct StabilityCell {
  double value, dt;
  std::string verdict;
};

/// Values along an axis, drawn one beside the other.
using Places = std::set<double>;

double place_of(double value, const Places& places) {
  return static_cast<double>(std::distance(places.begin(), places.lower_bound(value)));
}

/// Labels in a unit that many times smaller, as many as an axis of so many pixels has room for.
std::string tics(const Places& places, double times, double pixels) {
  constexpr double letter = 11.5;  // pixels
  std::vector<std::string> words =
      mapped(places, [&](double value) { return fmt::format("{:.4g}", times * value); });
  const auto longest = static_cast<double>(std::ranges::max(words, {}, &std::string::size).size());
  const double cell = pixels / static_cast<double>(words.size());
  const auto stride = static_cast<std::size_t>(std::ceil(std::max(letter * (longest + 1) / cell, 1.0)));
  for (std::size_t i = 0; i < words.size(); ++i)
    if (i % stride != 0) words[i].clear();
  return word_tics(words);
}

/// What is drawn of one solver: its cells, and the largest stable step at each value.
struct StabilityMap {
  std::string solver;  ///< in words
  std::vector<StabilityCell> cells;
  std::vector<std::pair<double, double>> stable;
};

std::map<std::string, StabilityMap> read_maps(const fs::path& results) {
  std::map<std::string, StabilityMap> maps;
  const auto map_of = [&](const CsvLine& row) -> StabilityMap& {
    return maps[row.text("engine") + "-" + row.text("solver") + "-" + row.text("settings")];
  };
  for (CsvLine row(results / "stability.csv"); row.next();) {
    if (std::isnan(row.value("dt"))) continue;
    StabilityMap& map = map_of(row);
    map.solver = fmt::format("{} {}, {}", row.text("engine"), row.text("solver"), row.text("settings"));
    map.cells.push_back({row.value("value"), row.value("dt"), row.text("verdict")});
  }
  for (CsvLine row(results / "steps.csv"); row.next();)
    map_of(row).stable.emplace_back(row.value("value"), row.value("largest_stable_step"));
  return maps;
}

/// The upper edges of the squares of the largest stable steps, as a staircase.
Numbers staircase(const StabilityMap& map, const Places& across, const Places& up) {
  std::map<double, double> edges;
  for (const auto& [value, step] : map.stable)
    edges[place_of(value, across)] = step > 0 ? place_of(step, up) + 0.5 : -0.5;
  Numbers stairs;
  for (const auto& [x, y] : edges) stairs.insert(stairs.end(), {{x - 0.5, y}, {x + 0.5, y}});
  return stairs;
}

/// The index of a verdict; those that are none are failed.
std::size_t kind_of(const std::string& verdict) {
  const auto found = std::find_if(verdict_kinds.begin(), verdict_kinds.end() - 1,
                                  [&](const MapKind& kind) { return verdict == kind.name; });
  return static_cast<std::size_t>(found - verdict_kinds.begin());
}

Drawing drawing(const FolderSubject& subject, const StabilityMap& map, const Json& facts) {
  Places across, up;
  for (const StabilityCell& cell : map.cells) across.insert(cell.value), up.insert(cell.dt);
  std::vector<MapCell> cells;
  for (const StabilityCell& cell : map.cells) {
    const double x = place_of(cell.value, across), y = place_of(cell.dt, up);
    cells.push_back({x - 0.5, x + 0.5, y - 0.5, y + 0.5, kind_of(cell.verdict)});
  }
  CellMap drawn = cell_map("kind", cells, verdict_kinds, "white");
  Legend legend = map_legend(verdict_kinds, std::vector<bool>(verdict_kinds.size(), true));
  const char* stable_style = "with lines lw 4 lc rgb 'black'";
  legend.emplace_back(stable_style, "largest stable step");
  drawn.elements.push_back(plot_of("stable", stable_style));
  const std::string title = facts.at("title"), axis = facts.at("axis");
  const auto sound = std::ranges::count(map.cells, "sound", &StabilityCell::verdict);
  Sheet sheet = subject.sheet(map.solver + ": " + title, legend,
                              fmt::format("{} of {} runs are sound", sound, map.cells.size()));
  sheet.data(number_block("stable", staircase(map, across, up)) + drawn.data);
  sheet.panel(subject.height(460), 0,
              map_axes(drawn) + fmt::format("set xtics ({})\nset ytics ({})\nset xlabel {} noenhanced\n"
                                            "set ylabel 'time step (ms)'\n",
                                            tics(across, 1, sheet.panel_width()), tics(up, 1000, HUGE_VAL),
                                            in_quotes(axis)),
              drawn.elements);
  return sheet.finish();
}

}  // namespace

Drawings stability(const FolderSubject& subject) {
  return read_json(subject.folder / "stability.json", [&](const Json& facts) {
    Drawings drawings;
    for (const auto& [solver, map] : read_maps(subject.folder))
      if (!map.cells.empty())
        drawings[file_name(solver, (subject.folder / "stability.csv").string() + ": solver")] =
            drawing(subject, map, facts);
    return drawings;
  });
}

}  // namespace rockstack::plots
