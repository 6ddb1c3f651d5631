#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "comparisons/measures/statistics/samples.hpp"
#include "plots/data/law_results.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// The runs of one solver with one step length: one mark in the figure.
struct Marks {
  Run run;
  std::vector<std::pair<double, double>> at;  ///< from law paper, from law consistent
};

bool visible(const LawRun& one) {
  return one.from_paper > 0 && one.from_consistent > 0;
}

std::vector<Marks> marks_of(const std::vector<LawRun>& runs) {
  std::vector<Marks> list;
  for (const LawRun& one : runs) {
    if (!visible(one)) continue;
    const std::string label = run_label(one.run);
    auto found =
        std::find_if(list.begin(), list.end(), [&](const Marks& m) { return run_label(m.run) == label; });
    if (found == list.end()) found = list.insert(list.end(), {one.run, {}});
    found->at.emplace_back(one.from_paper, one.from_consistent);
  }
  return list;
}

/// The shortest step of each solver has large marks.
std::map<std::string, double> shortest_steps(const std::vector<Marks>& list) {
  std::map<std::string, double> steps;
  for (const Marks& marks : list) {
    const auto [at, added] = steps.emplace(line_label(marks.run), value_of(marks.run.dt));
    if (!added) at->second = std::min(at->second, value_of(marks.run.dt));
  }
  return steps;
}

struct Reach {
  double low, high;
};

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
  const auto outside = [](const Reach& extent, double value) {
    return value < extent.low || value > extent.high;
  };
  for (std::size_t i = 0; i < across.size(); ++i)
    frame.beyond += outside(frame.across, across[i]) || outside(frame.up, up[i]) ? 1 : 0;
  return frame;
}

std::string data_of(const Marks& marks, std::size_t index, const LawFrame& frame) {
  std::string text = fmt::format("$marks_{} << END\n", index);
  for (const auto& [paper, consistent] : marks.at)
    text += fmt::format("{} {}\n", plain(std::clamp(paper, frame.across.low, frame.across.high)),
                        plain(std::clamp(consistent, frame.up.low, frame.up.high)));
  return text + "END\n";
}

std::string settings_of(const LawFrame& frame, double across, double up) {
  return "set logscale xy\nset samples 200\n" + std::string(grid_lines) +
         fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", plain(frame.across.low),
                     plain(frame.across.high), plain(frame.up.low), plain(frame.up.high)) +
         logarithmic_tics("x", frame.across.low, frame.across.high, across) +
         logarithmic_tics("y", frame.up.low, frame.up.high, up);
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

/// The series of all solvers in one panel, small marks where the step is not their shortest.
struct LawPlots {
  std::vector<Multiple> solvers;     ///< by their labels, in the order of the file
  std::vector<std::string> context;  ///< all marks in grey
  Legend legend;
};

LawPlots plots_of(const std::vector<Marks>& list) {
  const auto shortest = shortest_steps(list);
  LawPlots plots;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Run& run = list[i].run;
    const std::string label = line_label(run);
    const bool short_step = run.dt <= shortest.at(label);
    const std::string style = mark_style(run, short_step ? 1.3 : 0.8), marks = fmt::format("$marks_{}", i);
    auto found = std::find_if(plots.solvers.begin(), plots.solvers.end(),
                              [&](const Multiple& one) { return one.words == label; });
    if (found == plots.solvers.end())
      found = plots.solvers.insert(plots.solvers.end(), {label, style_of(run).colour, {}});
    found->plots.push_back(fmt::format("{} using 1:2 {} notitle", marks, style));
    plots.context.push_back(
        fmt::format("{} using 1:2 with points pt 7 ps 0.4*mark lc rgb '{}' notitle", marks, context_colour));
    if (short_step) plots.legend.emplace_back(style, label);
  }
  return plots;
}

}  // namespace

/// Every engine run by the distances of its velocities from law paper's and from law consistent's.
Drawings law_engines(const FolderSubject& subject) {
  const LawResults results = read_law_results(subject.folder);
  const std::vector<Marks> list = marks_of(results.runs);
  const std::string title = "Velocities after an impact: engines beside both laws";
  if (list.empty()) return {{"", empty_sheet(title, "No engine run that came to its end.")}};
  const LawFrame frame = frame_of(list);
  LawPlots plots = plots_of(list);
  const bool many = plots.solvers.size() > most_series;
  if (many) plots.legend.clear();
  plots.legend.emplace_back(border_style, "as far from either law");
  Sheet sheet = subject.sheet(title, plots.legend, answer(results));
  for (std::size_t i = 0; i < list.size(); ++i) sheet.data(data_of(list[i], i, frame));
  const std::string border = fmt::format("x {} notitle", border_style);
  if (many) {
    plots.context.push_back(border);
    add_multiples(sheet, plots.solvers, plots.context, settings_of(frame, multiple_width, multiple_height),
                  "from law paper", "from consistent");
    sheet.note("distances of velocities, over the largest rate before the impact", "#000000");
  } else {
    constexpr double width = 1056, height = 640;
    std::vector<std::string> elements{border};
    for (const Multiple& solver : plots.solvers)
      elements.insert(elements.end(), solver.plots.begin(), solver.plots.end());
    sheet.panel(
        height, 0,
        "set xlabel 'from law paper, over the largest rate before'\nset ylabel 'from law consistent'\n" +
            settings_of(frame, width, height),
        elements);
  }
  sheet.note("small marks: longer steps", "#000000");
  if (frame.beyond > 0)
    sheet.note(fmt::format("marks on the edge: {} that lie beyond it", frame.beyond), "#000000");
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
