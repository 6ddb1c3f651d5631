#include "plots/data/run_files.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// One run as a point: wall time a second of motion, its error in rad, and what it is labelled with.
struct Cost {
  double time, error;
  std::string label = {};
  double lower = 0, upper = 0;  ///< quartiles over replicates; the error itself where there are none
};

struct CostLine {
  Run run;                  ///< any of the line
  std::string label, unit;  ///< " iterations" where these vary
  const StepFit* fit;       ///< of the errors over time steps; null where there is none
  std::vector<Cost> costs = {};
};

/// An error of runs, with its quartiles.
struct Measure {
  std::optional<double> RunMetrics::*value, RunMetrics::*lower, RunMetrics::*upper;
  const char *words, *short_words;  ///< of an axis
  const char* unit;
};
constexpr Measure of_angles{&RunMetrics::rms_angle_difference,
                            &RunMetrics::rms_angle_difference_lower,
                            &RunMetrics::rms_angle_difference_upper,
                            "RMS angle difference (rad)",
                            "RMS (rad)",
                            "rad"};
constexpr Measure of_both{&RunMetrics::error,       &RunMetrics::error_lower,
                          &RunMetrics::error_upper, "RMS error (rad; centres: over the least height)",
                          "RMS (rad; –)",           "(rad, or of the least block height)"};

/// Centres count as well where blocks fly in the exact motion, as angles do not tell where they are.
const Measure& measure_of(const SceneSubject& subject) {
  const std::vector<Run> exact = subject.shown({"history.csv"}).exact;
  if (exact.empty()) return of_angles;
  const auto flies = [](const Pattern& pattern) {
    return std::ranges::find(pattern.contacts, Contact::apart) != std::ranges::end(pattern.contacts);
  };
  return std::ranges::any_of(history_of(exact.front())->patterns, flies) ? of_both : of_angles;
}

