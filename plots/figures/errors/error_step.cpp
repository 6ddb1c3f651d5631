#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// What a figure shows on its vertical axis.
struct Errors {
  std::string column, axis, short_axis, unit;
  std::optional<double> RunMetrics::*of;
  std::optional<double> RunMetrics::*lower = nullptr;  ///< quartiles over replicates, where there are some
  std::optional<double> RunMetrics::*upper = nullptr;
};

struct ErrorLine {
  Run run;  ///< any of the line
  std::string label;
  /// By ascending time step: this, the error, and its quartiles over replicates or the error again.
  Numbers errors;
  const StepFit* fit = nullptr;  ///< null where there is none

  bool fits() const { return fit != nullptr && fit->holds(); }
};

std::string fit_label(const StepFit& fit) {
  if (!fit.holds()) return "no fit, " + fit.reason;
  const auto& [value, low, high] = fit.model_error;
  const std::string model_error =
      low > 0 ? fmt::format("{:.2g} ({:.2g}–{:.2g})", value, low, high) : fmt::format("≤ {:.2g}", high);
  return fmt::format("p {:.2f} ({:.2f}–{:.2f}), model error {}", fit.order.value, fit.order.low,
                     fit.order.high, model_error);
}

std::vector<ErrorLine> error_lines(const Comparison& comparison, const std::string& scene,
                                   const Errors& errors) {
  std::vector<ErrorLine> lines;
  for (const StepLine& runs : step_lines(comparison, scene)) {
    ErrorLine line{runs.front(), line_label(runs), {}, fit_of(comparison, runs, errors.column)};
    for (const Run& run : runs) {
      const double error = std::abs(value_of(run.*errors.of));
      if (!(error > 0) || !std::isfinite(error)) continue;
      // An engine may have no error at all in a replicate, which no logarithm shows.
      const auto shown = [&](std::optional<double> RunMetrics::*of) {
        return std::max(of == nullptr ? error : (run.*of).value_or(error), least_error);
      };
      line.errors.push_back({value_of(run.dt), shown(nullptr), shown(errors.lower), shown(errors.upper)});
    }
    if (!line.errors.empty()) lines.push_back(line);
  }
  return lines;
}

Curve fitted_curve(const ErrorLine& line) {
  constexpr int points = 60;
  const double first = line.errors.front()[0], last = line.errors.back()[0];
  Curve curve;
  for (int i = 0; i <= points; ++i) {
    const double dt = first * std::pow(last / first, static_cast<double>(i) / points);
    curve.add(dt, line.fit->model_error.value + line.fit->coefficient * std::pow(dt, line.fit->order.value));
  }
  return curve;
}

std::function<std::string(double, double)> axes_of(const std::vector<ErrorLine>& lines) {
  Extent across, up;
  for (const ErrorLine& line : lines)
    for (const std::vector<double>& error : line.errors) {
      across.add(error[0]);
      up.add(error[2]), up.add(error[3]);
    }
  return logarithmic_axes(across.wider_times(1.6), up.wider_times(1.6));
}

std::string answer(const std::vector<ErrorLine>& lines, const Errors& errors) {
  std::vector<double> least{0, 1e300};
  for (const ErrorLine& line : lines)
    for (const std::vector<double>& error : line.errors)
      if (error[1] < least[1]) least = error;
  return fmt::format("At least {:.2g} {}, at {}", least[1], errors.unit, duration_text(least[0]));
}

/// Marks, quartiles and fitted curve of a series, with the model error that no step takes away.
std::vector<std::string> plots_of(const ErrorLine& line, std::size_t i, double size) {
  const Style style = style_of(line.run);
  std::vector<std::string> plots;
  if (line.fits()) {
    plots.push_back(plot_of(fmt::format("fitted_{}", i),
                            fmt::format("with lines lw 2 lc rgb '{}' dt {}", style.colour, style.dash)));
    if (line.fit->model_error.value > 0) plots.push_back(floor_plot(*line.fit, style.colour));
  }
  plots.push_back(fmt::format("$errors_{} using 1:2:3:4 with yerrorbars lw 1.5 lc rgb '{}' pt 0 notitle", i,
                              style.colour));
  plots.push_back(plot_of(fmt::format("errors_{}", i), mark_style(line.run, size)));
  return plots;
}

Drawing draw_errors(const SceneSubject& subject, const Errors& errors) {
  const std::vector<ErrorLine> lines = error_lines(subject.comparison, subject.scene.name, errors);
  if (lines.empty()) return subject.nothing("No engine run of this scene with an error.");
  const bool many = lines.size() > most_series;
  Legend legend;
  for (const ErrorLine& line : lines)
    if (!many) legend.emplace_back(mark_style(line.run, 1.5), line.label);
  Sheet sheet = subject.sheet(legend, answer(lines, errors));
  std::vector<Series> series;
  Numbers all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const ErrorLine& line = lines[i];
    series.push_back({line.label, style_of(line.run).colour, plots_of(line, i, 1.5), plots_of(line, i, 1.1)});
    std::ranges::copy(line.errors, std::back_inserter(all));
    sheet.data(number_block(fmt::format("errors_{}", i), line.errors));
    if (line.fits()) sheet.data(data_block(fmt::format("fitted_{}", i), fitted_curve(line)));
  }
  SeriesPanel panel{
      "time step (s)", errors.axis, errors.short_axis, true, axes_of(lines), subject.height(560, 560), 0};
  if (many) panel.under = {context_marks(sheet, all)};
  add_series(sheet, panel, series, many);
  for (const ErrorLine& line : lines)
    if (line.fit != nullptr) sheet.note(line.label + ": " + fit_label(*line.fit), style_of(line.run).colour);
  sheet.note(draws_note(subject.comparison, subject.scene.name));
  sheet.note(marks_note(mapped(lines, &ErrorLine::run)));
  return sheet.finish();
}

}  // namespace

Drawing error_step(const SceneSubject& subject) {
  return draw_errors(subject, {"rms_angle_difference", "RMS angle difference (rad)", "RMS (rad)", "rad",
                               &RunMetrics::rms_angle_difference, &RunMetrics::rms_angle_difference_lower,
                               &RunMetrics::rms_angle_difference_upper});
}

Drawing first_impact_step(const SceneSubject& subject) {
  return draw_errors(subject, {"first_impact_time_difference", "|engine − exact| of the first impact (s)",
                               "off by (s)", "s", &RunMetrics::first_impact_time_difference});
}

}  // namespace rockstack::plots
