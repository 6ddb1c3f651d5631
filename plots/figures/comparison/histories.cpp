#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "comparisons/measures/results/csv.hpp"
#include "plots/data/contacts.hpp"
#include "plots/data/events.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

/// The angles of one run, one curve a block.
struct Motion {
  Run run;
  std::vector<Curve> angles;
  double end = 0;  ///< last time, s
};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(const Curve& curve) {
    for (const double value : curve.values) low = std::min(low, value), high = std::max(high, value);
  }
  bool empty() const { return low > high; }
};

Motion read_motion(const Run& run, int blocks, std::size_t bins) {
  std::vector<std::string> names = numbered("theta_", blocks);
  names.insert(names.begin(), "time");
  std::vector<std::vector<double>> columns = read_columns(run.folder / "history.csv", names);
  Motion motion{.run = run, .angles = {}};
  if (!columns[0].empty()) motion.end = columns[0].back();
  for (std::size_t k = 1; k < columns.size(); ++k)
    motion.angles.push_back(thin(Curve{columns[0], std::move(columns[k])}, bins));
  return motion;
}

/// All of the exact curve, and of the others what lies within one half of its span beyond it: an engine whose
/// blocks fall over must not flatten the rest.
std::string angle_range(const std::vector<Motion>& motions, std::size_t block, double height) {
  Range all, exact;
  for (const Motion& motion : motions) {
    all.add(motion.angles[block]);
    if (motion.run.exact()) exact.add(motion.angles[block]);
  }
  if (!exact.empty() && exact.high - exact.low > 1e-6) {
    const double room = 0.5 * (exact.high - exact.low);
    all = {std::max(all.low, exact.low - room), std::min(all.high, exact.high + room)};
  }
  if (all.empty()) all = {0, 0};
  const double margin = std::max(0.08 * (all.high - all.low), 1e-6);
  const double low = all.low - margin, high = all.high + margin;
  return fmt::format("set yrange [{}:{}]\n", plain(low), plain(high)) + linear_tics("y", low, high, height);
}

std::string curve_name(std::size_t run, std::size_t block) {
  return fmt::format("angle_{}_{}", run, block + 1);
}

/// Engines first and the exact line over them, or it would be hidden where they agree; thick, it shows beside
/// them.
std::vector<std::string> angle_plots(const std::vector<Motion>& motions, std::size_t block) {
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (motions[i].angles[block].times.empty()) continue;
    const std::string style = curve_style(motions[i].run, i);
    plots.push_back(fmt::format("${} using 1:2 {} notitle", curve_name(i, block), style));
    if (motions[i].run.exact())
      plots.push_back(fmt::format("${} using 1:2 with lines lw 1 lc rgb '{}' notitle", curve_name(i, block),
                                  style_of(motions[i].run).colour));
  }
  return plots;
}

/// Ticks that hang from the upper edge, no two nearer than a pixel.
std::string impact_ticks(const std::vector<double>& times, double end) {
  std::string text;
  double last = -end;
  for (const double time : times) {
    if (time - last < end / 1000) continue;
    text += fmt::format("set arrow from {0}, graph 1 to {0}, graph 0.94 nohead lw 2 lc rgb '#000000' front\n",
                        plain(time));
    last = time;
  }
  return text;
}

/// One box a span, named where it is wide enough; spans under a pixel belong to the one before.
std::string pattern_band(const std::vector<PatternSpan>& spans, double end) {
  std::string text;
  std::map<std::string, std::size_t> tint_of;
  double from = 0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const bool last = i + 1 == spans.size();
    const double to = last ? end : spans[i].to;
    if (to - from < end / 1100 && !last) continue;
    const std::size_t tint = tint_of.try_emplace(spans[i].pattern, tint_of.size()).first->second;
    text += fmt::format(
        "set object rectangle from {}, graph 0 to {}, graph 1 fillcolor rgb '{}' fillstyle solid noborder "
        "behind\n",
        plain(from), plain(to), pattern_tint(tint));
    const double letter = end / 95;
    if (to - from > letter * static_cast<double>(spans[i].pattern.size() + 1))
      text += fmt::format("set label {} noenhanced at {}, graph 0.5 center font ',12' front\n",
                          in_quotes(shown_pattern(spans[i].pattern)), plain((from + to) / 2));
    from = to;
  }
  return text;
}

/// Events of the exact run, if there is one; it is the first of the motions.
ExactEvents events_of(const std::vector<Motion>& motions, int blocks) {
  ExactEvents events;
  events.impact_times.resize(static_cast<std::size_t>(blocks));
  const Motion& first = motions.front();
  if (!first.run.exact()) return events;
  events = read_events(first.run, blocks, first.end, "");
  if (events.spans.empty()) events = read_events(first.run, blocks, first.end, starting_pattern(first.run));
  return events;
}

std::vector<Motion> read_motions(const std::vector<Run>& runs, int blocks) {
  std::vector<Motion> motions;
  const std::size_t bins = bins_for(runs.size() * static_cast<std::size_t>(blocks));
  motions.reserve(runs.size());
  for (const Run& run : runs) motions.push_back(read_motion(run, blocks, bins));
  return motions;
}

double last_time(const std::vector<Motion>& motions) {
  double end = 1e-9;
  for (const Motion& motion : motions) end = std::max(end, motion.end);
  return end;
}

bool are_many(const std::vector<Motion>& motions) {
  return motions.size() > most_series + 1;
}

