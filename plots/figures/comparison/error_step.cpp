#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

/// What a figure shows on its vertical axis.
struct Errors {
  std::string column, axis, short_axis, question, unit;
  double (*of)(const Run&);
  double Run::*lower = nullptr;  ///< quartiles over draws, where the file has them
  double Run::*upper = nullptr;
};

/// The errors of one series, and their fit.
struct ErrorLine {
  Run run;  ///< any of the line
  std::string label;
  Curve errors;                      ///< by ascending time step
  std::vector<double> lower, upper;  ///< quartiles over draws; the error itself where there are none
  const Fit* fit = nullptr;          ///< null where there is none

  bool fits() const { return fit != nullptr && fit->holds; }
};

std::string fit_label(const Fit& fit) {
  if (!fit.holds) return "no fit, " + fit.reason;
  const std::string model_error =
      fit.model_error_low > 0
          ? fmt::format("{:.2g} ({:.2g}–{:.2g})", fit.model_error, fit.model_error_low, fit.model_error_high)
          : fmt::format("≤ {:.2g}", fit.model_error_high);
  return fmt::format("p {:.2f} ({:.2f}–{:.2f}), model error {}", fit.order, fit.order_low, fit.order_high,
                     model_error);
}

/// An engine may have no error at all in a draw, which no logarithm shows.
double drawable(double error) {
  return std::max(error, least_error);
}

std::vector<ErrorLine> error_lines(const Comparison& comparison, const std::string& scene,
                                   const Errors& errors) {
  std::vector<ErrorLine> lines;
  for (const StepLine& runs : step_lines(comparison, scene)) {
    ErrorLine line{runs.front(), line_label(runs), {}, {}, {}, fit_of(comparison, runs, errors.column)};
    for (const Run& run : runs) {
      const double error = errors.of(run);
      if (!(error > 0) || !std::isfinite(error)) continue;
      line.errors.times.push_back(run.dt);
      line.errors.values.push_back(drawable(error));
      const bool drawn = errors.lower != nullptr && !std::isnan(run.*errors.lower);
      line.lower.push_back(drawable(drawn ? run.*errors.lower : error));
      line.upper.push_back(drawable(drawn ? run.*errors.upper : error));
    }
    if (line.errors.size() > 0) lines.push_back(line);
  }
  return lines;
}

std::string errors_block(std::size_t index, const ErrorLine& line) {
  std::string text = fmt::format("$errors_{} << EOD\n", index);
  for (std::size_t i = 0; i < line.errors.size(); ++i)
    text += fmt::format("{} {} {} {}\n", plain(line.errors.times[i]), plain(line.errors.values[i]),
                        plain(line.lower[i]), plain(line.upper[i]));
  return text + "EOD\n";
}

/// The fitted curve between the smallest and the largest step.
Curve fitted(const ErrorLine& line) {
  constexpr int points = 60;
  const double first = line.errors.times.front(), last = line.errors.times.back();
  Curve curve;
  for (int i = 0; i <= points; ++i) {
    const double dt = first * std::pow(last / first, static_cast<double>(i) / points);
    curve.times.push_back(dt);
    curve.values.push_back(line.fit->model_error + line.fit->coefficient * std::pow(dt, line.fit->order));
  }
  return curve;
}

/// Half a decade of room around all marks.
std::string ranges(const std::vector<ErrorLine>& lines, double across, double up) {
  double shortest = 1e300, longest = 0, small = 1e300, large = 0;
  for (const ErrorLine& line : lines) {
    const auto low = std::min_element(line.lower.begin(), line.lower.end());
    const auto high = std::max_element(line.upper.begin(), line.upper.end());
    shortest = std::min(shortest, line.errors.times.front());
    longest = std::max(longest, line.errors.times.back());
    small = std::min(small, *low);
    large = std::max(large, *high);
  }
  constexpr double room = 1.6;
  return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", plain(shortest / room),
                     plain(longest * room), plain(small / room), plain(large * room)) +
         logarithmic_tics("x", shortest / room, longest * room, across) +
         logarithmic_tics("y", small / room, large * room, up);
}

