#include "comparisons/measures/results/csv.hpp"
#include "plots/data/run_files.hpp"
#include "plots/drawing/rows.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// Behind the axis' end, so that marks of runs that agree to the end stand free.
constexpr double room_for_marks = 1.012;

/// Absolute differences of one engine run, one curve a block, and how long each replicate agrees.
struct Departure {
  Run run;
  std::vector<Curve> sizes;
  std::vector<double> agreement_times;  ///< s, rising; one where there are no replicates
};

/// One curve a block along the axis, or where `together` is set one of the largest of all of them.
Departure read_departure(const Run& run, int blocks, const TimeAxis& axis, std::size_t bins, bool together) {
  std::vector<std::string> names = numbered("difference_", blocks);
  names.insert(names.begin(), "time");
  std::vector<std::vector<double>> columns = read_columns(run.shown_folder() / "difference.csv", names);
  if (together) {
    std::vector<double> largest(columns[0].size(), 0);
    for (std::size_t k = 1; k < columns.size(); ++k)
      for (std::size_t i = 0; i < largest.size(); ++i)
        largest[i] = std::max(largest[i], std::abs(columns[k][i]));
    columns = {columns[0], largest};
  }
  Departure departure{run, {}, replicates_of(run, "agreement_time")};
  if (departure.agreement_times.empty()) departure.agreement_times = {value_of(run.agreement_time)};
  constexpr double nothing = 1e-30;  // under every axis: a curve that is nearer leaves the panel
  for (std::size_t k = 1; k < columns.size(); ++k)
    departure.sizes.push_back(envelope(from_time({columns[0], std::move(columns[k])}, axis.begin),
                                       room_for_marks * axis.end, bins, nothing));
  return departure;
}

/// Powers of ten around the tolerance, the largest difference and what each curve mostly is.
Extent range_of(const std::vector<Departure>& departures, double tolerance) {
  Extent reach{tolerance / 100, tolerance * 10};
  for (const Departure& departure : departures)
    for (const Curve& curve : departure.sizes) {
      if (curve.values.empty()) continue;
      reach.add(quantile(curve.values, 1));
      reach.add(quantile(curve.values, 0.1));
    }
  reach.low = std::max(reach.low, tolerance * 1e-7);
  return {std::pow(10, std::floor(std::log10(reach.low))),
          std::pow(10, std::ceil(std::log10(reach.high) - 1e-9))};
}

/// One panel a curve of each run; small ones where runs are many, whose curve is that of all blocks.
void add_panels(Sheet& sheet, const SceneSubject& subject, const std::vector<Departure>& departures,
                const TimeAxis& axis, bool together) {
  const AngleUnit unit = subject.unit(1);
  const double tolerance = unit.scale * subject.comparison.tolerance;
  const Extent range = range_of(departures, tolerance);
  const std::size_t panels = departures.front().sizes.size();
  const double usual = panel_height(static_cast<int>(panels)),
               height = subject.height(usual, (static_cast<double>(panels) + 1.1) * usual);
  const std::vector<Run> runs = mapped(departures, &Departure::run);
  for (std::size_t k = 0; k < panels; ++k) {
    const auto sizes = mapped(departures, [&](const Departure& one) { return one.sizes[k]; });
    const std::string words =
        fmt::format("{} ({})",
                    together ? (subject.on_slide ? "|Δθ|" : "largest |Δθ|")
                             : fmt::format("|Δ{}|", angle_name(static_cast<int>(k) + 1)),
                    unit.name);
    const auto axes = [&](double, double up) {
      return time_range(axis, room_for_marks) + logarithmic_range("y", range.low, range.high, up) +
             grid_lines;
    };
    SeriesPanel panel{"time (s)", words, words, false, axes, height, 20};
    panel.under = {fmt::format("{} with lines {} notitle", plain(tolerance), tolerance_style)};
    panel.logarithmic = true;
    add_curves(sheet, panel, runs, sizes, fmt::format("difference_{}", k + 1), 2.5);
  }
}

/// Until when a run agrees, in the median of its replicates; the horizon of one that never leaves, whose last
/// sample comes a little before it.
double agreement_of(const Departure& one, double tolerance, double horizon) {
  return one.run.largest_angle_difference <= tolerance ? horizon : one.run.agreement_time.value_or(horizon);
}

