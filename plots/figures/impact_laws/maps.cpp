#include "plots/data/law_results.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// One map: a kind's cells, which of their counts is shown, and how much that is of all impacts.
struct LawMap {
  std::string heading, kind;
  std::vector<LawCell> cells;
  double LawCell::*count;
  double percent;
};

double sum(const std::vector<LawCell>& cells, double LawCell::*count) {
  double total = 0;
  for (const LawCell& cell : cells) total += cell.*count;
  return total;
}

constexpr double least_share = 0.01;  ///< of a kind's impacts that a map is drawn for

std::vector<LawMap> maps_of(const std::vector<LawCell>& cells) {
  std::vector<std::string> kinds;
  std::map<std::string, std::vector<LawCell>> by_kind;
  for (const LawCell& cell : cells) {
    if (by_kind[cell.kind].empty()) kinds.push_back(cell.kind);
    by_kind[cell.kind].push_back(cell);
  }
  std::vector<LawMap> maps;
  for (const auto& [heading, count] :
       {std::pair{"laws differ", &LawCell::differ}, {"no pattern consistent", &LawCell::none}})
    for (const std::string& kind : kinds) {
      const auto& own = by_kind[kind];
      const double shown = sum(own, count), all = sum(own, &LawCell::impacts);
      if (shown >= least_share * all && shown > 0)
        maps.push_back({heading, kind, own, count, 100 * shown / all});
    }
  return maps;
}

/// Edges of all cells along one axis.
std::vector<double> edges(const std::vector<LawCell>& cells, double LawCell::*from, double LawCell::*to) {
  std::set<double> values;
  for (const LawCell& cell : cells) values.insert({cell.*from, cell.*to});
  std::vector<double> list(values.begin(), values.end());
  const auto same = [](double a, double b) { return b - a < 1e-9 * b; };
  list.erase(std::unique(list.begin(), list.end(), same), list.end());
  return list;
}

/// The range of an axis, and every second edge as a tic, so that there is room for its number.
std::string axis_of(const std::string& axis, const std::vector<double>& edges) {
  std::string tics;
  for (std::size_t i = 0; i < edges.size(); i += 2)
    tics += fmt::format("{}'{:.2g}' {}", tics.empty() ? "" : ", ", edges[i], plain(std::log2(edges[i])));
  return fmt::format("set {0}range [{1}:{2}]\nset {0}tics ({3}) font ',10'\n", axis,
                     plain(std::log2(edges.front())), plain(std::log2(edges.back())), tics);
}

Numbers numbers_of(const LawMap& map) {
  const auto middle = [](double from, double to) { return (std::log2(from) + std::log2(to)) / 2; };
  const auto half = [](double from, double to) { return (std::log2(to) - std::log2(from)) / 2; };
  Numbers numbers;
  for (const LawCell& cell : map.cells)
    if (cell.impacts > 0)
      numbers.push_back({middle(cell.aspect_ratio_from, cell.aspect_ratio_to),
                         middle(cell.mass_ratio_from, cell.mass_ratio_to),
                         half(cell.aspect_ratio_from, cell.aspect_ratio_to),
                         half(cell.mass_ratio_from, cell.mass_ratio_to),
                         100 * cell.*map.count / cell.impacts});
  return numbers;
}

/// From none of the impacts to all of them.
constexpr std::array shades{"#FFFFFF", "#C6DBEF", "#6BAED6", "#2171B5", "#08306B"};
constexpr auto no_impact = "#C8C8C8";

Legend shade_legend() {
  Legend legend;
  for (const char* shade : shades)
    legend.emplace_back(
        fmt::format("with boxes fillcolor rgb '{}' fillstyle solid 1 border lc rgb '#808080'", shade),
        fmt::format("{} % of impacts", 25 * legend.size()));
  legend.emplace_back(fmt::format("with boxes fillcolor rgb '{}' fillstyle solid 1 noborder", no_impact),
                      "no impact was judged");
  return legend;
}

/// Of all panels.
std::string settings_of(const std::vector<LawCell>& cells) {
  int percent = -25;
  const auto shade = [&](const char* colour) { return fmt::format("{} '{}'", percent += 25, colour); };
  return fmt::format(
             "set tics out nomirror scale 0.6\nset palette defined ({})\nset cbrange [0:100]\nunset colorbox\n"
             "set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb '{}' fs solid noborder\n",
             text_of_each(shades, shade, ", "), no_impact) +
         axis_of("x", edges(cells, &LawCell::aspect_ratio_from, &LawCell::aspect_ratio_to)) +
         axis_of("y", edges(cells, &LawCell::mass_ratio_from, &LawCell::mass_ratio_to));
}

/// The kind of impact after which the laws differ most.
std::string answer_of(const std::vector<LawMap>& maps) {
  const LawMap* most = nullptr;
  for (const LawMap& map : maps)
    if (map.count == &LawCell::differ && (most == nullptr || map.percent > most->percent)) most = &map;
  return most == nullptr ? "After no kind of impact"
                         : fmt::format("Most after {}: {:.1f} % of its states", most->kind, most->percent);
}

}  // namespace

/// A figure a number of blocks: a panel a kind of impact, of the share in which the laws differ and of that
/// in which no pattern is consistent.
Drawings law_maps(const FolderSubject& subject) {
  std::map<int, std::vector<LawCell>> by_blocks;
  for (const LawCell& cell : read_law_results(subject.folder).cells) by_blocks[cell.blocks].push_back(cell);
  Drawings drawings;
  for (const auto& [blocks, cells] : by_blocks) {
    const std::string part = fmt::format("{}-blocks", blocks);
    const std::vector<LawMap> maps = maps_of(cells);
    if (maps.empty()) {
      drawings[part] = empty_sheet("impact-laws." + part, "Both laws give the same pattern everywhere.");
      continue;
    }
    Sheet sheet = subject.figure.sheet(fmt::format("Which pattern follows an impact of {} blocks", blocks),
                                       shade_legend(), answer_of(maps));
    sheet.leave_room_above(12);
    std::vector<Series> panels;
    for (const LawMap& map : maps) {
      const std::string name = fmt::format("map_{}", panels.size());
      sheet.data(number_block(name, numbers_of(map)));
      panels.push_back({fmt::format("{}, {}: {:.1f} %", map.kind, map.heading, map.percent), "#000000"});
      panels.back().alone = {
          fmt::format("${} using 1:2:3:4:5 with boxxyerror fs solid noborder lc palette notitle", name)};
    }
    add_multiples(sheet, panels, {}, settings_of(cells), "height / width of the top block", "mass ratio");
    drawings[part] = sheet.finish();
  }
  return drawings;
}

}  // namespace rockstack::plots