/// The least error of all, with its step.
std::string question(const std::vector<ErrorLine>& lines, const Errors& errors) {
  const ErrorLine* best = &lines.front();
  double least = 1e300, dt = 0;
  for (const ErrorLine& line : lines)
    for (std::size_t i = 0; i < line.errors.size(); ++i)
      if (line.errors.values[i] < least)
        least = line.errors.values[i], dt = line.errors.times[i], best = &line;
  return fmt::format("{} Least: {:.2g} {}, {} at {}", errors.question, least, errors.unit, best->label,
                     duration_text(dt));
}

/// Marks, quartiles and fitted curve of a series, with the model error that no step takes away.
std::vector<std::string> plots_of(const ErrorLine& line, std::size_t i, double size) {
  const Style style = style_of(line.run);
  std::vector<std::string> plots;
  if (line.fits()) {
    plots.push_back(fmt::format("$fitted_{} using 1:2 with lines lw 2 lc rgb '{}' dt {} notitle", i,
                                style.colour, style.dash));
    if (line.fit->model_error > 0) plots.push_back(floor_plot(*line.fit, style.colour));
  }
  plots.push_back(fmt::format("$errors_{} using 1:2:3:4 with yerrorbars lw 1.5 lc rgb '{}' pt 0 notitle", i,
                              style.colour));
  plots.push_back(fmt::format("$errors_{} using 1:2 {} notitle", i, mark_style(line.run, size)));
  return plots;
}

constexpr auto across_axis = "time step (s)";

void add_panel(Sheet& sheet, const std::vector<ErrorLine>& lines, const Errors& errors) {
  constexpr double across = 1056, up = 560;
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (const std::string& plot : plots_of(lines[i], i, 1.5)) plots.push_back(plot);
  sheet.panel(
      up, 0,
      "set logscale xy\n" + std::string(grid_lines) +
          fmt::format("set xlabel '{}'\nset ylabel {} offset 0\n", across_axis, in_quotes(errors.axis)) +
          ranges(lines, across, up),
      plots);
}

void add_small_panels(Sheet& sheet, const std::vector<ErrorLine>& lines, const Errors& errors) {
  std::vector<Multiple> series;
  std::vector<std::string> context;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    context.push_back(fmt::format("$errors_{} using 1:2 with points pt 7 ps 0.6*mark lc rgb '{}' notitle", i,
                                  context_colour));
    series.push_back({lines[i].label, style_of(lines[i].run).colour, plots_of(lines[i], i, 1.1)});
  }
  add_multiples(
      sheet, series, context,
      "set logscale xy\n" + std::string(grid_lines) + ranges(lines, multiple_width, multiple_height),
      across_axis, errors.short_axis);
}

Drawing draw_errors(const Comparison& comparison, const ComparedScene& scene, const Errors& errors) {
  const std::vector<ErrorLine> lines = error_lines(comparison, scene.name, errors);
  if (lines.empty()) return empty_sheet(heading(scene), "No engine run of this scene with an error.");
  const bool many = lines.size() > most_series;
  Legend legend;
  if (!many)
    for (const ErrorLine& line : lines) legend.emplace_back(mark_style(line.run, 1.5), line.label);
  Sheet sheet(heading(scene), legend, question(lines, errors));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    sheet.data(errors_block(i, lines[i]));
    if (lines[i].fits()) sheet.data(data_block(fmt::format("fitted_{}", i), fitted(lines[i])));
  }
  if (many)
    add_small_panels(sheet, lines, errors);
  else
    add_panel(sheet, lines, errors);
  for (const ErrorLine& line : lines)
    if (line.fit != nullptr) sheet.note(line.label + ": " + fit_label(*line.fit), style_of(line.run).colour);
  if (const std::string note = draws_note(comparison, scene.name); !note.empty()) sheet.note(note, "#000000");
  return sheet.finish();
}

}  // namespace

Drawing error_step(const Comparison& comparison, const ComparedScene& scene) {
  return draw_errors(
      comparison, scene,
      {"rms_angle_difference", "RMS angle difference (rad)", "RMS (rad)", "What does a smaller step bring?",
       "rad", [](const Run& run) { return run.rms_angle_difference; }, &Run::rms_angle_difference_lower,
       &Run::rms_angle_difference_upper});
}

Drawing first_impact_step(const Comparison& comparison, const ComparedScene& scene) {
  return draw_errors(comparison, scene,
                     {"first_impact_time_difference", "|engine − exact| of the first impact (s)",
                      "off by (s)", "Does the first impact come in time?", "s",
                      [](const Run& run) { return std::abs(run.first_impact_time_difference); }});
}

}  // namespace rockstack::plots
