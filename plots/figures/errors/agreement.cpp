#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "plots/drawing/rows.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// How many scenes are shown at most, and how many of them beside each other: fewer beside a player.
constexpr std::size_t most_scenes = 12, scenes_in_a_row = 6, beside_a_player = 3;

/// What all scenes show: a row a solver and set, of each a line a time step.
struct CommonAxes {
  std::vector<std::string> sets;
  std::vector<double> steps;  ///< s, falling
  std::string note = {};      ///< which sets these are of all; empty: all

  /// How much of a set's colour a step has, from a least share on: the coarser, the paler.
  double strength(double dt, double palest) const {
    return steps.size() < 2 ? 1 : palest + (1 - palest) * place(dt) / static_cast<double>(steps.size() - 1);
  }
  std::string colour(const Run& run, double palest) const {
    return paler(style_of(run).colour, strength(*run.dt, palest));
  }
  /// Where the line of a run lies, beside its row's middle; none of a set or step that is not shown.
  std::optional<double> height(const Run& run) const {
    const auto set = std::ranges::find(sets, line_label(run));
    if (set == sets.end() || std::ranges::find(steps, run.dt) == steps.end()) return std::nullopt;
    return static_cast<double>(set - sets.begin()) +
           0.27 * (place(*run.dt) - 0.5 * static_cast<double>(steps.size() - 1));
  }
  double place(double dt) const { return static_cast<double>(std::ranges::find(steps, dt) - steps.begin()); }
};

bool is_shown(const Run& run) {
  return is_engine(run) && !run.is_variant();
}

JudgedScene scale_of(const Comparison& comparison, const ComparedScene& scene) {
  return {scene.name, least_height(scene.blocks), scene.duration, comparison.tolerance};
}

/// Runs of engines alone, those of the set that the verdict ranks first before all others.
std::vector<Run> best_first(const Comparison& comparison) {
  const auto place = [&](const Run& run) {
    return std::ranges::find_if(comparison.verdict.ranking, [&](const RankedSet& set) {
      return std::tie(set.engine, set.solver, set.settings) == std::tie(run.engine, run.solver, run.settings);
    });
  };
  std::vector<Run> runs;
  std::ranges::copy_if(comparison.runs, std::back_inserter(runs), is_shown);
  std::ranges::stable_sort(runs, {}, place);
  return runs;
}

/// Where all sets are more than a page shows, those of each engine's first solver.
CommonAxes frame_of(const Comparison& comparison) {
  CommonAxes frame;
  std::vector<std::string> first;
  std::map<std::string, std::string> solvers;  // of each engine that which is ranked first, or runs first
  for (const RankedSet& set : comparison.verdict.ranking) solvers.try_emplace(set.engine, set.solver);
  for (const Run& run : comparison.runs) solvers.try_emplace(run.engine, run.solver);
  const std::vector<Run> runs = best_first(comparison);
  for (const Run& run : runs) {
    const std::string label = line_label(run);
    const auto is_own = [&](const std::string& set) { return set == label; };
    found_or_added(frame.sets, is_own, label);
    if (solvers.at(run.engine) == run.solver) found_or_added(first, is_own, label);
  }
  if (frame.sets.size() > most_rows) {
    frame.sets = first;
    frame.note = "of each engine the solver that comes nearest over all scenes";
    if (frame.sets.size() > most_rows)
      frame.note += fmt::format(", the first {} of {} sets", most_rows, frame.sets.size());
    frame.sets.resize(std::min(frame.sets.size(), most_rows));
  }
  frame.steps = chosen_steps(runs);
  return frame;
}

/// Marks are small: the palest has a contrast of 3 to white and more.
constexpr double palest_line = 0.5, palest_mark = 0.75;

constexpr auto failure_style = "with points pt 2 ps 0.9*mark lw 2 lc rgb '#B00020'";
constexpr auto quartiles_style = "lw 1.5 lc rgb '#000000'";
/// A range of less than this share of the axis is no more than a spot.
constexpr double least_range = 0.02;

