#include "plots/data/law_results.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

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

/// The shortest step of each solver has large marks.
std::map<std::string, double> shortest_steps(const std::vector<Marks>& list) {
  std::map<std::string, double> steps;
  for (const Marks& marks : list) {
    double& shortest = steps.emplace(line_label(marks.run), value_of(marks.run.dt)).first->second;
    shortest = std::min(shortest, value_of(marks.run.dt));
  }
  return steps;
}

/// Where values lie but for those far away, which must not press the rest together: on a logarithmic axis all
/// within one and a half times the middle half's extent beyond it (Tukey 1977), with room.
Reach reach_of(const std::vector<double>& values) {
  const double lower = quantile(values, 0.25), upper = quantile(values, 0.75);
  const double beyond = std::pow(upper / lower, 1.5);
  constexpr double room = 1.6;
  return {std::max(quantile(values, 0), lower / beyond) / room,
          std::min(quantile(values, 1), upper * beyond) * room};
}

struct LawFrame {
  Reach across, up;

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
  const auto shortest = shortest_steps(list);
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

/// Every engine run by the distances of its velocities from law paper's and from law consistent's.
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
  Sheet sheet = subject.figure.sheet(title, legend, answer(results));
  std::ptrdiff_t beyond = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Numbers marks = each_of(list[i].at, [&](const auto& mark) { return frame.inside(mark); });
    sheet.data(number_block(fmt::format("marks_{}", i), marks));
    beyond += std::ranges::count_if(list[i].at, [&](const auto& mark) { return frame.inside(mark) != mark; });
  }
  const auto axes = [&](double width, double height) {
    return "set samples 200\n" + logarithmic_axes(frame.across, frame.up, width, height);
  };
  const char* across = many ? "from law paper" : "from law paper, over the largest rate before";
  SeriesPanel panel{across, "from law consistent", "from consistent", true, axes, 640, 0};
  panel.under = {fmt::format("x {} notitle", border_style)};
  add_series(sheet, panel, series, many);
  if (many) sheet.note("distances of velocities, over the largest rate before the impact");
  sheet.note("small marks: longer steps");
  if (beyond > 0) sheet.note(fmt::format("marks on the edge: {} that lie beyond it", beyond));
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
