#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "plots/data/law_results.hpp"
#include "plots/drawing/gnuplot.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// One map: a kind's cells and which of their counts is shown.
struct Map {
  std::string heading, kind;
  std::vector<LawCell> cells;
  double LawCell::*count;
};

double sum(const std::vector<LawCell>& cells, double LawCell::*count) {
  double total = 0;
  for (const LawCell& cell : cells) total += cell.*count;
  return total;
}

/// Of all impacts of the kind, percent.
double share_of(const Map& map) {
  return 100 * sum(map.cells, map.count) / sum(map.cells, &LawCell::impacts);
}

constexpr double least_share = 0.01;  ///< of a kind's impacts that a map is drawn for

std::vector<Map> maps_of(const std::vector<LawCell>& cells) {
  std::vector<std::string> kinds;
  std::map<std::string, std::vector<LawCell>> by_kind;
  for (const LawCell& cell : cells) {
    if (by_kind[cell.kind].empty()) kinds.push_back(cell.kind);
    by_kind[cell.kind].push_back(cell);
  }
  std::vector<Map> maps;
  for (const auto& [heading, count] :
       {std::pair{"laws differ", &LawCell::differ}, std::pair{"no pattern consistent", &LawCell::none}}) {
    for (const std::string& kind : kinds) {
      const auto& own = by_kind[kind];
      if (sum(own, count) >= least_share * sum(own, &LawCell::impacts) && sum(own, count) > 0)
        maps.push_back({heading, kind, by_kind[kind], count});
    }
  }
  return maps;
}

/// Grid coordinates by the lower edges of the cells.
std::vector<double> edges(const Map& map, double LawCell::*from, double LawCell::*to) {
  std::set<double> values;
  for (const LawCell& cell : map.cells) {
    values.insert(cell.*from);
    if (cell.*to > *values.rbegin() * (1 + 1e-9)) values.insert(cell.*to);
  }
  std::vector<double> list(values.begin(), values.end());
  const auto same = [](double a, double b) { return b - a < 1e-9 * b; };
  list.erase(std::unique(list.begin(), list.end(), same), list.end());
  return list;
}

/// Every second edge as a tic, so that there is room for its number.
std::string tics(const std::vector<double>& at) {
  std::string text;
  for (std::size_t i = 0; i < at.size(); i += 2) {
    text += fmt::format("{}'{:.2g}' {}", text.empty() ? "" : ", ", at[i], plain(std::log2(at[i])));
  }
  return "(" + text + ")";
}

std::string data_of(const Map& map, std::size_t index) {
  std::string text = fmt::format("$map_{} << END\n", index);
  for (const LawCell& cell : map.cells) {
    if (!(cell.impacts > 0)) continue;
    const auto middle = [](double from, double to) { return (std::log2(from) + std::log2(to)) / 2; };
    const auto half = [](double from, double to) { return (std::log2(to) - std::log2(from)) / 2; };
    text += fmt::format("{} {} {} {} {}\n", plain(middle(cell.aspect_ratio_from, cell.aspect_ratio_to)),
                        plain(middle(cell.mass_ratio_from, cell.mass_ratio_to)),
                        plain(half(cell.aspect_ratio_from, cell.aspect_ratio_to)),
                        plain(half(cell.mass_ratio_from, cell.mass_ratio_to)),
                        plain(100 * cell.*map.count / cell.impacts));
  }
  return text + "END\n";
}

constexpr int width = 1200;
constexpr double left = 104, right = 128, top = 158, gap_across = 66, gap_down = 92, bottom = 84;

/// Where panels lie, in pixels.
struct Grid {
  int columns, rows;
  double side;  ///< of a panel

  explicit Grid(std::size_t panels) {
    constexpr std::size_t few = 6;
    columns = panels > few ? 4 : 3;
    rows = (static_cast<int>(panels) + columns - 1) / columns;
    side = (width - left - right - (columns - 1) * gap_across) / columns;
  }
  double height() const { return top + bottom + rows * side + (rows - 1) * gap_down; }
};