Legend legend_of(const std::vector<Motion>& motions) {
  Legend legend;
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (const Run& run = motions[i].run; !are_many(motions) || run.exact())
      legend.emplace_back(curve_style(run, i), run_label(run));
  return legend;
}

constexpr auto time_label = "set format x '%g'\nset xlabel 'time (s)'\n";

std::string time_range(double end) {
  return fmt::format("set xrange [0:{}]\n", plain(end));
}

/// What the letters of patterns mean, where blocks slide or fly.
void add_letters(Sheet& sheet, const std::vector<PatternSpan>& spans) {
  const auto slides = [](const PatternSpan& span) {
    return span.pattern.find_first_of("<>-") != std::string::npos;
  };
  if (std::any_of(spans.begin(), spans.end(), slides))
    sheet.note(
        "patterns from the ground up: C closed, L and R on the left and right corner, – apart, ← → the way "
        "it "
        "slides",
        "#444444");
}

void add_band(Sheet& sheet, const std::vector<PatternSpan>& spans, double exact_end, double end) {
  if (spans.empty()) return;
  constexpr double height = 26, gap = 8;
  sheet.panel(height, gap,
              time_range(end) + time_label +
                  "set yrange [0:1]\nunset ytics\nunset grid\nunset ylabel\n"
                  "set label 'pattern ' at graph -0.004, graph 0.5 right font ',12'\n" +
                  pattern_band(spans, exact_end),
              {});
  add_letters(sheet, spans);
}

std::string panel_settings(const std::vector<Motion>& motions, const ExactEvents& events, std::size_t block,
                           double end) {
  const bool lowest = block + 1 == events.impact_times.size() && events.spans.empty();
  const double height = panel_height(static_cast<int>(events.impact_times.size()));
  return time_range(end) + (lowest ? time_label : without_horizontal_labels()) +
         angle_range(motions, block, height) + grid_lines +
         fmt::format("set ylabel '{} (rad)' offset 0.5\n", angle_name(static_cast<int>(block) + 1)) +
         impact_ticks(events.impact_times[block], end);
}

/// A panel a run, over the exact angle.
void add_small_panels(Sheet& sheet, const std::vector<Motion>& motions, std::size_t block, double end) {
  std::vector<std::string> context;
  std::vector<Multiple> series;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const std::string colour = style_of(motions[i].run).colour;
    const std::string data = "$" + curve_name(i, block) + " using 1:2 with lines ";
    if (motions[i].run.exact())
      context.push_back(data + "lw 3 lc rgb '#BDBDBD' notitle");
    else
      series.push_back(
          {line_label(motions[i].run), colour, {data + fmt::format("lw 1.5 lc rgb '{}' notitle", colour)}});
  }
  add_multiples(sheet, series, context,
                time_range(end) + angle_range(motions, block, multiple_height) + grid_lines, "time (s)",
                angle_name(static_cast<int>(block) + 1) + " (rad)");
}

double largest_angle(const Motion& motion) {
  double largest = 0;
  for (const Curve& curve : motion.angles)
    for (const double angle : curve.values) largest = std::max(largest, std::abs(angle));
  return largest;
}

/// The largest angles of the first motion, the exact one where there is one, or of all that are asked about.
std::string answered(const std::string& question, const std::vector<Motion>& motions, bool all) {
  std::string text = question + " Largest angles: ";
  for (std::size_t i = 0; i < (all ? motions.size() : 1); ++i)
    text += fmt::format("{}{} {:.3g} rad", i > 0 ? "; " : "", line_label(motions[i].run),
                        largest_angle(motions[i]));
  return text;
}

Drawing draw_runs(const std::vector<Run>& runs, const ComparedScene& scene, const std::string& question,
                  bool all) {
  if (runs.empty()) return empty_sheet(heading(scene), "No run of this scene was done.");
  const std::vector<Motion> motions = read_motions(runs, scene.blocks);
  const ExactEvents events = events_of(motions, scene.blocks);
  const double end = last_time(motions);
  Sheet sheet(heading(scene), legend_of(motions), answered(question, motions, all));
  constexpr double gap = 16;
  for (std::size_t k = 0; k < events.impact_times.size(); ++k) {
    for (std::size_t i = 0; i < motions.size(); ++i)
      sheet.data(data_block(curve_name(i, k), motions[i].angles[k]));
    if (are_many(motions))
      add_small_panels(sheet, motions, k, end);
    else
      sheet.panel(panel_height(scene.blocks), gap, panel_settings(motions, events, k, end),
                  angle_plots(motions, k));
  }
  if (!are_many(motions)) add_band(sheet, events.spans, motions.front().end, end);
  return sheet.finish();
}

}  // namespace

Drawing histories(const Comparison& comparison, const ComparedScene& scene) {
  const Shown shown = shown_runs(comparison, scene.name);
  std::vector<Run> runs = shown.exact;
  runs.insert(runs.end(), shown.engines.begin(), shown.engines.end());
  return draw_runs(runs, scene, "How do the blocks move?", false);
}

Drawing equations(const Comparison& comparison, const ComparedScene& scene) {
  std::vector<Run> runs;
  for (const Run& run : done_runs(comparison, scene.name))
    if (run.exact() || has_other_equations(run)) runs.push_back(run);
  return draw_runs(runs, scene, "What does linearising change?", true);
}

}  // namespace rockstack::plots
