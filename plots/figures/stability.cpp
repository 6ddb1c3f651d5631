#include "plots/figures/stability.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "plots/data/json_file.hpp"
#include "plots/drawing/layout.hpp"

namespace rockstack::plots {
namespace {

struct VerdictStyle {
  const char* verdict;
  const char* colour;
  const char* label;
};
/// From light to dark, so that they are told apart in grey and by everyone.
constexpr std::array<VerdictStyle, 4> styles{
    {{"sound", "#D3EDE0", "sound: within all limits"},
     {"inexact", "#EDB93A", "inexact: physical, but off"},
     {"unstable", "#C43C4E", "unstable: gains energy, or topples what stands"},
     {"failed", "#2F2F2F", "failed: the run did not end well"}}};

/// One square of a map.
struct Cell {
  double value, dt;
  std::string verdict;
};

/// A place on an axis whose values are drawn one beside the other.
class Places {
 public:
  explicit Places(const std::set<double>& values) : values_(values.begin(), values.end()) {}
  std::size_t of(double value) const {
    return static_cast<std::size_t>(std::lower_bound(values_.begin(), values_.end(), value) -
                                    values_.begin());
  }
  std::size_t size() const { return values_.size(); }
  /// Labels in a unit that many times smaller.
  std::string tics(double times = 1) const {
    std::string text;
    for (std::size_t i = 0; i < values_.size(); ++i)
      text += fmt::format("{}'{:.4g}' {}", i > 0 ? ", " : "", times * values_[i], i);
    return text;
  }

 private:
  std::vector<double> values_;
};

/// What is drawn of one solver: its cells, and the largest stable step at each value.
struct Map {
  std::string solver;  ///< in words
  std::vector<Cell> cells;
  std::vector<std::pair<double, double>> stable;
};

std::map<std::string, Map> read_maps(const std::filesystem::path& results) {
  const auto file = results / "stability.csv";
  const Table table = read_table(file);
  const auto at = [&](const char* name) { return column(table, name, file); };
  const std::size_t engine = at("engine"), solver = at("solver"), settings = at("settings"), dt = at("dt"),
                    value = at("value"), verdict = at("verdict");
  std::map<std::string, Map> maps;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    if (row[dt].empty()) continue;
    const std::string place = fmt::format("{}:{}", file.string(), i + 2);
    Map& map = maps[row[engine] + "-" + row[solver] + "-" + row[settings]];
    map.solver = fmt::format("{} {}, {}", row[engine], row[solver], row[settings]);
    map.cells.push_back({number(row[value], place, "value"), number(row[dt], place, "dt"), row[verdict]});
  }
  const auto steps_file = results / "steps.csv";
  const Table steps = read_table(steps_file);
  const std::size_t stable = column(steps, "largest_stable_step", steps_file);
  const std::size_t along = column(steps, "value", steps_file);
  for (std::size_t i = 0; i < steps.rows.size(); ++i) {
    const auto& row = steps.rows[i];
    const std::string place = fmt::format("{}:{}", steps_file.string(), i + 2);
    maps[row[0] + "-" + row[1] + "-" + row[2]].stable.emplace_back(
        number(row[along], place, "value"), number(row[stable], place, "largest_stable_step"));
  }
  return maps;
}

/// The upper edges of the squares of the largest stable steps, as a staircase.
std::string staircase(const Map& map, const Places& across, const Places& up) {
  std::string text = "$stable << END\n";
  std::vector<std::pair<std::size_t, double>> edges;
  for (const auto& [value, step] : map.stable)
    edges.emplace_back(across.of(value), step > 0 ? static_cast<double>(up.of(step)) + 0.5 : -0.5);
  std::sort(edges.begin(), edges.end());
  for (const auto& [x, y] : edges)
    text += fmt::format("{} {}\n{} {}\n", static_cast<double>(x) - 0.5, y, static_cast<double>(x) + 0.5, y);
  return text + "END\n";
}

std::string question(const Map& map) {
  const auto sound = std::count_if(map.cells.begin(), map.cells.end(),
                                   [](const Cell& cell) { return cell.verdict == "sound"; });
  return fmt::format("Where does it stop being right? {} of {} runs are sound", sound, map.cells.size());
}

Drawing drawing(const Map& map, const Json& facts) {
  std::set<double> values;
  std::set<double> steps;
  for (const Cell& cell : map.cells) {
    values.insert(cell.value);
    steps.insert(cell.dt);
  }
  const Places across(values);
  const Places up(steps);
  Legend legend;
  std::string data = staircase(map, across, up);
  std::vector<std::string> elements;
  for (std::size_t k = 0; k < styles.size(); ++k) {
    const VerdictStyle& style = styles.at(k);
    legend.emplace_back(
        fmt::format("with boxes fs solid 1.0 border lc rgb '#606060' fc rgb '{}'", style.colour),
        style.label);
    std::string lines;
    for (const Cell& cell : map.cells) {
      if (cell.verdict == style.verdict)
        lines += fmt::format("{} {} 0.5 0.5\n", across.of(cell.value), up.of(cell.dt));
    }
    if (lines.empty()) continue;
    data += fmt::format("$kind_{} << END\n{}END\n", k, lines);
    elements.push_back(
        fmt::format("$kind_{} using 1:2:3:4 with boxxyerror fs solid 1.0 border lc rgb 'white' "
                    "fc rgb '{}' notitle",
                    k, style.colour));
  }
  elements.emplace_back("$stable using 1:2 with lines lw 4 lc rgb 'black' notitle");
  legend.emplace_back("with lines lw 4 lc rgb 'black'", "largest stable step");
  Sheet sheet(map.solver + ": " + facts.at("title").get<std::string>(), legend, question(map));
  sheet.data(data);
  sheet.panel(
      460, 0,
      fmt::format("set tics out nomirror\nset xrange [-0.5:{}]\nset yrange [-0.5:{}]\nset xtics ({})\n"
                  "set ytics ({})\nset xlabel {} noenhanced\nset ylabel 'time step (ms)'\n",
                  static_cast<double>(across.size()) - 0.5, static_cast<double>(up.size()) - 0.5,
                  across.tics(), up.tics(1000), in_quotes(facts.at("axis").get<std::string>())),
      elements);
  return sheet.finish();
}

Json study_facts(const std::filesystem::path& file) {
  const Json facts = read_json(file);
  if (!facts.contains("title") || !facts.contains("axis"))
    throw InputError(file.string() + ": must be the results of a study of stability, with title and axis");
  return facts;
}

}  // namespace

bool has_stability(const std::filesystem::path& results) {
  return std::filesystem::exists(results / "stability.json");
}

void draw_stability(const std::filesystem::path& results) {
  const Json facts = study_facts(results / "stability.json");
  std::filesystem::create_directories(results / "figures");
  for (const auto& [solver, map] : read_maps(results)) {
    const std::string name =
        "stability." + file_name(solver, (results / "stability.csv").string() + ": solver");
    if (!map.cells.empty()) draw(drawing(map, facts), results / "figures" / name);
  }
}

}  // namespace rockstack::plots