std::string panel(const Map& map, std::size_t index, std::size_t panels, const Grid& grid) {
  const auto place = static_cast<int>(index);
  const double x = left + (place % grid.columns) * (grid.side + gap_across);
  const int row = place / grid.columns;
  const double y = top + row * (grid.side + gap_down);
  const bool lowest = index + static_cast<std::size_t>(grid.columns) >= panels;
  const auto across = edges(map, &LawCell::aspect_ratio_from, &LawCell::aspect_ratio_to);
  const auto up = edges(map, &LawCell::mass_ratio_from, &LawCell::mass_ratio_to);
  std::string text = fmt::format("set margins screen {}, screen {}, screen {}, screen {}\n", plain(x / width),
                                 plain((x + grid.side) / width), plain(1 - (y + grid.side) / grid.height()),
                                 plain(1 - y / grid.height()));
  text += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\nset xtics {}\nset ytics {}\n",
                      plain(std::log2(across.front())), plain(std::log2(across.back())),
                      plain(std::log2(up.front())), plain(std::log2(up.back())), tics(across), tics(up));
  text += lowest ? "set xlabel 'top: height / width'\n" : "unset xlabel\n";
  text += place % grid.columns == 0 ? "set ylabel 'its mass over that below'\n" : "unset ylabel\n";
  text += fmt::format("set label 1 {} noenhanced at graph 0, graph 1 offset 0,1.7 font ',13'\n",
                      in_quotes(map.kind));
  text += fmt::format("set label 2 {} noenhanced at graph 0, graph 1 offset 0,0.7 font ',12'\n",
                      in_quotes(fmt::format("{}: {:.1f} %", map.heading, share_of(map))));
  text += fmt::format("plot $map_{} using 1:2:3:4:5 with boxxyerror fs solid noborder lc palette notitle\n",
                      index);
  return text;
}

/// The kind of impact after which the laws differ most.
std::string answer_of(const std::vector<Map>& maps) {
  const Map* most = nullptr;
  for (const Map& map : maps)
    if (map.count == &LawCell::differ && (most == nullptr || share_of(map) > share_of(*most))) most = &map;
  return most == nullptr ? "After no kind of impact"
                         : fmt::format("Most after {}: {:.1f} % of its states", most->kind, share_of(*most));
}

std::string words_under_title(int label, const std::string& words, double below, double height) {
  return fmt::format(
      "set label {} {} noenhanced at screen 0.5, screen {} center font ',14' tc rgb '#404040'\n", label,
      in_quotes(words), plain(1 - below / height));
}

Drawing drawing(const std::string& question, int blocks, const std::vector<Map>& maps) {
  const Grid grid(maps.size());
  Drawing result{width, static_cast<int>(grid.height()), {}, {}};
  result.commands = fmt::format(
      "set multiplot\nunset key\nset tics out nomirror scale 0.6 font ',10'\n"
      "set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb '#C8C8C8' fs solid noborder\n"
      "set palette defined (0 '#FFFFFF', 25 '#C6DBEF', 50 '#6BAED6', 75 '#2171B5', 100 '#08306B')\n"
      "set cbrange [0:100]\nset cblabel 'share of impacts (%)'\n"
      "set colorbox user origin screen {}, screen {} size screen 0.014, screen {}\n"
      "set label 9 {} noenhanced at screen 0.5, screen {} center font ',17'\n",
      plain(1 - (right - 22) / width), plain(1 - (top + grid.side) / grid.height()),
      plain(grid.side / grid.height()),
      in_quotes(fmt::format("Which pattern follows an impact of {} blocks", blocks)),
      plain(1 - 22 / grid.height()));
  result.commands += words_under_title(7, question, 56, grid.height()) +
                     words_under_title(8, answer_of(maps), 78, grid.height());
  for (std::size_t i = 0; i < maps.size(); ++i) {
    result.data += data_of(maps[i], i);
    result.commands += panel(maps[i], i, maps.size(), grid);
    if (i == 0) result.commands += "unset label 7\nunset label 8\nunset label 9\nunset colorbox\n";
  }
  result.commands += "unset multiplot";
  return result;
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
    const std::vector<Map> maps = maps_of(cells);
    drawings[part] = maps.empty()
                         ? empty_sheet("impact-laws." + part, "Both laws give the same pattern everywhere.")
                         : drawing(subject.figure.question, blocks, maps);
  }
  return drawings;
}

}  // namespace rockstack::plots
