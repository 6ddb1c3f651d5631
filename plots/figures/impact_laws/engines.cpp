#include "plots/data/law_results.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// The runs of one solver with one step length: one mark in the figure.
struct Marks {
  Run run;
  std::vector<std::pair<double, double>> at;  ///< from law paper, from law consistent
};

std::vector<Marks> marks_of(const std::vector<LawRun>& runs) {
  std::vector<Marks> list;
  for (const LawRun& one : runs) {
    if (!(one.from_paper > 0 && one.from_consistent > 0)) continue;
    const std::string label = run_label(one.run);
    found_or_added(list, [&](const Marks& m) { return run_label(m.run) == label; }, {one.run, {}})
        .at.emplace_back(one.from_paper, one.from_consistent);
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
  int beyond = 0;  ///< marks outside of it, which are drawn on its edge
};

LawFrame frame_of(const std::vector<Marks>& list) {
  std::vector<double> across, up;
  for (const Marks& marks : list)
    for (const auto& [paper, consistent] : marks.at) across.push_back(paper), up.push_back(consistent);
  LawFrame frame{reach_of(across), reach_of(up), 0};
  const auto outside = [](const Reach& reach, double value) {
    return value < reach.low || value > reach.high;
  };
  for (std::size_t i = 0; i < across.size(); ++i)
    frame.beyond += outside(frame.across, across[i]) || outside(frame.up, up[i]) ? 1 : 0;
  return frame;
}

Numbers numbers_of(const Marks& marks, const LawFrame& frame) {
  Numbers numbers;
  for (const auto& [paper, consistent] : marks.at)
    numbers.push_back({std::clamp(paper, frame.across.low, frame.across.high),
                       std::clamp(consistent, frame.up.low, frame.up.high)});
  return numbers;
}

std::string answer(const LawResults& results) {
  int consistent = 0, paper = 0, all = 0;
  for (const LawRun& run : results.runs) {
    all += run.follows.empty() ? 0 : 1;
    consistent += run.follows == "consistent" ? 1 : 0;
    paper += run.follows == "paper" ? 1 : 0;
  }
  return fmt::format("Of {} runs {} end as law consistent says, {} as law paper", all, consistent, paper);
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
    const std::string style = mark_style(run, short_step ? 1.3 : 0.8), marks = fmt::format("$marks_{}", i);
    Series& own = found_or_added(series, [&](const Series& one) { return one.words == label; },
                                 {label, style_of(run).colour, {}, {}, {}});
    own.plots.push_back(fmt::format("{} using 1:2 {} notitle", marks, style));
    own.alone.push_back(own.plots.back());
    own.context.push_back(
        fmt::format("{} using 1:2 with points pt 7 ps 0.4*mark lc rgb '{}' notitle", marks, context_colour));
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
  for (std::size_t i = 0; i < list.size(); ++i)
    sheet.data(number_block(fmt::format("marks_{}", i), numbers_of(list[i], frame)));
  const auto axes = [&](double width, double height) {
    return "set samples 200\n" + logarithmic_axes(frame.across, frame.up, width, height);
  };
  SeriesPanel panel{many ? "from law paper" : "from law paper, over the largest rate before",
                    "from law consistent",
                    "from consistent",
                    true,
                    axes,
                    640,
                    0,
                    {fmt::format("x {} notitle", border_style)}};
  add_series(sheet, panel, series, many);
  if (many) sheet.note("distances of velocities, over the largest rate before the impact");
  sheet.note("small marks: longer steps");
  if (frame.beyond > 0) sheet.note(fmt::format("marks on the edge: {} that lie beyond it", frame.beyond));
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
