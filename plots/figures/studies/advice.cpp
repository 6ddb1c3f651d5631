#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "plots/data/results.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/series.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

constexpr double tall = 460;  // pixels
constexpr auto ring = "with points pt 6 lw 2.5 lc rgb '#000000'";

/// A run that was tried.
struct TrialMark {
  Run run;
  double time, error;
  bool passes, picked;
};

using TrialLines = std::vector<std::vector<TrialMark>>;  // one a solver, coarse to fine

TrialLines lines_of(const Json& advice) {
  TrialLines lines;
  const Json& pick = advice.at("pick");
  for (const Json& trial : advice.at("trials")) {
    Run run{metrics_list(Json::array({trial})).front()};
    const double off =
        std::max(value_of(run.largest_angle_difference), run.relative_position_difference.value_or(0));
    const double time = value_of(run.stepping_time_minimum);
    if (!run.done() || !(time > 0) || !(off >= 0)) continue;
    const bool picked = !pick.is_null() && pick.at("run") == trial.at("run");
    const auto own = std::find_if(lines.begin(), lines.end(), [&](const auto& line) {
      return solver_name(line.front().run) == solver_name(run);
    });
    TrialMark mark{std::move(run), time, std::max(off, least_error), trial.at("passes").get<bool>(), picked};
    if (own == lines.end()) {
      lines.push_back({std::move(mark)});
    } else {
      own->push_back(std::move(mark));
    }
  }
  return lines;
}

/// What the axes show, with room about it.
struct Span {
  double fast = 1e300, slow = 0, small, large;

  Span(const TrialLines& lines, double error) : small(error), large(error) {
    for (const auto& line : lines)
      for (const TrialMark& mark : line) {
        fast = std::min(fast, mark.time), slow = std::max(slow, mark.time);
        small = std::min(small, mark.error), large = std::max(large, mark.error);
      }
    fast /= 2, slow *= 2, small /= 2, large *= 2;
  }
  double across(double time) const { return panel_width * std::log(time / fast) / std::log(slow / fast); }
  double up(double error) const { return tall * std::log(error / small) / std::log(large / small); }
};

std::string block_of(const std::string& name, const std::vector<TrialMark>& marks) {
  std::string text = fmt::format("${} << EOD\n", name);
  for (const TrialMark& mark : marks) text += fmt::format("{} {}\n", plain(mark.time), plain(mark.error));
  return text + "EOD\n";
}

std::string answer_of(const TrialLines& lines, double error) {
  for (const auto& line : lines)
    for (const TrialMark& mark : line)
      if (mark.picked)
        return fmt::format("{} at {}, within {:g}", solver_name(mark.run),
                           duration_text(value_of(mark.run.dt)), error);
  return fmt::format("None that was tried holds to {:g}", error);
}

}  // namespace

Drawings advice(const FolderSubject& subject) {
  const Json json = read_json(subject.folder / "advice.json");
  const TrialLines lines = lines_of(json);
  const std::string title = json.at("title").get<std::string>();
  if (lines.empty()) return {{"", empty_sheet(title, "No trial was done.")}};
  const double error = json.at("error").get<double>();
  const Span span(lines, error);
  Legend legend;
  LabelledPanel labelled{panel_width, tall, {}};
  std::vector<TrialMark> passing, picked;
  std::vector<std::string> plots{
      fmt::format("{} with lines lw 2 dt (8,6) lc rgb '#404040' notitle", plain(error))};
  std::string data;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Run& run = lines[i].front().run;
    const Style style = style_of(run);
    labelled.lines.emplace_back();
    for (const TrialMark& mark : lines[i]) {
      labelled.lines.back().push_back(
          {span.across(mark.time), span.up(mark.error), duration_text(value_of(mark.run.dt)), style.colour});
      if (mark.passes) passing.push_back(mark);
      if (mark.picked) picked.push_back(mark);
    }
    data += block_of(fmt::format("solver_{}", i), lines[i]);
    plots.push_back(fmt::format("$solver_{} using 1:2 with lines lw 1.5 lc rgb '{}' notitle", i,
                                paler(style.colour, 0.6)));
    plots.push_back(fmt::format("$solver_{} using 1:2 {} notitle", i, mark_style(run, 1.5)));
    legend.emplace_back(mark_style(run, 1.5), solver_name(run));
  }
  for (const auto& [name, marks, size] : {std::tuple{"passing", &passing, 2.6}, {"picked", &picked, 3.6}}) {
    if (marks->empty()) continue;
    data += block_of(name, *marks);
    plots.push_back(fmt::format("${} using 1:2 {} ps {}*mark notitle", name, ring, size));
  }
  legend.emplace_back("with lines lw 2 dt (8,6) lc rgb '#404040'", fmt::format("asked for: {:g}", error));
  legend.emplace_back(fmt::format("{} ps 2.6*mark", ring), "nine of ten replicates are within");
  Sheet sheet = subject.sheet(title, legend, answer_of(lines, error));
  sheet.data(data);
  sheet.panel(tall, 0,
              logarithmic_range("x", span.fast, span.slow, panel_width) +
                  logarithmic_range("y", span.small, span.large, tall) + grid_lines +
                  "set logscale xy\nset xlabel 'computing time of stepping (s)'\n"
                  "set ylabel 'largest difference (rad, least heights)'\n" +
                  placed_labels(labelled),
              plots);
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
