#include "plots/data/run_files.hpp"
#include "plots/drawing/rows.hpp"
#include "plots/figures/figure.hpp"

// Figures over slightly perturbed scenes.

namespace rockstack::plots {
namespace {

/// The runs of a scene that have answers over perturbed scenes, the exact one first.
std::vector<Run> perturbed_runs(const Comparison& comparison, const std::string& scene) {
  std::vector<Run> runs = done_runs(comparison, scene);
  std::erase_if(runs, [](const Run& run) { return !std::filesystem::exists(run.folder / "perturbed.csv"); });
  return runs;
}

/// One answer's sorted values of one quantity.
struct Sample {
  Run run;
  std::vector<double> values;
};

/// Samples of the peaks of a block, or with block 0 of the numbers of impacts.
std::vector<Sample> samples_of(const std::vector<Run>& runs, int block) {
  std::vector<Sample> samples;
  for (const Run& run : runs) {
    Sample sample{run, {}};
    for (const MotionTally& tally : *tallies_of(run))
      if (!tally.failed())
        sample.values.push_back(block > 0 ? tally.peaks.at(static_cast<std::size_t>(block) - 1)
                                          : tally.impacts);
    std::ranges::sort(sample.values);
    if (!sample.values.empty()) samples.push_back(std::move(sample));
  }
  return samples;
}

/// The share of values at or below, from one end of the panel to the other, as gnuplot's steps.
Curve shares(const std::vector<double>& values, const Extent& reach) {
  Curve curve{{reach.low}, {0}};
  for (std::size_t i = 0; i < values.size(); ++i)
    curve.add(values[i], static_cast<double>(i + 1) / static_cast<double>(values.size()));
  curve.add(reach.high, 1);
  return curve;
}

std::string style(const Run& run) {
  if (run.exact()) return "with steps lw 4 lc rgb '#000000'";
  const Style style = style_of(run);
  return fmt::format("with steps lw 2 lc rgb '{}' dt {}", style.colour, style.dash);
}

struct Quantity {
  std::string name, axis;
  int block = 0;  ///< 0: of the whole stack
};

std::vector<Quantity> quantities_of(const ComparedScene& scene) {
  std::vector<Quantity> list;
  for (int k = 1; k <= scene.block_count(); ++k)
    list.push_back({fmt::format("peak_{}", k), fmt::format("largest |{}| (rad)", angle_name(k)), k});
  list.push_back({"impacts", "impacts"});
  return list;
}

void add_distances(Sheet& sheet, const SceneSubject& subject, const std::vector<Run>& runs) {
  double critical = 0;
  for (const Run& run : runs) {
    std::string words;
    for (const auto& [name, axis, block] : quantities_of(subject.scene))
      for (const DistributionDistance& one : subject.comparison.distances) {
        if (one.run != run.run || one.quantity != name) continue;
        words += fmt::format("{} {:.2f} of {}", words.empty() ? ": D" : ",", one.apart.distance,
                             axis.substr(0, axis.find(" (")));
        critical = one.apart.critical;
      }
    if (!words.empty()) sheet.note(run_label(run) + words, style_of(run).colour);
  }
  if (critical > 0) sheet.note(fmt::format("by chance D is above {:.2f} once in twenty times", critical));
}

std::string answer(const SceneSubject& subject) {
  int all = 0, beyond = 0;
  for (const DistributionDistance& one : subject.comparison.distances)
    if (one.scene == subject.scene.name) {
      ++all;
      beyond += one.apart.distance > one.apart.critical ? 1 : 0;
    }
  return fmt::format("{} of {} distances from the exact distribution are beyond chance", beyond, all);
}

Series series_of(const Sample& sample, const std::string& block, std::size_t order) {
  const std::string plot = plot_of(block, style(sample.run));
  if (sample.run.exact()) return {"", "", {plot}, {}, {plot}};
  constexpr std::size_t pace = 9;  // a mark on every few steps tells sets of one solver apart
  return {run_label(sample.run),
          style_of(sample.run).colour,
          {plot, plot_of(block, fmt::format("every {}::{} {}", pace, 2 + 2 * order % pace,
                                            mark_style(sample.run, 1.2)))},
          {plot},
          {plot_of(block, fmt::format("with steps lw 1 lc rgb '{}'", context_colour))}};
}

void add_quantity(Sheet& sheet, const SceneSubject& subject, const Quantity& quantity,
                  const std::vector<Run>& runs) {
  const std::vector<Sample> samples = samples_of(runs, quantity.block);
  if (samples.empty()) return;
  Extent reach;
  for (const Sample& sample : samples)
    for (const double value : {sample.values.front(), sample.values.back()}) reach.add(value);
  reach = reach.wider(reach.high > reach.low ? 0.04 * (reach.high - reach.low) : 0.5);
  std::vector<Series> series;
  for (const Sample& sample : samples) {
    const std::string block = fmt::format("{}_{}", quantity.name, series.size());
    sheet.data(data_block(block, shares(sample.values, reach)));
    series.push_back(series_of(sample, block, series.size()));
  }
  const auto axes = [&](double width, double) {
    return linear_range("x", reach.low, reach.high, width) + "set yrange [-0.02:1.02]\nset ytics 0.2\n" +
           grid_lines;
  };
  add_series(sheet, {quantity.axis, "share of scenes", "share", true, axes, subject.height(320, 320), 84},
             series, are_many(runs));
}

/// Words over the row of a share, which stay inside the panel.
std::string label_of(const Run& run, const Share& share, std::size_t row, bool in_print) {
  const std::string count = fmt::format("{} of {}", share.toppled, share.of);
  const bool right = share.value() > 0.5 && !in_print;
  const double place = in_print ? 0.02 : right ? share.bounds().upper : share.bounds().lower;
  return fmt::format("set label {} noenhanced at {}, {} {} offset 0,0.9 font ',11' front\n",
                     in_quotes(run.exact() ? count
                                           : fmt::format("{}; {} as the exact {}", count, share.agree,
                                                         in_print ? "one" : "solution says")),
                     plain(place), row, right ? "right" : "left");
}

}  // namespace

Drawing distributions(const SceneSubject& subject) {
  const std::vector<Run> runs = perturbed_runs(subject.comparison, subject.scene.name);
  const auto look = [](const Run& run, std::size_t) {
    return run.exact() ? style(run) : mark_style(run, 1.6);
  };
  Sheet sheet = subject.sheet(legend_of(runs, look), answer(subject));
  for (const Quantity& quantity : quantities_of(subject.scene)) add_quantity(sheet, subject, quantity, runs);
  add_distances(sheet, subject, runs);
  return sheet.finish();
}

Drawing toppling(const SceneSubject& subject) {
  const std::vector<Run> runs = perturbed_runs(subject.comparison, subject.scene.name);
  const auto share_of = [&](const Run& run) {
    return toppled_share(*tallies_of(run), *tallies_of(runs.front()));
  };
  if (runs.empty() || !runs.front().exact() || share_of(runs.front()).of == 0)
    return subject.nothing("No exact answers over perturbed scenes to compare with.");
  const Share exact = share_of(runs.front());
  Sheet sheet = subject.sheet({}, fmt::format("By the exact solution {} of {}", exact.toppled, exact.of));
  std::string settings = fmt::format(
      "set object rectangle from {}, graph 0 to {}, graph 1 fillcolor rgb '#E6E6E6' fillstyle solid noborder behind\n",
      plain(exact.bounds().lower), plain(exact.bounds().upper));
  Plots plots(sheet, "share");
  std::vector<std::string> names;
  for (const Run& run : runs) {
    const Share share = share_of(run);
    if (share.of == 0) continue;
    const std::size_t row = names.size();
    plots.add({{share.value(), static_cast<double>(row), share.bounds().lower, share.bounds().upper}},
              {fmt::format("using 1:2:3:4 with xerrorbars lw 2 lc rgb '{}' pt 0", style_of(run).colour),
               "using 1:2 " + mark_style(run, 1.8)});
    settings += label_of(run, share, row, sheet.printed());
    names.push_back(run_label(run));
  }
  const auto rows = static_cast<double>(names.size());
  const RowWords beside = row_words(names, sheet);
  settings += fmt::format(
      "set xrange [0:1]\nset yrange [{}:-0.7]\n{}"
      "set grid x lt 1 dt solid lw 1 lc rgb '#E4E4E4'\nset xlabel 'share of scenes that topple'\n",
      rows - 0.5, beside.tics);
  sheet.row(52 * rows, 0, {{settings, plots.list()}}, 1, beside.left);
  sheet.note("bars: 95 % bounds of each share; grey: those of the exact one");
  return sheet.finish();
}

}  // namespace rockstack::plots
