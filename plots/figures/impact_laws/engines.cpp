#include <fmt/core.h>

#include <algorithm>
#include <limits>
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

/// The shortest step of each solver is filled.
std::map<std::string, double> shortest_steps(const std::vector<Marks>& list) {
  std::map<std::string, double> steps;
  for (const Marks& marks : list) {
    const auto [at, added] = steps.emplace(line_label(marks.run), marks.run.dt);
    if (!added) at->second = std::min(at->second, marks.run.dt);
  }
  return steps;
}

std::string data_of(const Marks& marks, std::size_t index) {
  std::string text = fmt::format("$marks_{} << END\n", index);
  for (const auto& [paper, consistent] : marks.at)
    text += fmt::format("{} {}\n", plain(paper), plain(consistent));
  return text + "END\n";
}

std::string ranges(const std::vector<Marks>& list) {
  double least = std::numeric_limits<double>::infinity(), left = least, most = 0, right = 0;
  for (const Marks& marks : list)
    for (const auto& [paper, consistent] : marks.at) {
      left = std::min(left, paper), right = std::max(right, paper);
      least = std::min(least, consistent), most = std::max(most, consistent);
    }
  constexpr double room = 1.6;
  return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", plain(left / room), plain(right * room),
                     plain(least / room), plain(most * room)) +
         logarithmic_tics("x", left / room, right * room) + logarithmic_tics("y", least / room, most * room);
}

}  // namespace

Drawing law_engines(const LawResults& results) {
  const std::vector<Marks> list = marks_of(results.runs);
  const std::string title = "Velocities after an impact: engines beside both laws";
  if (list.empty()) return empty_sheet(title, "No engine run that came to its end.");
  std::vector<Run> runs;
  runs.reserve(list.size());
  for (const Marks& marks : list) runs.push_back(marks.run);
  const Styles styles = assign_styles(runs);
  const auto shortest = shortest_steps(list);
  Legend legend;
  std::vector<std::string> elements;
  std::string data;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Run& run = list[i].run;
    const bool filled = run.dt <= shortest.at(line_label(run));
    const std::string style = mark_style(styles.at(solver_name(run)), filled, 1.2);
    if (filled) legend.emplace_back(style, line_label(run));
    elements.push_back(fmt::format("$marks_{} using 1:2 {} notitle", i, style));
    data += data_of(list[i], i);
  }
  elements.emplace_back("x with lines lw 2 dt (8,8) lc rgb '#606060' notitle");
  legend.emplace_back("with lines lw 2 dt (8,8) lc rgb '#606060'", "as far from either law");
  Sheet sheet(title, legend);
  sheet.data(data);
  constexpr double height = 640;
  sheet.panel(height, 0,
              "set logscale xy\nset grid lt 1 dt solid lw 1 lc rgb '#E4E4E4'\n"
              "set samples 200\nset xlabel 'from law paper, over the largest rate before'\n"
              "set ylabel 'from law consistent'\n" +
                  ranges(list),
              elements);
  return sheet.finish();
}

}  // namespace rockstack::plots
