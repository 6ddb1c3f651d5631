#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "plots/data/run_files.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/series.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// One run as a point: wall time a second of motion, its error in rad, and what it is labelled with.
struct Cost {
  double time, error;
  std::string label;
  double lower, upper;  ///< quartiles over draws; the error itself where there are none
};

constexpr double panel_up = 520;  ///< height of the one panel of few, pixels

struct CostLine {
  Run run;                  ///< any of the line
  std::string label, unit;  ///< " iterations" where these vary
  const StepFit* fit;       ///< of the errors over time steps; null where there is none
  std::vector<Cost> costs;
};

std::string words_of(const Run& run, const StepLine& line) {
  return varies_iterations(line) ? std::to_string(iterations_of(run)) : duration_text(value_of(run.dt));
}

std::vector<CostLine> cost_lines(const Comparison& comparison, const std::string& scene) {
  std::vector<CostLine> lines;
  for (const StepLine& runs : step_lines(comparison, scene)) {
    CostLine line{runs.front(),
                  line_label(runs),
                  varies_iterations(runs) ? " iterations" : "",
                  fit_of(comparison, runs, "rms_angle_difference"),
                  {}};
    for (const Run& run : runs) {
      const double error = value_of(run.rms_angle_difference);
      const auto shown = [](double value) { return std::max(value, least_error); };
      const Cost cost{value_of(run.stepping_time_minimum) / (value_of(run.steps) * value_of(run.dt)),
                      shown(error), words_of(run, runs),
                      shown(run.rms_angle_difference_lower.value_or(error)),
                      shown(run.rms_angle_difference_upper.value_or(error))};
      if (std::isfinite(cost.time) && cost.time > 0 && error > 0 && std::isfinite(error))
        line.costs.push_back(cost);
    }
    if (!line.costs.empty()) lines.push_back(line);
  }
  return lines;
}

/// Wall time a second of motion of the exact solver, 0 where it is not known.
double exact_cost(const std::vector<Run>& exact) {
  if (exact.empty() || !(exact.front().stepping_time_minimum > 0)) return 0;
  const auto history = history_of(exact.front());
  const double end = history->times.empty() ? 0 : history->times.back();
  return end > 0 ? *exact.front().stepping_time_minimum / end : 0;
}

std::string line_data(std::size_t index, const CostLine& line) {
  std::string text = fmt::format("$line_{} << EOD\n", index);
  for (const Cost& cost : line.costs)
    text += fmt::format("{} {} {} {}\n", plain(cost.time), plain(cost.error), plain(cost.lower),
                        plain(cost.upper));
  return text + "EOD\n";
}

/// Whether the errors of two neighbouring runs tell a trend: their quartiles over draws part, and without
/// draws histories can be compared to the end. Elsewhere a line between them would mean nothing.
bool parts(const Cost& a, const Cost& b, bool comparable) {
  const bool drawn = a.lower < a.upper || b.lower < b.upper;
  return drawn ? a.upper < b.lower || b.upper < a.lower : comparable;
}

/// The lines between neighbours that part, as pieces.
std::string pieces(std::size_t index, const CostLine& line, bool comparable) {
  std::string text = fmt::format("$pieces_{} << EOD\n", index);
  for (std::size_t i = 1; i < line.costs.size(); ++i)
    if (const Cost& a = line.costs[i - 1], &b = line.costs[i]; parts(a, b, comparable))
      text += fmt::format("{} {} {} {}\n", plain(a.time), plain(a.error), plain(b.time), plain(b.error));
  return text + "EOD\n";
}

/// Scenes are perturbed where histories part; elsewhere results may say until when they can be compared.
bool are_comparable(const ComparedScene& scene, double end) {
  return !scene.perturbed && (std::isnan(scene.predictable_time) || scene.predictable_time >= 0.99 * end);
}

/// The last time of the motion, s.
double end_of(const std::vector<CostLine>& lines) {
  return value_of(lines.front().run.steps) * value_of(lines.front().run.dt);
}

/// The panel's edges, and where its points lie in pixels from its lower left corner.
struct Frame {
  double fast = 1e300, slow = 0, small = 1e300, large = 0;