/// From nought to when it stops agreeing, or to the edge, with quartiles of what decides, angles or centres.
void add_times(Plots& plots, const Run& run, double height, const std::string& colour,
               const JudgedScene& scale, double edge) {
  if (!run.done()) return plots.add({{0, height}}, {fmt::format("using 1:2 {}", failure_style)});
  const double end = agreement_end(run, scale);
  plots.add({{0, height, std::min(end, edge)}},
            {fmt::format("using 1:2:3:(0) with vectors nohead lw 6 lc rgb '{}'", colour)});
  const bool by_angles = run.agreement_time.value_or(end) <= run.position_agreement_time.value_or(INFINITY);
  const auto lower = by_angles ? run.agreement_time_lower : run.position_agreement_time_lower;
  const auto upper = by_angles ? run.agreement_time_upper : run.position_agreement_time_upper;
  if (!lower || !upper) return;
  const double low = std::min(*lower, edge), high = std::min(*upper, edge);
  if (high - low < least_range * edge) return;
  plots.add({{std::clamp(end, low, high), height, low, high}},
            {fmt::format("using 1:2:3:4 with xerrorbars pt 0 {}", quartiles_style)});
}

/// The largest difference before the horizon: of an angle, rad, or of a centre over the least block height.
double largest_of(const Run& run) {
  return std::max(run.largest_angle_difference.value_or(0), run.relative_position_difference.value_or(0));
}

/// Axis of all scenes, almost two decades below the tolerance at least, so that no number stands at the end.
Extent size_axis(const Comparison& comparison) {
  constexpr double decades_below = 1e-4, room = 1.5;
  Extent axis{comparison.tolerance / 80, comparison.tolerance * 10};
  for (const Run& run : comparison.runs)
    if (is_shown(run) && run.done() && run.error) {
      axis.add(room * largest_of(run));
      axis.add(largest_of(run) / room);
    }
  return {std::max(axis.low, comparison.tolerance * decades_below), axis.high};
}

/// A scene's axis ends behind its horizon, or with the motion where rows that agree so long do so to the end.
TimeAxis axis_of(const Comparison& comparison, const ComparedScene& scene) {
  const double whole = std::min(scene.duration, 1.15 * scene.horizon());
  const std::vector<Run> exact = shown_runs(comparison, scene.name).exact;
  double end = scene.has("histories") && !exact.empty() ? time_axis(scene, exact).end : whole;
  const JudgedScene scale = scale_of(comparison, scene);
  for (const Run& run : comparison.runs)
    if (run.scene == scene.name && is_shown(run) && run.done() && !agrees(run, scale))
      end = std::max(end, agreement_end(run, scale));
  return {std::min(end, whole), scene.horizon()};
}

/// Scenes side by side, from one to another: until when, and under that by how much.
void add_scenes(Sheet& sheet, const Comparison& comparison, const CommonAxes& frame, std::size_t from,
                std::size_t to) {
  const Extent sizes = size_axis(comparison);
  const bool few = to - from <= beside_a_player;  // more columns leave no room for what their scenes are
  std::vector<RowColumn> times, largest;
  for (std::size_t s = from; s < to; ++s) {
    const ComparedScene& scene = comparison.scenes[s];
    Plots until(sheet, fmt::format("until_{}", s)), off(sheet, fmt::format("off_{}", s));
    off.add({{comparison.tolerance, -0.7, static_cast<double>(frame.sets.size())}},
            {fmt::format("using 1:2:(0):3 with vectors nohead {}", tolerance_style)});
    const TimeAxis axis = axis_of(comparison, scene);
    for (const Run& run : comparison.runs) {
      if (run.scene != scene.name || !is_shown(run)) continue;
      const std::optional<double> height = frame.height(run);
      if (!height) continue;
      add_times(until, run, *height, frame.colour(run, palest_line), scale_of(comparison, scene), axis.end);
      if (run.done() && run.error)
        off.add({{std::max(largest_of(run), sizes.low), *height}},
                {fmt::format("using 1:2 with points lw 2 lc rgb '{}' pt {} ps 1.1*mark",
                             frame.colour(run, palest_mark), style_of(run).mark)});
    }
    times.push_back(
        {"agrees until (s)", until.list(), scene.name, few ? scene.title : "", axis.end, shade_beyond(axis)});
    largest.push_back({"off by (rad, or share)", off.list()});
  }
  sheet.leave_room_above(from == 0 ? 0 : 90);
  const std::string order = comparison.verdict.ranking.empty() ? "" : "by rank";
  add_rows(sheet, {.words = frame.sets, .order = order}, times);
  sheet.leave_room_above(90);
  add_rows(sheet, {.words = frame.sets, .low = sizes.low, .high = sizes.high, .order = order}, largest);
}

