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

/// One answer's sorted values of one quantity.
struct Sample {
  Run run;
  std::vector<double> values;
};

/// Of the peaks of a block, or with block 0 of the numbers of impacts.
std::vector<Sample> samples_of(const std::vector<Run>& runs, int block) {
  std::vector<Sample> samples;
  for (const Run& run : runs) {
    Sample sample{run, {}};
    for (const MotionTally& tally : *tallies_of(run))
      if (!tally.failed())
        sample.values.push_back(block > 0 ? tally.peaks.at(static_cast<std::size_t>(block) - 1)
                                          : tally.impacts);
    std::sort(sample.values.begin(), sample.values.end());
    if (!sample.values.empty()) samples.push_back(std::move(sample));
  }
  return samples;
}

struct Span {
  double from, to;
};

/// Of all values, with room on both sides.
Span span_of(const std::vector<Sample>& samples) {
  Span span{samples.front().values.front(), samples.front().values.back()};
  for (const Sample& sample : samples) {
    span.from = std::min(span.from, sample.values.front());
    span.to = std::max(span.to, sample.values.back());
  }
  const double room = span.to > span.from ? 0.04 * (span.to - span.from) : 0.5;
  return {span.from - room, span.to + room};
}

/// The share of values at or below, from one end of the panel to the other, as gnuplot's steps.
Curve shares(const std::vector<double>& values, const Span& span) {
  Curve curve{{span.from}, {0}};
  for (std::size_t i = 0; i < values.size(); ++i) {
    curve.times.push_back(values[i]);
    curve.values.push_back(static_cast<double>(i + 1) / static_cast<double>(values.size()));
  }
  curve.times.push_back(span.to);
  curve.values.push_back(1);
  return curve;
}

std::string style(const Run& run) {
  if (run.exact()) return "with steps lw 4 lc rgb '#000000'";
  const Style style = style_of(run);
  return fmt::format("with steps lw 2 lc rgb '{}' dt {}", style.colour, style.dash);
}

/// A mark on every few steps, which tells sets of one solver apart.
std::string marks_on(const std::string& block, const Run& run, std::size_t order) {
  constexpr std::size_t pace = 9;
  return fmt::format("${} using 1:2 every {}::{} {} notitle", block, pace, 2 + 2 * order % pace,
                     mark_style(run, 1.2));
}

const DistributionDistance* distance_of(const Comparison& comparison, const Run& run,
                                        const std::string& quantity) {
  for (const DistributionDistance& one : comparison.distances)
    if (one.run == run.run && one.quantity == quantity) return &one;
  return nullptr;
}

struct Quantity {
  std::string name, axis;
  int block = 0;  ///< 0: of the whole stack
};

std::vector<Quantity> quantities_of(const ComparedScene& scene) {
  std::vector<Quantity> list;
  for (int k = 1; k <= scene.blocks(); ++k)
    list.push_back({fmt::format("peak_{}", k), fmt::format("largest |{}| (rad)", angle_name(k)), k});
  list.push_back({"impacts", "impacts"});
  return list;
}

/// The distances of each run, a line a run under the panels.
void add_distances(Sheet& sheet, const Comparison& comparison, const ComparedScene& scene,
                   const std::vector<Run>& runs) {
  double critical = 0;
  for (const Run& run : runs) {
    std::string words;
    for (const auto& [name, axis, block] : quantities_of(scene))
      if (const DistributionDistance* one = distance_of(comparison, run, name); one != nullptr) {
        words += fmt::format("{} {:.2f} of {}", words.empty() ? ": D" : ",", one->apart.distance,
                             axis.substr(0, axis.find(" (")));
        critical = one->apart.critical;
      }
    if (!words.empty()) sheet.note(run_label(run) + words, style_of(run).colour);
  }
  if (critical > 0)
    sheet.note(fmt::format("by chance D is above {:.2f} once in twenty times", critical), "#000000");
}

/// How many of the distances are larger than chance makes them.
std::string answer(const Comparison& comparison, const ComparedScene& scene) {
  int all = 0, beyond = 0;
  for (const DistributionDistance& one : comparison.distances) {
    if (one.scene != scene.name) continue;
    ++all;
    beyond += one.apart.distance > one.apart.critical ? 1 : 0;
  }
  return fmt::format("{} of {} distances from the exact distribution are beyond chance", beyond, all);
}

Series series_of(const Sample& sample, const std::string& block, std::size_t order) {
  const std::string plot = fmt::format("${} using 1:2 {} notitle", block, style(sample.run));
  if (sample.run.exact()) return {"", "", {plot}, {}, {plot}};
  return {run_label(sample.run),
          style_of(sample.run).colour,
          {plot, marks_on(block, sample.run, order)},
          {plot},
          {fmt::format("${} using 1:2 with steps lw 1 lc rgb '{}' notitle", block, context_colour)}};
}

void add_quantity(Sheet& sheet, const Quantity& quantity, const std::vector<Run>& runs) {
  const std::vector<Sample> samples = samples_of(runs, quantity.block);
  if (samples.empty()) return;
  const Span span = span_of(samples);
  std::vector<Series> series;
  for (const Sample& sample : samples) {
    const std::string block = fmt::format("{}_{}", quantity.name, series.size());
    sheet.data(data_block(block, shares(sample.values, span)));
    series.push_back(series_of(sample, block, series.size()));
  }
  const auto axes = [&](double width, double) {
    return linear_range("x", span.from, span.to, width) + "set yrange [-0.02:1.02]\nset ytics 0.2\n" +
           grid_lines;
  };
  add_series(sheet, {quantity.axis, "share of scenes", "share", true, axes, 320, 84}, series, are_many(runs));
}

}  // namespace

Drawing distributions(const SceneSubject& subject) {
  const Comparison& comparison = subject.comparison;
  const ComparedScene& scene = subject.scene;
  const std::vector<Run> runs = perturbed_runs(comparison, scene.name);
  const auto look = [](const Run& run, std::size_t) {
    return run.exact() ? style(run) : mark_style(run, 1.6);
  };
  Sheet sheet = subject.sheet(legend_of(runs, look), answer(comparison, scene));
  for (const Quantity& quantity : quantities_of(scene)) add_quantity(sheet, quantity, runs);
  add_distances(sheet, comparison, scene, runs);
  return sheet.finish();
}

}  // namespace rockstack::plots