  void add(double time) { fast = std::min(fast, time), slow = std::max(slow, time); }
  std::string ranges(double width, double height) const {
    return logarithmic_range("x", fast, slow, width) + logarithmic_range("y", small, large, height) +
           grid_lines;
  }
  double across(double time) const { return panel_width * std::log(time / fast) / std::log(slow / fast); }
  double up(double error) const { return panel_up * std::log(error / small) / std::log(large / small); }
};

Frame frame_of(const std::vector<CostLine>& lines, double exact) {
  Frame frame;
  if (exact > 0) frame.add(exact);
  for (const CostLine& line : lines)
    for (const Cost& cost : line.costs) {
      frame.add(cost.time);
      frame.small = std::min(frame.small, cost.lower);
      frame.large = std::max(frame.large, cost.upper);
    }
  constexpr double room = 2;
  const double above = std::max(room, std::pow(frame.large / frame.small, 0.06));
  return {frame.fast / room, frame.slow * room, frame.small / above, frame.large * above};
}

/// The time steps beside their marks: where there is no room, the other runs with that step lie beside it.
std::string labels(const std::vector<CostLine>& lines, const Frame& frame) {
  LabelledPanel panel{panel_width, panel_up, {}};
  for (const CostLine& line : lines) {
    panel.lines.emplace_back();
    for (const Cost& cost : line.costs)
      panel.lines.back().push_back(
          {frame.across(cost.time), frame.up(cost.error), cost.label, style_of(line.run).colour});
  }
  return placed_labels(panel);
}

std::vector<std::string> plots_of(const std::vector<CostLine>& lines, std::size_t i, double size) {
  const Style style = style_of(lines[i].run);
  return {
      fmt::format("$pieces_{} using 1:2:($3-$1):($4-$2) with vectors nohead lw 2 lc rgb '{}' dt {} notitle",
                  i, style.colour, style.dash),
      fmt::format("$line_{} using 1:2:3:4 with yerrorbars lw 1.5 lc rgb '{}' pt 0 notitle", i, style.colour),
      fmt::format("$line_{} using 1:2 {} notitle", i, mark_style(lines[i].run, size))};
}

/// What a method of order one and of order two would gain by smaller steps, from the fastest run on; nothing
/// where no solver has more than one, or where errors differ too little for slopes to be told apart.
std::string slope_guides(const std::vector<CostLine>& lines, const Frame& frame, bool named) {
  constexpr double enough = 30;
  const bool single =
      std::none_of(lines.begin(), lines.end(), [](const CostLine& line) { return line.costs.size() > 1; });
  if (single || frame.large < enough * frame.small) return "";
  std::string text;
  for (const int order : {1, 2}) {
    const double from = frame.fast * std::pow(frame.slow / frame.fast, 0.04 + 0.05 * (order - 1));
    const double high = frame.large / 1.4;
    const double gain = std::min(std::pow(high / frame.small / 1.4, 1.0 / order), frame.slow / from / 2);
    const std::string to = plain(from * gain) + ", " + plain(high / std::pow(gain, order));
    text += fmt::format("set arrow from {}, {} to {} nohead lw 1.5 dt (2,5) lc rgb '#707070' back\n",
                        plain(from), plain(high), to);
    if (named)
      text += fmt::format("set label ' order {}' at {} left font ',11' tc rgb '#606060'\n", order, to);
  }
  return text;
}

/// A series a line; where they are many, one a solver with all of its sets.
std::vector<Series> series_of(const std::vector<CostLine>& lines, bool many) {
  std::vector<Series> list;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Series one = mark_series(lines[i].run, fmt::format("line_{}", i), 1.7);
    one.words = many ? solver_name(lines[i].run) : lines[i].label;
    one.plots = plots_of(lines, i, 1.7);
    one.alone = plots_of(lines, i, 1.1);
    const auto same = std::find_if(list.begin(), list.end(),
                                   [&](const Series& other) { return many && other.words == one.words; });
    if (same == list.end()) {
      list.push_back(std::move(one));
      continue;
    }
    same->alone.insert(same->alone.end(), one.alone.begin(), one.alone.end());
    same->context.insert(same->context.end(), one.context.begin(), one.context.end());
  }
  return list;
}

