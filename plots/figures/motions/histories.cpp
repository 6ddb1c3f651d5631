#include "comparisons/measures/results/csv.hpp"
#include "plots/data/patterns.hpp"
#include "plots/data/run_files.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// Ticks that hang from the upper edge of a panel of so many pixels, no two nearer than one of them.
std::string impact_ticks(const Run& first, int block, const TimeAxis& axis, double width) {
  std::string text;
  if (!first.exact()) return text;
  const double end = axis.end, length = end - axis.begin;
  double last = -end;
  for (const double time : impact_times(*history_of(first), block + 1)) {
    if (time > end) break;
    if (time < axis.begin || time - last < length / width) continue;
    text += fmt::format("set arrow from {0}, graph 1 to {0}, graph 0.94 nohead lw 2 lc rgb '#000000' front\n",
                        plain(time));
    last = time;
  }
  return text;
}

/// Pale enough for black letters.
constexpr std::array tints{"#DCE9F5", "#FBE3C4", "#D5EFE3", "#F4D9E6", "#EFEBC0",
                           "#E3DDF3", "#E2E2E2", "#F7D3C5", "#CDE6EC"};

/// One box a span, named where it is wide enough in a figure so many pixels wide; spans under a pixel belong
/// to the one before.
std::string pattern_band(const std::vector<PatternSpan>& spans, const TimeAxis& axis, double width) {
  std::string text;
  std::map<std::string, std::size_t> tint_of;
  const double end = axis.end, length = end - axis.begin;
  double from = axis.begin;
  for (std::size_t i = 0; i < spans.size() && from < end; ++i) {
    const bool last = i + 1 == spans.size();
    const double to = last ? end : std::min(spans[i].to, end);
    if (to - from < length / 1100 && !last) continue;
    const std::string pattern = name(spans[i].pattern);
    const std::size_t tint = tint_of.try_emplace(pattern, tint_of.size()).first->second;
    text += fmt::format(
        "set object rectangle from {}, graph 0 to {}, graph 1 fillcolor rgb '{}' fillstyle solid noborder behind\n",
        plain(from), plain(to), tints.at(tint % tints.size()));
    const double letter = length / 95;
    if (to - from > letter * full_width / width * static_cast<double>(pattern.size() + 1))
      text += fmt::format("set label {} noenhanced at {}, graph 0.5 center font ',12' front\n",
                          in_quotes(shown_pattern(spans[i].pattern)), plain((from + to) / 2));
    from = to;
  }
  return text;
}

void add_band(Sheet& sheet, const History& exact, const TimeAxis& axis) {
  const std::vector<PatternSpan> spans = pattern_spans(exact);
  if (spans.empty()) return;
  sheet.panel(26, 8,
              fmt::format("set xrange [{}:{}]\n", plain(axis.begin), plain(axis.end)) + time_numbers +
                  "set yrange [0:1]\nunset ytics\nunset grid\nunset ylabel\n"
                  "set label 'pattern ' at graph -0.004, graph 0.5 right font ',12'\n" +
                  pattern_band(spans, axis, sheet.width()),
              {});
  const auto slides = [](const PatternSpan& span) {
    return name(span.pattern).find_first_of("<>-") != std::string::npos;
  };
  if (sheet.width() != full_width) return;
  const bool of_paper = exact.blocks == 2 && std::ranges::none_of(spans, slides);
  sheet.note(
      of_paper
          ? "ticks: exact impacts below that block; patterns as Spanos et al. 2001 number them, Fig. 2"
          : "ticks: exact impacts below that block; patterns from the ground up: C closed, L and R on that "
            "corner, – apart, ← → sliding",
      "#444444");
}

/// Up to a time, rad.
double largest_angle(const Run& run, double end) {
  const auto history = history_of(run);
  const auto last = std::ranges::upper_bound(history->times, end) - history->times.begin();
  const std::span<const double> angles(history->angles);
  return largest_magnitude(angles.first(static_cast<std::size_t>(last * history->blocks)));
}

/// Largest angles of each run, or of the only one; or of the exact one, and from which to which those of
/// engines go.
std::string largest_angles(const std::vector<Run>& runs, bool each, double end) {
  std::vector<std::string> texts;
  Extent engines;
  for (const Run& run : runs) {
    const double angle = largest_angle(run, end);
    if (each || run.exact() || runs.size() == 1)
      texts.push_back(fmt::format("{} {:.3g} rad", line_label(run), angle));
    else
      engines.add(angle);
  }
  if (engines.low <= engines.high)
    texts.push_back(fmt::format("engines {} rad", span_text(fmt::format("{:.3g}", engines.low),
                                                            fmt::format("{:.3g}", engines.high))));
  return fmt::format("Largest angles: {}", fmt::join(texts, "; "));
}

