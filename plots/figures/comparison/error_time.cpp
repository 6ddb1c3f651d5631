#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "comparisons/measures/results/csv.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

/// One run as a point: wall time a second of motion, its error in rad, and what it is labelled with.
struct Cost {
  double time, error;
  std::string label;
  double lower, upper;  ///< quartiles over draws; the error itself where there are none
};

constexpr double panel_across = 1056, panel_up = 520;  ///< pixels

struct CostLine {
  Run run;                  ///< any of the line
  std::string label, unit;  ///< " iterations" where these vary
  const Fit* fit;           ///< of the errors over time steps; null where there is none
  std::vector<Cost> costs;
};

std::string words_of(const Run& run, const StepLine& line) {
  return varies_iterations(line) ? std::to_string(iterations_of(run)) : duration_text(run.dt);
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
      const double error = run.rms_angle_difference;
      const auto shown = [](double value) { return std::max(value, least_error); };
      const Cost cost{run.stepping_time / (run.steps * run.dt), shown(error), words_of(run, runs),
                      shown(quartile_or(run.rms_angle_difference_lower, error)),
                      shown(quartile_or(run.rms_angle_difference_upper, error))};
      if (std::isfinite(cost.time) && cost.time > 0 && error > 0 && std::isfinite(error))
        line.costs.push_back(cost);
    }
    if (!line.costs.empty()) lines.push_back(line);
  }
  return lines;
}

/// Wall time a second of motion of the exact solver, 0 where it is not known.
double exact_cost(const std::vector<Run>& exact) {
  if (exact.empty() || !(exact.front().stepping_time > 0)) return 0;
  const auto times = read_columns(exact.front().folder / "history.csv", {"time"});
  const double end = times[0].empty() ? 0 : times[0].back();
  return end > 0 ? exact.front().stepping_time / end : 0;
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
  return lines.front().run.steps * lines.front().run.dt;
}

/// The panel's edges, and where its points lie in pixels from its lower left corner.
struct Frame {
  double fast = 1e300, slow = 0, small = 1e300, large = 0;

  void add(double time) { fast = std::min(fast, time), slow = std::max(slow, time); }
  std::string ranges(double across_pixels, double up_pixels) const {
    return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", plain(fast), plain(slow), plain(small),
                       plain(large)) +
           logarithmic_tics("x", fast, slow, across_pixels) + logarithmic_tics("y", small, large, up_pixels);
  }
  double across(double time) const { return panel_across * std::log(time / fast) / std::log(slow / fast); }
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

/// A rectangle in pixels that is taken by a mark or a word.
struct Box {
  double left, right, low, high;

  bool meets(const Box& other) const {
    return left < other.right && other.left < right && low < other.high && other.low < high;
  }
};

bool is_free(const std::vector<Box>& taken, const Box& box) {
  return box.left > 0 && box.right < panel_across && box.low > 0 && box.high < panel_up &&
         std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return box.meets(other); });
}

/// What lines pass through, as boxes beside each other.
std::vector<Box> line_boxes(const std::vector<CostLine>& lines, const Frame& frame) {
  constexpr double step = 4, half = 2;
  std::vector<Box> boxes;
  for (const CostLine& line : lines)
    for (std::size_t i = 1; i < line.costs.size(); ++i) {
      const double x = frame.across(line.costs[i - 1].time), y = frame.up(line.costs[i - 1].error);
      const double across = frame.across(line.costs[i].time) - x, up = frame.up(line.costs[i].error) - y;
      const int parts = 1 + static_cast<int>(std::hypot(across, up) / step);
      for (int part = 0; part <= parts; ++part) {
        const double at_x = x + across * part / parts, at_y = y + up * part / parts;
        boxes.push_back({at_x - half, at_x + half, at_y - half, at_y + half});
      }
    }
  return boxes;
}

/// Where a label stands: their box, and on which side of the mark.
struct Place {
  Box box;
  double side;
};

/// The first of four corners of a mark that is free of all boxes.
std::optional<Place> free_corner(const Frame& frame, const Cost& cost, const std::vector<Box>& taken,
                                 const std::vector<Box>& lines) {
  const double width = 9.5 * static_cast<double>(cost.label.size()) + 4;
  const double x = frame.across(cost.time), y = frame.up(cost.error);
  constexpr double gap = 11, half_height = 8, rise = 12;
  for (const double side : {1.0, -1.0})
    for (const double lift : {rise, -rise}) {
      const double near = x + side * gap, far = near + side * width;
      const Box box{std::min(near, far), std::max(near, far), y + lift - half_height, y + lift + half_height};
      if (is_free(taken, box) &&
          std::none_of(lines.begin(), lines.end(), [&](const Box& other) { return box.meets(other); }))
        return Place{box, side};
    }
  return std::nullopt;
}

std::string label(const Cost& cost, const Place& place, const std::string& colour) {
  const bool right = place.side > 0;
  return fmt::format("set label '{}' at graph {}, graph {} {} font ',11' textcolor rgb '{}' front\n",
                     cost.label, plain((right ? place.box.left : place.box.right) / panel_across),
                     plain((place.box.low + place.box.high) / 2 / panel_up), right ? "left" : "right",
                     colour);
}