/// The cheapest run within the tolerance, where there is one.
std::string answer(const std::vector<CostLine>& lines, double tolerance) {
  const Cost* best = nullptr;
  const CostLine* of = nullptr;
  double least = 1e300;
  for (const CostLine& line : lines)
    for (const Cost& cost : line.costs) {
      least = std::min(least, cost.error);
      if (cost.error <= tolerance && (best == nullptr || cost.time < best->time)) best = &cost, of = &line;
    }
  if (best == nullptr) return fmt::format("None within {:g} rad, all {} or more", tolerance, off_by(least));
  return fmt::format("Cheapest within {:g} rad: {} ({}{}), {}, {} a second of motion", tolerance, of->label,
                     best->label, of->unit, off_by(best->error), rounded_duration(best->time));
}

/// The model errors that no step takes away, as plots.
std::vector<std::string> floors(const std::vector<CostLine>& lines) {
  std::vector<std::string> plots;
  for (const CostLine& line : lines)
    if (line.fit != nullptr && line.fit->holds() && line.fit->model_error.value > 0)
      plots.push_back(floor_plot(*line.fit, style_of(line.run).colour));
  return plots;
}

/// What the figure's lines, and in small panels its marks, stand for.
void add_notes(Sheet& sheet, const std::vector<CostLine>& lines, bool guided, bool many) {
  if (guided)
    sheet.note(
        "lines join runs whose errors tell a trend; dotted slopes: a method of order one, and of two; black: "
        "the exact solver",
        "#000000");
  const bool changed = std::any_of(lines.begin(), lines.end(), [](const CostLine& line) {
    return line.run.settings.find('+') != std::string::npos;
  });
  if (many && changed)
    sheet.note("stars and crosses: sets with a parameter changed, which the ranking names", "#000000");
}

std::string exact_line(double cost, bool named) {
  if (cost <= 0) return "";
  const std::string line = fmt::format(
      "set arrow from {0}, graph 0 to {0}, graph 1 nohead lw 3 lc rgb '#000000' back\n", plain(cost));
  return named ? line +
                     fmt::format("set label ' exact solver' at {}, graph 0.04 left font ',12'\n", plain(cost))
               : line;
}

}  // namespace

Drawing error_time(const SceneSubject& subject) {
  const Comparison& comparison = subject.comparison;
  const ComparedScene& scene = subject.scene;
  const std::vector<CostLine> lines = cost_lines(comparison, scene.name);
  if (lines.empty()) return subject.nothing("No engine run of this scene with both an error and a time.");
  const double exact = exact_cost(shown_runs(comparison, scene.name).exact);
  const Frame frame = frame_of(lines, exact);
  const bool many = lines.size() > most_series, comparable = are_comparable(scene, end_of(lines));
  Legend legend;
  if (!many)
    for (const CostLine& line : lines) legend.emplace_back(mark_style(line.run, 1.7), line.label);
  Sheet sheet = subject.sheet(legend, answer(lines, comparison.tolerance));
  for (std::size_t i = 0; i < lines.size(); ++i)
    sheet.data(line_data(i, lines[i]) + pieces(i, lines[i], comparable));
  const std::string guides = slope_guides(lines, frame, !many);
  SeriesPanel panel{"stepping time for one second of motion (s)",
                    "RMS angle difference (rad)",
                    "RMS (rad)",
                    true,
                    [&](double width, double height) { return frame.ranges(width, height); },
                    panel_up,
                    0};
  if (many) panel.across = "stepping time a second (s)";
  if (!many) panel.under = floors(lines);
  panel.few = guides + exact_line(exact, true) + labels(lines, frame);
  panel.many = guides + exact_line(exact, false);
  add_series(sheet, panel, series_of(lines, many), many);
  if (const std::string note = draws_note(comparison, scene.name); !note.empty()) sheet.note(note, "#000000");
  add_notes(sheet, lines, !guides.empty(), many);
  return sheet.finish();
}

}  // namespace rockstack::plots