/// The angles of a block up to the end of the axis; `drawn`: how many curves the figure has for one.
std::vector<Curve> curves_of(const std::vector<Run>& runs, std::size_t drawn, int blocks, int block,
                             const TimeAxis& axis) {
  const std::size_t bins = bins_for(drawn * static_cast<std::size_t>(blocks));
  return mapped(runs, [&](const Run& run) {
    const auto history = history_of(run);
    return thin({history->times, column_of(*history, &History::angles, block)}, axis, bins);
  });
}

/// The unit that a block's angles are drawn in, which the curves are in from then on.
AngleUnit put_in_unit(const Subject& subject, const std::vector<Run>& runs, std::vector<Curve>& curves) {
  const Extent extent = extent_of(runs, curves, 0.5, 0);
  const AngleUnit unit = subject.unit(std::max(std::abs(extent.low), std::abs(extent.high)));
  scale(curves, unit.scale);
  return unit;
}

std::string words_up(int block, const AngleUnit& unit) {
  return fmt::format("{} ({})", angle_name(block + 1), unit.name);
}

std::string axes_of(const std::vector<Run>& runs, const std::vector<Curve>& curves, const TimeAxis& axis,
                    double height) {
  const Extent extent = extent_of(runs, curves, 0.5, 1e-6);
  return time_range(axis) + linear_range("y", extent.low, extent.high, height) + grid_lines;
}

/// One panel of all runs, the exact one first.
void add_angles(Sheet& sheet, const SceneSubject& subject, const std::vector<Run>& runs, int block,
                const TimeAxis& axis, bool lowest) {
  const int blocks = subject.scene.block_count();
  const double tall = subject.height(panel_height(blocks), blocks * panel_height(blocks));
  std::vector<Curve> curves = curves_of(runs, runs.size(), blocks, block, axis);
  const std::string words = words_up(block, put_in_unit(subject, runs, curves)),
                    stem = fmt::format("angle_{}", block + 1);
  const auto axes = [&](double, double height) { return axes_of(runs, curves, axis, height); };
  SeriesPanel panel{"time (s)", words, words, lowest, axes, tall};
  if (runs.front().exact() && curves.front().size() > 0) panel.over = {exact_core(stem + "_0")};
  panel.few = impact_ticks(runs.front(), block, axis, sheet.panel_width());
  add_curves(sheet, panel, runs, curves, stem);
}

constexpr auto fine = "with lines lw 1.5", coarse = "with lines lw 1.5 dt (5,5)";
constexpr auto band_style = "with filledcurves fs transparent solid 0.25 noborder";

/// Between what the middle half of a block's angles lie over a run's replicates, rad, at times up to the end;
/// nothing where the run has none, or its files no histories.
Numbers band_lines(const Run& run, int block, double end, double scale = 1) {
  Numbers lines;
  const fs::path file = run.folder / "band.csv";
  if (!fs::exists(file)) return lines;
  const std::string number = std::to_string(block + 1);
  const auto band = read_columns(file, {"time", "lower_" + number, "upper_" + number});
  for (std::size_t i = 0; i < band[0].size() && band[0][i] <= end; ++i)
    lines.push_back({band[0][i], scale * band[1][i], scale * band[2][i]});
  return lines;
}

/// With its step; a law of the exact solver has none.
std::string words_of(const StepLine& line) {
  const auto step = [&](const Run& run) {
    return varies_iterations(line) ? std::to_string(iterations_of(run)) + " iterations"
                                   : duration_text(value_of(run.dt));
  };
  if (!line.front().dt) return line_label(line);
  const std::string finest = line_label(line) + ", " + step(line.front());
  return line.size() < 2 ? finest : finest + ", " + step(line.back()) + " dashed";
}

