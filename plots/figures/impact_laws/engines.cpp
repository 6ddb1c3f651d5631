#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "plots/data/selection.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/impact_laws/engines.hpp"

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
    const auto [at, added] = steps.emplace(line_label(marks.run), marks.run.dt);
    if (!added) at->second = std::min(at->second, marks.run.dt);
  }
  return steps;
}

struct Reach {
  double low, high;
};

/// Where values lie but for those far away, which must not press the rest together: on a logarithmic axis all
/// within one and a half times the middle half's extent beyond it (Tukey 1977), with room.
Reach reach_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double lower = values[values.size() / 4], upper = values[3 * values.size() / 4];
  const double beyond = std::pow(upper / lower, 1.5);
  constexpr double room = 1.6;
  return {std::max(values.front(), lower / beyond) / room, std::min(values.back(), upper * beyond) * room};
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

std::string settings_of(const LawFrame& frame) {
  return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", plain(frame.across.low),
                     plain(frame.across.high), plain(frame.up.low), plain(frame.up.high)) +
         logarithmic_tics("x", frame.across.low, frame.across.high) +
         logarithmic_tics("y", frame.up.low, frame.up.high);
}

std::string question(const LawResults& results) {
  int consistent = 0, paper = 0, all = 0;
  for (const LawRun& run : results.runs) {
    all += run.follows.empty() ? 0 : 1;
    consistent += run.follows == "consistent" ? 1 : 0;
    paper += run.follows == "paper" ? 1 : 0;
  }
  return fmt::format("Whose side do engines take? Of {} runs {} end as law consistent says, {} as law paper",
                     all, consistent, paper);
}

}  // namespace

Drawing law_engines(const LawResults& results) {
  const std::vector<Marks> list = marks_of(results.runs);
  const std::string title = "Velocities after an impact: engines beside both laws";
  if (list.empty()) return empty_sheet(title, "No engine run that came to its end.");
  const LawFrame frame = frame_of(list);
  const auto shortest = shortest_steps(list);
  Legend legend;
  std::vector<std::string> elements;
  std::string data;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Run& run = list[i].run;
    const bool short_step = run.dt <= shortest.at(line_label(run));
    const std::string style = mark_style(run, short_step ? 1.3 : 0.8);
    if (short_step) legend.emplace_back(style, line_label(run));
    elements.push_back(fmt::format("$marks_{} using 1:2 {} notitle", i, style));
    data += data_of(list[i], i, frame);
  }
  elements.emplace_back("x with lines lw 2 dt (8,8) lc rgb '#606060' notitle");
  legend.emplace_back("with lines lw 2 dt (8,8) lc rgb '#606060'", "as far from either law");
  Sheet sheet(title, legend, question(results));
  sheet.data(data);
  constexpr double height = 640;
  sheet.panel(height, 0,
              "set logscale xy\n" + std::string(grid_lines) +
                  "set samples 200\nset xlabel 'from law paper, over the largest rate before'\n"
                  "set ylabel 'from law consistent'\n" +
                  settings_of(frame),
              elements);
  sheet.note("small marks: longer steps", "#000000");
  if (frame.beyond > 0)
    sheet.note(fmt::format("marks on the edge: {} that lie beyond it", frame.beyond), "#000000");
  return sheet.finish();
}

}  // namespace rockstack::plots