/// A row a run: when each replicate first passes the tolerance, and their median, filled; with ≥ where it
/// does not up to the horizon, beyond which nothing is compared.
void add_agreements(Sheet& sheet, const std::vector<Departure>& departures, const TimeAxis& axis,
                    double tolerance, double horizon) {
  const auto rows = static_cast<double>(departures.size());
  const bool named = departures.size() > most_series;
  Plots plots(sheet, "agree");
  std::vector<std::string> names;
  for (const Departure& one : departures) {
    const double row = rows - static_cast<double>(names.size());
    const auto mark = [&](double time) { return std::vector{std::min(time, axis.end), row}; };
    plots.add(
        mapped(one.agreement_times, mark),
        {fmt::format("using 1:2 with points pt 2 ps 0.7*mark lw 1 lc rgb '{}'", style_of(one.run).colour)});
    const double agrees = agreement_of(one, tolerance, horizon);
    plots.add({mark(agrees)}, {"using 1:2 " + mark_style(one.run, 1.6)});
    if (agrees >= horizon) plots.add({mark(agrees)}, {"using 1:2:('≥') with labels right offset -1.2,0"});
    names.push_back(line_label(one.run));
  }
  const RowWords beside = row_words(names, sheet, static_cast<int>(names.size()), -1);
  const std::string words =
      named
          ? beside.tics
          : "unset ytics\nset label 2 'agrees until' at graph 0, graph 0.5 right offset -0.6,0 font ',12'\n";
  const double usual = sheet.width() == slide_width ? 15 : 22,
               row_height = named && beside.lines > 1 ? beside.row_height() : usual;
  sheet.row(row_height * (rows + 1), named ? 84 : 20,
            {{time_range(axis, room_for_marks) +
                  fmt::format("set yrange [0:{}]\nset xlabel '{}time (s)'\n", rows + 1,
                              named ? "agrees until " : "") +
                  grid_lines + words,
              plots.list()}},
            1, named ? beside.left : left_edge * full_width / sheet.width());
}

std::string answer(const std::vector<Departure>& departures, const ComparedScene& scene, double tolerance) {
  double first = scene.horizon(), last = 0;
  for (const Departure& one : departures) {
    if (one.run.is_variant()) continue;
    const double agrees = agreement_of(one, tolerance, scene.horizon());
    first = std::min(first, agrees);
    last = std::max(last, agrees);
  }
  const double horizon = scene.horizon();
  const std::string end = duration_text(horizon) + " that can be compared";
  if (first >= horizon) return fmt::format("All stay within {} rad for the {}", tolerance, end);
  const auto text = [](double time) { return fmt::format("{:.3g} s", time); };
  const std::string others = last >= horizon ? "others never in the " + end
                             : last > first  ? "the last at " + text(last) + " of " + end
                                             : "of " + end;
  return fmt::format("The first is off by more than {} rad at {}, {}", tolerance, text(first), others);
}

}  // namespace

Drawing differences(const SceneSubject& subject) {
  const ComparedScene& scene = subject.scene;
  const double tolerance = subject.comparison.tolerance;
  if (subject.shown().engines.empty()) return subject.nothing("No engine run of this scene to compare.");
  const RunSelection shown = subject.shown({"difference.csv"});
  const std::vector<Run>& runs = shown.engines;
  if (runs.empty()) return subject.nothing("No exact run of this scene to compare with.");
  constexpr int most_blocks = 4;  // with a panel each
  const bool many = are_many(runs), together = many || scene.block_count() > most_blocks ||
                                               (subject.on_slide && scene.block_count() > 1);
  const std::size_t curves =
      runs.size() * (many ? runs.size() : 2 * static_cast<std::size_t>(scene.block_count()));
  Legend legend = legend_of(runs, curve_style);
  legend.emplace_back(fmt::format("with lines {}", tolerance_style), "tolerance");
  if (!draws_note(subject.comparison, scene.name).empty())
    legend.emplace_back("with points pt 2 ps 0.7*mark lw 1 lc rgb '#000000'",
                        "below, where a replicate leaves it; large: their median");
  const TimeAxis axis = subject.time_axis(all_runs(shown), legend);
  const std::vector<Departure> departures = mapped(runs, [&](const Run& run) {
    Departure one = read_departure(run, scene.block_count(), axis, bins_for(curves), together);
    scale(one.sizes, subject.unit(1).scale);
    return one;
  });
  Sheet sheet = subject.sheet(legend, answer(departures, scene, tolerance));
  add_panels(sheet, subject, departures, axis, together);
  add_agreements(sheet, departures, axis, tolerance, scene.horizon());
  return sheet.finish();
}

}  // namespace rockstack::plots