Legend legend_of(const Comparison& comparison, const CommonAxes& frame) {
  const auto any = [&](const auto& holds) {
    return std::ranges::any_of(comparison.runs, [&](const Run& run) { return is_shown(run) && holds(run); });
  };
  Legend legend;
  for (const double dt : frame.steps)
    legend.emplace_back(
        fmt::format("with lines lw 6 lc rgb '{}'", paler("#333333", frame.strength(dt, palest_line))),
        "step " + duration_text(dt));
  legend.emplace_back(fmt::format("with lines {}", tolerance_style), "tolerance, below");
  if (any([](const Run& run) { return run.draws.value_or(1) > 1; }))
    legend.emplace_back(fmt::format("with lines {}", quartiles_style), "quartiles of replicates");
  for (const ComparedScene& scene : comparison.scenes)
    if (const TimeAxis axis = axis_of(comparison, scene); axis.is_shaded()) {
      explain_shade(axis, legend);
      break;
    }
  if (any([](const Run& run) { return !run.done(); })) legend.emplace_back(failure_style, "failed");
  return legend;
}

std::string answer(const Comparison& comparison) {
  std::size_t all = 0, whole = 0;
  for (const ComparedScene& scene : comparison.scenes)
    for (const Run& run : comparison.runs) {
      if (run.scene != scene.name || !is_shown(run) || !run.error) continue;
      ++all;
      whole += run.done() && agrees(run, scale_of(comparison, scene)) ? 1 : 0;
    }
  return fmt::format(
      "{} of {} runs (solver × set × scene × step) stay within {} and {:g} % of the least block height",
      whole, all, quantity_text(comparison.tolerance, "rad"), 100 * comparison.tolerance);
}

/// `beside`: so many scenes beside each other.
Drawing drawn(Sheet sheet, const Comparison& comparison, const CommonAxes& frame, std::size_t beside) {
  const std::size_t scenes = std::min(comparison.scenes.size(), most_scenes);
  for (std::size_t from = 0; from < scenes; from += beside)
    add_scenes(sheet, comparison, frame, from, std::min(from + beside, scenes));
  if (scenes < comparison.scenes.size())
    sheet.note(fmt::format("the first {} of {} scenes", scenes, comparison.scenes.size()));
  sheet.note(frame.note);
  return sheet.finish();
}

}  // namespace

Drawings agreement(const ComparisonSubject& subject) {
  const Comparison& comparison = subject.comparison;
  const CommonAxes frame = frame_of(comparison);
  if (std::ranges::none_of(comparison.runs, [](const Run& run) { return is_shown(run) && run.error; }))
    return {};
  const Legend legend = legend_of(comparison, frame);
  const bool player = std::ranges::any_of(
      comparison.scenes, [&](const ComparedScene& scene) { return has_motion(comparison, scene); });
  const Sheet sheet =
      subject.sheet(comparison.title, legend, answer(comparison), player ? shared_width : full_width);
  if (sheet.printed()) {
    constexpr double room = 300;  // pixels of a scene
    return {
        {"", drawn(sheet, comparison, frame, static_cast<std::size_t>(std::max(1.0, sheet.width() / room)))}};
  }
  return {{"", drawn(sheet, comparison, frame, player ? beside_a_player : scenes_in_a_row)},
          {narrow_part, drawn(Sheet("", legend, "", narrow_width), comparison, frame, 1)}};
}

}  // namespace rockstack::plots