/// A panel a line over the exact curve; `runs` are the exact one, if any, and both ends of each line.
void add_lines(Sheet& sheet, const Subject& subject, const std::vector<Run>& runs, std::vector<Curve> curves,
               const std::vector<StepLine>& lines, int block, const TimeAxis& axis) {
  const AngleUnit unit = put_in_unit(subject, runs, curves);
  DrawnPanel told{"time (s)", words_up(block, unit)};
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (curves[i].size() > 0)
      told.curves.push_back({run_label(runs[i]), style_of(runs[i]).colour, curves[i]});
  sheet.tell(std::move(told));
  const auto plot = [&](std::size_t run, const std::string& style) {
    const std::string name = fmt::format("angle_{}_{}", block + 1, run);
    sheet.data(data_block(name, curves[run]));
    return plot_of(name, style);
  };
  std::vector<std::string> context;
  std::size_t at = 0;
  if (runs.front().exact()) context.push_back(plot(at++, exact_style));
  std::vector<Series> multiples;
  for (const StepLine& line : lines) {
    Series one{words_of(line), style_of(line.front()).colour};
    const std::size_t last = at + ends_of(line).size() - 1;
    for (std::size_t i = at; i <= last; ++i) {
      const Numbers band = band_lines(runs[i], block, axis.end, unit.scale);
      if (band.empty()) continue;
      const std::string name = fmt::format("band_{}_{}", block + 1, i);
      sheet.data(number_block(name, band));
      one.alone.push_back(
          fmt::format("${} using 1:2:3 {} fc rgb '{}' notitle", name, band_style, one.colour));
    }
    for (; at <= last; ++at)
      if (curves[at].size() > 0)
        one.alone.push_back(plot(at, fmt::format("{} lc rgb '{}'", at < last ? coarse : fine, one.colour)));
    multiples.push_back(std::move(one));
  }
  const auto settings = [&](double width, double height) {
    return axes_of(runs, curves, axis, height) + linear_tics("x", axis.begin, axis.end, width) +
           impact_ticks(runs.front(), block, axis, width);
  };
  add_multiples(sheet, multiples, context, settings, "time (s)", words_up(block, unit));
}

/// All runs in one panel a block; `all`: the answer is of each, else of the first, exact where there is one.
Drawing draw_runs(const SceneSubject& subject, const std::vector<Run>& runs, bool all) {
  const int blocks = subject.scene.block_count();
  if (runs.empty()) return subject.nothing("No run of this scene was done.");
  Legend legend = legend_of(runs, curve_style);
  const TimeAxis axis = subject.time_axis(runs, legend);
  const bool banded = runs.front().exact() && !pattern_spans(*history_of(runs.front())).empty();
  Sheet sheet = subject.sheet(legend, largest_angles(runs, all, subject.scene.horizon()));
  for (int k = 0; k < blocks; ++k) add_angles(sheet, subject, runs, k, axis, k + 1 == blocks && !banded);
  if (banded) add_band(sheet, *history_of(runs.front()), axis);
  return sheet.finish();
}

/// Each engine's coarsest and finest run on the exact curve.
Drawing draw_lines(const SceneSubject& subject, const std::vector<Run>& exact,
                   const std::vector<StepLine>& lines) {
  const int blocks = subject.scene.block_count();
  std::vector<Run> runs = exact;
  for (const StepLine& line : lines)
    for (const Run& run : ends_of(line)) runs.push_back(run);
  Legend legend;
  if (!exact.empty()) legend.emplace_back(exact_style, "exact");
  const bool dashed = std::ranges::any_of(lines, [](const StepLine& line) { return line.size() > 1; });
  const auto explain = [&](const char* style, const char* words) {
    legend.emplace_back(fmt::format("{} lc rgb '#000000'", style), words);
  };
  explain(fine, dashed ? "engine, finest step" : "engine");
  if (dashed) explain(coarse, "engine, coarsest step");
  if (std::ranges::any_of(runs, [](const Run& run) { return !band_lines(run, 0, HUGE_VAL).empty(); }))
    legend.emplace_back(fmt::format("{} fc rgb '#000000'", band_style), "middle half of its replicates");
  const TimeAxis axis = subject.time_axis(runs, legend);
  Sheet sheet = subject.sheet(legend, largest_angles(runs, false, subject.scene.horizon()));
  const std::size_t drawn = runs.size() + lines.size() * exact.size();
  for (int k = 0; k < blocks; ++k) {
    sheet.leave_room_above(24);
    add_lines(sheet, subject, runs, curves_of(runs, drawn, blocks, k, axis), lines, k, axis);
  }
  if (!exact.empty()) {
    sheet.leave_room_above(70);
    add_band(sheet, *history_of(exact.front()), axis);
  }
  return sheet.finish();
}

}  // namespace

Drawing histories(const SceneSubject& subject) {
  const std::vector<Run> exact = subject.shown().exact;
  const std::vector<StepLine> lines = shown_lines(subject.comparison, subject.scene.name);
  if (subject.on_slide) return draw_runs(subject, all_runs(subject.shown()), false);
  if (!lines.empty() && !subject.scene.alone) return draw_lines(subject, exact, lines);
  return draw_runs(subject, lines.empty() ? exact : lines.front(), false);
}

Drawing equations(const SceneSubject& subject) {
  std::vector<Run> runs;
  for (const Run& run : done_runs(subject.comparison, subject.scene.name))
    if (run.exact() || run.has_other_equations()) runs.push_back(run);
  return draw_runs(subject, runs, true);
}

}  // namespace rockstack::plots
