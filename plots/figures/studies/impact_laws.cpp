#include "plots/data/law_results.hpp"
#include "plots/figures/figure.hpp"

// Where the laws of impact differ, and how far engines are from either.

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

std::vector<LawMap> maps_of(const std::vector<LawCell>& cells) {
  std::vector<std::vector<LawCell>> by_kind;
  for (const LawCell& cell : cells)
    found_or_added(by_kind, [&](const auto& own) { return own.front().kind == cell.kind; }, {})
        .push_back(cell);
  std::vector<LawMap> maps;
  for (const auto& [heading, count] :
       {std::pair{"laws differ", &LawCell::differ}, {"no pattern consistent", &LawCell::none}})
    for (const std::vector<LawCell>& own : by_kind) {
      const double shown = sum(own, count), all = sum(own, &LawCell::impacts);
      if (shown >= 0.01 * all && shown > 0)  // a map of less would say nothing
        maps.push_back({heading, own.front().kind, own, count, 100 * shown / all});
    }
  return maps;
}

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

std::string settings_of(const std::vector<LawCell>& cells) {
  int percent = -25;
  const auto shade = [&](const char* colour) { return fmt::format("{} '{}'", percent += 25, colour); };
  return fmt::format(
             "set tics out nomirror scale 0.6\nset palette defined ({})\nset cbrange [0:100]\nunset colorbox\n"
             "set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb '{}' fs solid noborder\n",
             joined_texts(shades, shade, ", "), no_impact) +
         axis_of("x", edges(cells, &LawCell::aspect_ratio_from, &LawCell::aspect_ratio_to)) +
         axis_of("y", edges(cells, &LawCell::mass_ratio_from, &LawCell::mass_ratio_to));
}

std::string answer_of(const std::vector<LawMap>& maps) {
  const LawMap* most = nullptr;
  for (const LawMap& map : maps)
    if (map.count == &LawCell::differ && (most == nullptr || map.percent > most->percent)) most = &map;
  return most == nullptr ? "After no kind of impact"
                         : fmt::format("Most after {}: {:.1f} % of its states", most->kind, most->percent);
}

/// The runs of one solver with one step length: one mark in the figure.
struct Marks {
  Run run;
  Numbers at = {};  ///< from law paper, from law consistent
};

std::vector<Marks> marks_of(const std::vector<LawRun>& runs) {
  std::vector<Marks> list;
  for (const LawRun& one : runs) {
    if (!(one.from_paper > 0 && one.from_consistent > 0)) continue;
    const std::string label = run_label(one.run);
    found_or_added(list, [&](const Marks& m) { return run_label(m.run) == label; }, {one.run})
        .at.push_back({one.from_paper, one.from_consistent});
  }
  return list;
}

/// Where values lie but for those far away, which must not press the rest together: on a logarithmic axis all
/// within one and a half times the middle half's extent beyond it (Tukey 1977), with room.
Extent reach_of(const std::vector<double>& values) {
  const double lower = quantile(values, 0.25), upper = quantile(values, 0.75);
  const double beyond = std::pow(upper / lower, 1.5);
  constexpr double room = 1.6;
  return {std::max(quantile(values, 0), lower / beyond) / room,
          std::min(quantile(values, 1), upper * beyond) * room};
}

struct LawFrame {
  Extent across, up;

  /// A mark, or of one that lies beyond the frame, the nearest place on its edge.
  std::vector<double> inside(const std::vector<double>& mark) const {
    return {std::clamp(mark[0], across.low, across.high), std::clamp(mark[1], up.low, up.high)};
  }
};

LawFrame frame_of(const std::vector<Marks>& list) {
  std::vector<double> across, up;
  for (const Marks& marks : list)
    for (const std::vector<double>& mark : marks.at) {
      across.push_back(mark[0]);
      up.push_back(mark[1]);
    }
  return {reach_of(across), reach_of(up)};
}

std::string answer(const LawResults& results) {
  const auto count = [&](const char* law) { return std::ranges::count(results.runs, law, &LawRun::follows); };
  return fmt::format("Of {} runs {} end as law consistent says, {} as law paper",
                     std::ssize(results.runs) - count(""), count("consistent"), count("paper"));
}

constexpr auto border_style = "with lines lw 2 dt (8,8) lc rgb '#606060'";

/// A series a solver, by its label, in the order of the file; small marks where a step is not its shortest.
std::vector<Series> series_of(const std::vector<Marks>& list, Legend& legend) {
  std::map<std::string, double> shortest;
  for (const Marks& marks : list) {
    double& dt = shortest.emplace(line_label(marks.run), value_of(marks.run.dt)).first->second;
    dt = std::min(dt, value_of(marks.run.dt));
  }
  std::vector<Series> series;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Run& run = list[i].run;
    const std::string label = line_label(run);
    const bool short_step = run.dt <= shortest.at(label);
    const std::string style = mark_style(run, short_step ? 1.3 : 0.8), marks = fmt::format("marks_{}", i);
    Series& own = found_or_added(series, [&](const Series& one) { return one.words == label; },
                                 {label, style_of(run).colour});
    own.plots.push_back(plot_of(marks, style));
    own.alone.push_back(own.plots.back());
    own.context.push_back(
        plot_of(marks, fmt::format("with points pt 7 ps 0.4*mark lc rgb '{}'", context_colour)));
    if (short_step) legend.emplace_back(style, label);
  }
  return series;
}

}  // namespace

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
    Sheet sheet = subject.sheet(fmt::format("Which pattern follows an impact of {} blocks", blocks),
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
    const auto settings = [words = settings_of(cells)](double, double) { return words; };
    add_multiples(sheet, panels, {}, settings, "height / width of the top block", "mass ratio");
    drawings[part] = sheet.finish();
  }
  return drawings;
}

Drawings law_engines(const FolderSubject& subject) {
  const LawResults results = read_law_results(subject.folder);
  const std::vector<Marks> list = marks_of(results.runs);
  const std::string title = "Velocities after an impact: engines beside both laws";
  if (list.empty()) return {{"", empty_sheet(title, "No engine run that came to its end.")}};
  const LawFrame frame = frame_of(list);
  Legend legend;
  const std::vector<Series> series = series_of(list, legend);
  const bool many = series.size() > most_series;
  if (many) legend.clear();
  legend.emplace_back(border_style, "as far from either law");
  Sheet sheet = subject.sheet(title, legend, answer(results));
  std::ptrdiff_t beyond = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Numbers marks = mapped(list[i].at, [&](const auto& mark) { return frame.inside(mark); });
    sheet.data(number_block(fmt::format("marks_{}", i), marks));
    beyond += std::ranges::count_if(list[i].at, [&](const auto& mark) { return frame.inside(mark) != mark; });
  }
  const auto axes = [&](double width, double height) {
    return "set samples 200\n" + logarithmic_axes(frame.across, frame.up)(width, height);
  };
  const char* across = many ? "from law paper" : "from law paper, over the largest rate before";
  SeriesPanel panel{across, "from law consistent", "from consistent", true, axes, subject.height(640), 0};
  panel.under = {fmt::format("x {} notitle", border_style)};
  add_series(sheet, panel, series, many);
  if (many) sheet.note("distances of velocities, over the largest rate before the impact");
  sheet.note("small marks: longer steps");
  if (beyond > 0) sheet.note(fmt::format("marks on the edge: {} that lie beyond it", beyond));
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