std::vector<CostLine> cost_lines(const Comparison& comparison, const std::string& scene,
                                 const Measure& measure) {
  std::vector<CostLine> lines;
  for (const StepLine& runs : step_lines(comparison, scene)) {
    const bool varies = varies_iterations(runs);
    CostLine line{runs.front(), line_label(runs), varies ? " iterations" : "",
                  &measure == &of_angles ? fit_of(comparison, runs, "rms_angle_difference") : nullptr};
    for (const Run& run : runs) {
      const double error = value_of(run.*measure.value);
      const auto shown = [](double value) { return std::max(value, least_error); };
      const Cost cost{
          value_of(run.stepping_time_minimum) / (value_of(run.steps) * value_of(run.dt)), shown(error),
          varies ? std::to_string(iterations_of(run)) : duration_text(value_of(run.dt)),
          shown((run.*measure.lower).value_or(error)), shown((run.*measure.upper).value_or(error))};
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

Numbers numbers_of(const CostLine& line) {
  return mapped(line.costs, [](const Cost& cost) {
    return std::vector{cost.time, cost.error, cost.lower, cost.upper};
  });
}

/// The lines between steps whose quartiles of errors over replicates part; without replicates, where
/// histories can be compared to the end. Elsewhere a line between them would mean nothing.
Numbers pieces(const CostLine& line, bool comparable) {
  Numbers numbers;
  for (std::size_t i = 1; i < line.costs.size(); ++i) {
    const Cost &a = line.costs[i - 1], &b = line.costs[i];
    const bool spread = a.lower < a.upper || b.lower < b.upper;
    if (spread ? a.upper < b.lower || b.upper < a.lower : comparable)
      numbers.push_back({a.time, a.error, b.time, b.error});
  }
  return numbers;
}

/// Scenes are perturbed where histories part; elsewhere results may say until when they can be compared.
bool are_comparable(const ComparedScene& scene, const Run& run) {
  const double end = value_of(run.steps) * value_of(run.dt);
  return !scene.perturbed && (std::isnan(scene.predictable_time) || scene.predictable_time >= 0.99 * end);
}

struct Frame {
  Extent across, up;
};

Frame frame_of(const std::vector<CostLine>& lines, double exact) {
  Frame frame;
  if (exact > 0) frame.across.add(exact);
  for (const CostLine& line : lines)
    for (const Cost& cost : line.costs) {
      frame.across.add(cost.time);
      frame.up.add(cost.lower), frame.up.add(cost.upper);
    }
  constexpr double room = 2;
  const double above = std::max(room, std::pow(frame.up.high / frame.up.low, 0.06));
  return {frame.across.wider_times(room), frame.up.wider_times(above)};
}

/// What a method of an order would gain by smaller steps, from the fastest run on.
struct OrderGuide {
  std::string words;
  Cost from, to;
};

/// Guides of orders one and two; none where no solver has several runs, or errors differ too little to tell
/// them.
std::vector<OrderGuide> slopes_of(const std::vector<CostLine>& lines, const Frame& frame) {
  constexpr double enough = 30;
  const bool single = std::ranges::none_of(lines, [](const CostLine& line) { return line.costs.size() > 1; });
  const auto& [across, up] = frame;
  std::vector<OrderGuide> slopes;
  if (single || up.high < enough * up.low) return slopes;
  for (const int order : {1, 2}) {
    const double from = across.low * std::pow(across.high / across.low, 0.04 + 0.05 * (order - 1));
    const double high = up.high / 1.4;
    const double gain = std::min(std::pow(high / up.low / 1.4, 1.0 / order), across.high / from / 2);
    slopes.push_back(
        {fmt::format(" order {}", order), {from, high}, {from * gain, high / std::pow(gain, order)}});
  }
  return slopes;
}

std::string slope_guides(const std::vector<OrderGuide>& slopes, bool named) {
  std::string text;
  for (const OrderGuide& slope : slopes) {
    const std::string to = plain(slope.to.time) + ", " + plain(slope.to.error);
    text += fmt::format("set arrow from {}, {} to {} nohead lw 1.5 dt (2,5) lc rgb '#707070' back\n",
                        plain(slope.from.time), plain(slope.from.error), to);
    if (named)
      text += fmt::format("set label '{}' at {} left font ',11' tc rgb '#606060'\n", slope.words, to);
  }
  return text;
}

/// The time steps beside their marks: where there is no room, the other runs with that step lie beside it.
std::string labels(const std::vector<CostLine>& lines, const std::vector<OrderGuide>& slopes,
                   const Frame& frame, double width, double height) {
  const auto mark = [&](const Cost& cost, const std::string& words, const std::string& colour) {
    return LabelledMark{frame.across.place(cost.time, width), frame.up.place(cost.error, height), words,
                        colour};
  };
  LabelledPanel panel{width, height, {}};
  for (const OrderGuide& slope : slopes) panel.words.push_back(mark(slope.to, slope.words, ""));
  for (const CostLine& line : lines)
    panel.lines.push_back(mapped(
        line.costs, [&](const Cost& cost) { return mark(cost, cost.label, style_of(line.run).colour); }));
  return placed_labels(panel);
}

std::vector<std::string> plots_of(const std::vector<CostLine>& lines, std::size_t i, double size) {
  const Style style = style_of(lines[i].run);
  return {
      fmt::format("$pieces_{} using 1:2:($3-$1):($4-$2) with vectors nohead lw 2 lc rgb '{}' dt {} notitle",
                  i, style.colour, style.dash),
      fmt::format("$line_{} using 1:2:3:4 with yerrorbars lw 1.5 lc rgb '{}' pt 0 notitle", i, style.colour),
      plot_of(fmt::format("line_{}", i), mark_style(lines[i].run, size))};
}

/// A series a line; where they are many, one a solver with all of its sets.
std::vector<Series> series_of(const std::vector<CostLine>& lines, bool many) {
  std::vector<Series> list;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string words = many ? lines[i].run.solver_name() : lines[i].label;
    Series& all = found_or_added(list, [&](const Series& other) { return many && other.words == words; },
                                 {words, style_of(lines[i].run).colour, plots_of(lines, i, 1.7)});
    for (const std::string& plot : plots_of(lines, i, 1.1)) all.alone.push_back(plot);
  }
  return list;
}

std::string off_by(double error, const char* unit) {
  return error > least_error ? fmt::format("off by {:.2g} {}", error, unit)
                             : fmt::format("off by less than {:g} {}", least_error, unit);
}

std::string answer(const std::vector<CostLine>& lines, double tolerance, const char* unit) {
  const Cost* best = nullptr;
  const CostLine* of = nullptr;
  double least = 1e300;
  for (const CostLine& line : lines)
    for (const Cost& cost : line.costs) {
      least = std::min(least, cost.error);
      if (std::max(cost.error, cost.upper) <= tolerance && (best == nullptr || cost.time < best->time))
        best = &cost, of = &line;
    }
  if (best == nullptr)
    return fmt::format("No RMS error within {:g} {}, all {} or more", tolerance, unit, off_by(least, unit));
  return fmt::format("Cheapest with an RMS error within {:g} {}: {} ({}{}), {}, {} a second of motion",
                     tolerance, unit, of->label, best->label, of->unit, off_by(best->error, unit),
                     rounded_duration(best->time));
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
        "lines join steps whose quartiles of errors part; dotted slopes: a method of order one, and of two; black: "
        "the exact solver");
  const bool changed = std::ranges::any_of(
      lines, [](const CostLine& line) { return line.run.settings.find('+') != std::string::npos; });
  if (many && changed)
    sheet.note("stars and crosses: sets with a parameter changed, which the ranking names");
}

std::string exact_line(double cost, bool named) {
  if (cost <= 0) return "";
  std::string line = fmt::format(
      "set arrow from {0}, graph 0 to {0}, graph 1 nohead lw 3 lc rgb '#000000' back\n", plain(cost));
  if (named) line += fmt::format("set label ' exact solver' at {}, graph 0.1 left font ',12'\n", plain(cost));
  return line;
}

}  // namespace