/// The time steps beside their marks, clear of lines where there is room, and left out where labels or marks
/// are in the way: the other runs with that step lie beside it.
std::string labels(const std::vector<CostLine>& lines, const Frame& frame) {
  std::vector<Box> taken;
  constexpr double half_mark = 7;
  for (const CostLine& line : lines)
    for (const Cost& cost : line.costs) {
      const double x = frame.across(cost.time), y = frame.up(cost.error);
      taken.push_back({x - half_mark, x + half_mark, y - half_mark, y + half_mark});
    }
  const std::vector<Box> crossed = line_boxes(lines, frame);
  std::string text;
  for (const CostLine& line : lines)
    for (const Cost& cost : line.costs) {
      std::optional<Place> place = free_corner(frame, cost, taken, crossed);
      if (!place) place = free_corner(frame, cost, taken, {});
      if (!place) continue;
      taken.push_back(place->box);
      text += label(cost, *place, style_of(line.run).colour);
    }
  return text;
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

/// A panel a solver, with all of its sets over those of the others.
void add_small_panels(Sheet& sheet, const std::vector<CostLine>& lines, const std::string& settings) {
  std::vector<Multiple> solvers;
  std::vector<std::string> context;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string name = solver_name(lines[i].run);
    context.push_back(fmt::format("$line_{} using 1:2 with points pt 7 ps 0.6*mark lc rgb '{}' notitle", i,
                                  context_colour));
    auto found =
        std::find_if(solvers.begin(), solvers.end(), [&](const Multiple& one) { return one.words == name; });
    if (found == solvers.end())
      found = solvers.insert(solvers.end(), {name, style_of(lines[i].run).colour, {}});
    for (const std::string& plot : plots_of(lines, i, 1.1)) found->plots.push_back(plot);
  }
  add_multiples(sheet, solvers, context, settings, "stepping time a second (s)", "RMS (rad)");
}

/// The cheapest run within the tolerance, or the nearest.
std::string question(const std::vector<CostLine>& lines, double tolerance) {
  const Cost* best = nullptr;
  const CostLine* of = nullptr;
  for (const CostLine& line : lines)
    for (const Cost& cost : line.costs) {
      const bool within = cost.error <= tolerance;
      const bool held = best != nullptr && best->error <= tolerance;
      const bool better = best == nullptr || (within && !held) ||
                          (within == held && (within ? cost.time < best->time : cost.error < best->error));
      if (better) best = &cost, of = &line;
    }
  return fmt::format("What does accuracy cost? {}: {} ({}{}), {}, {} a second of motion",
                     best->error <= tolerance ? fmt::format("Cheapest within {:g} rad", tolerance)
                                              : fmt::format("None within {:g} rad; nearest", tolerance),
                     of->label, best->label, of->unit, off_by(best->error), rounded_duration(best->time));
}

/// The model errors that no step takes away, as plots.
std::vector<std::string> floors(const std::vector<CostLine>& lines) {
  std::vector<std::string> plots;
  for (const CostLine& line : lines)
    if (line.fit != nullptr && line.fit->holds && line.fit->model_error > 0)
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

Drawing error_time(const Comparison& comparison, const ComparedScene& scene) {
  const std::vector<CostLine> lines = cost_lines(comparison, scene.name);
  if (lines.empty())
    return empty_sheet(heading(scene), "No engine run of this scene with both an error and a time.");
  const double exact = exact_cost(shown_runs(comparison, scene.name).exact);
  const Frame frame = frame_of(lines, exact);
  const bool many = lines.size() > most_series, comparable = are_comparable(scene, end_of(lines));
  Legend legend;
  if (!many)
    for (const CostLine& line : lines) legend.emplace_back(mark_style(line.run, 1.7), line.label);
  Sheet sheet(heading(scene), legend, question(lines, comparison.tolerance));
  std::vector<std::string> plots = floors(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    sheet.data(line_data(i, lines[i]) + pieces(i, lines[i], comparable));
    for (const std::string& plot : plots_of(lines, i, 1.7)) plots.push_back(plot);
  }
  const std::string guides = slope_guides(lines, frame, !many);
  const std::string settings =
      "set logscale xy\n" + std::string(grid_lines) +
      frame.ranges(many ? multiple_width : panel_across, many ? multiple_height : panel_up) + guides +
      exact_line(exact, !many);
  if (many)
    add_small_panels(sheet, lines, settings);
  else
    sheet.panel(panel_up, 0,
                settings +
                    "set xlabel 'stepping time for one second of motion (s)'\n"
                    "set ylabel 'RMS angle difference (rad)' offset 0\n" +
                    labels(lines, frame),
                plots);
  if (const std::string note = draws_note(comparison, scene.name); !note.empty()) sheet.note(note, "#000000");
  add_notes(sheet, lines, !guides.empty(), many);
  return sheet.finish();
}

}  // namespace rockstack::plots
