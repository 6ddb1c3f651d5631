#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

constexpr double tall = 460;  // pixels
constexpr auto other_style = "with points lw 2 pt 2 ps 1.1*mark lc rgb '#808080'";
constexpr auto ring = "with points pt 6 lw 2.5 lc rgb '#000000'";
constexpr auto limit_style = "with lines lw 2 dt (8,6) lc rgb '#404040'";

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
    const Run run{trial.get<RunMetrics>()};
    const double off =
        std::max(value_of(run.largest_angle_difference), run.relative_position_difference.value_or(0));
    const double time = value_of(run.stepping_time_minimum);
    if (!run.done() || !(time > 0) || !(off >= 0)) continue;
    const bool picked = !pick.is_null() && pick.at("run") == trial.at("run");
    const auto is_own = [&](const auto& line) { return line.front().run.solver_name() == run.solver_name(); };
    found_or_added(lines, is_own, {})
        .push_back({run, time, std::max(off, least_error), trial.at("passes").get<bool>(), picked});
  }
  return lines;
}

double nearest(const std::vector<TrialMark>& line) {
  return std::ranges::min(line, {}, &TrialMark::error).error;
}

/// The solvers that are told apart: those that hold at some step, or where none does, those that come nearest
/// up to a factor of two. All others are drawn alike.
std::vector<bool> told_of(const TrialLines& lines) {
  const auto holds = [](const auto& line) { return std::ranges::any_of(line, &TrialMark::passes); };
  const bool any = std::ranges::any_of(lines, holds);
  const double least = nearest(std::ranges::min(lines, {}, nearest));
  return mapped(lines, [&](const std::vector<TrialMark>& line) {
    return any ? holds(line) : nearest(line) <= 2 * least;
  });
}

std::string answer_of(const TrialLines& lines, double error) {
  for (const auto& line : lines)
    for (const TrialMark& mark : line)
      if (mark.picked)
        return fmt::format("{} at {}, within {:g}", mark.run.solver_name(),
                           duration_text(value_of(mark.run.dt)), error);
  return fmt::format("None that was tried holds to {:g}", error);
}

}  // namespace

Drawings advice(const FolderSubject& subject) {
  const Json json = read_json(subject.folder / "advice.json");
  const TrialLines lines = lines_of(json);
  const std::string title = json.at("title");
  if (lines.empty()) return {{"", empty_sheet(title, "No trial was done.")}};
  const double error = json.at("error");
  Extent across, up{error, error};
  for (const auto& line : lines)
    for (const TrialMark& mark : line) across.add(mark.time), up.add(mark.error);
  across = across.wider_times(2), up = up.wider_times(2);
  Legend legend;
  const std::vector<bool> told = told_of(lines);
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (told[i])
      legend.emplace_back(mark_style(lines[i].front().run, 1.5), lines[i].front().run.solver_name());
  if (std::ranges::find(told, false) != told.end()) legend.emplace_back(other_style, "other solvers");
  legend.emplace_back(limit_style, fmt::format("asked for: {:g}", error));
  legend.emplace_back(fmt::format("{} ps 2.6*mark", ring), "nine of ten replicates are within");
  Sheet sheet = subject.sheet(title, legend, answer_of(lines, error));
  const double width = sheet.panel_width();
  LabelledPanel labelled{width, tall, {}};
  Plots trials(sheet, "trials");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& line = lines[i];
    const Run& run = line.front().run;
    const std::string colour = told[i] ? style_of(run).colour : "#808080";
    labelled.lines.push_back(mapped(line, [&](const TrialMark& mark) {
      return LabelledMark{across.place(mark.time, width), up.place(mark.error, tall),
                          duration_text(value_of(mark.run.dt)), colour};
    }));
    trials.add(mapped(line,
                      [](const TrialMark& mark) {
                        return std::vector{mark.time, mark.error};
                      }),
               {fmt::format("using 1:2 with lines lw 1.5 lc rgb '{}'", paler(colour, 0.6)),
                "using 1:2 " + (told[i] ? mark_style(run, 1.5) : other_style)});
  }
  for (const auto& [is_ringed, size] : {std::pair{&TrialMark::passes, 2.6}, {&TrialMark::picked, 3.6}}) {
    Numbers rings;
    for (const auto& line : lines)
      for (const TrialMark& mark : line)
        if (mark.*is_ringed) rings.push_back({mark.time, mark.error});
    if (!rings.empty()) trials.add(rings, {fmt::format("using 1:2 {} ps {}*mark", ring, size)});
  }
  std::vector<std::string> plots = trials.list();
  plots.insert(plots.begin(), fmt::format("{} {} notitle", plain(error), limit_style));
  sheet.panel(tall, 0,
              logarithmic_axes(across, up)(width, tall) +
                  "set logscale xy\nset xlabel 'computing time of stepping (s)'\n"
                  "set ylabel 'largest difference (rad, least heights)'\n" +
                  placed_labels(labelled),
              plots);
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