Drawing error_time(const SceneSubject& subject) {
  const Measure& measure = measure_of(subject);
  const std::vector<CostLine> lines = cost_lines(subject.comparison, subject.scene.name, measure);
  if (lines.empty()) return subject.nothing("No engine run of this scene with both an error and a time.");
  const double exact = exact_cost(subject.shown().exact);
  const Frame frame = frame_of(lines, exact);
  const bool many = lines.size() > most_series;
  constexpr auto floor_style = "lw 2 dt (6,4) lc rgb '#666666'";
  const bool comparable = are_comparable(subject.scene, lines.front().run);
  Legend legend;
  if (!many)
    for (const CostLine& line : lines) legend.emplace_back(mark_style(line.run, 1.7), line.label);
  if (!many && !floors(lines).empty())
    legend.emplace_back(fmt::format("with lines {}", floor_style), "model error, from the fit");
  Sheet sheet = subject.sheet(legend, answer(lines, subject.comparison.tolerance, measure.unit));
  Numbers all;
  for (const CostLine& line : lines) std::ranges::copy(numbers_of(line), std::back_inserter(all));
  for (std::size_t i = 0; i < lines.size(); ++i)
    sheet.data(number_block(fmt::format("line_{}", i), numbers_of(lines[i])) +
               number_block(fmt::format("pieces_{}", i), pieces(lines[i], comparable)));
  const std::vector<OrderGuide> slopes = slopes_of(lines, frame);
  const std::string guides = slope_guides(slopes, !many);
  const auto axes = logarithmic_axes(frame.across, frame.up);
  const double height = subject.height(520, 520);
  const char* across = many ? "stepping time a second (s)" : "stepping time for one second of motion (s)";
  SeriesPanel panel{across, measure.words, measure.short_words, true, axes, height, 0};
  panel.under = many ? std::vector{context_marks(sheet, all)} : floors(lines);
  panel.few = guides + exact_line(exact, true) + labels(lines, slopes, frame, sheet.panel_width(), height);
  panel.many = guides + exact_line(exact, false);
  add_series(sheet, panel, series_of(lines, many), many);
  sheet.note(draws_note(subject.comparison, subject.scene.name));
  if (!subject.on_slide) sheet.note(marks_note(mapped(lines, &CostLine::run)));
  if (!subject.on_slide) add_notes(sheet, lines, !slopes.empty(), many);
  return sheet.finish();
}

}  // namespace rockstack::plots
