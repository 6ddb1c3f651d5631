#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "comparisons/measures/results/csv.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

/// One answer's sorted values of one quantity.
struct Sample {
  Run run;
  std::vector<double> values;
};

std::vector<Sample> samples_of(const std::vector<Run>& runs, const std::string& quantity) {
  std::vector<Sample> samples;
  for (const Run& run : runs) {
    Sample sample{run, read_columns(run.folder / "perturbed.csv", {quantity}).front()};
    std::erase_if(sample.values, [](double value) { return std::isnan(value); });
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

const Distance* distance_of(const Comparison& comparison, const Run& run, const std::string& quantity) {
  for (const Distance& one : comparison.distances)
    if (one.run == run.name && one.quantity == quantity) return &one;
  return nullptr;
}

struct Quantity {
  std::string name, axis;
};

std::vector<Quantity> quantities_of(const ComparedScene& scene) {
  std::vector<Quantity> list;
  for (int k = 1; k <= scene.blocks; ++k)
    list.push_back({fmt::format("peak_{}", k), fmt::format("largest |{}| (rad)", angle_name(k))});
  list.push_back({"impacts", "impacts"});
  return list;
}

/// The distances of each run, a line a run under the panels.
void add_distances(Sheet& sheet, const Comparison& comparison, const ComparedScene& scene,
                   const std::vector<Run>& runs) {
  double critical = 0;
  for (const Run& run : runs) {
    std::string words;
    for (const auto& [name, axis] : quantities_of(scene))
      if (const Distance* one = distance_of(comparison, run, name); one != nullptr) {
        words += fmt::format("{} {:.2f} of {}", words.empty() ? ": D" : ",", one->distance,
                             axis.substr(0, axis.find(" (")));
        critical = one->critical;
      }
    if (!words.empty()) sheet.note(run_label(run) + words, style_of(run).colour);
  }
  if (critical > 0)
    sheet.note(fmt::format("by chance D is above {:.2f} once in twenty times", critical), "#000000");
}

/// How many of the distances are larger than chance makes them.
std::string question(const Comparison& comparison, const ComparedScene& scene) {
  int all = 0, beyond = 0;
  for (const Distance& one : comparison.distances) {
    if (one.scene != scene.name) continue;
    ++all;
    beyond += one.distance > one.critical ? 1 : 0;
  }
  return fmt::format(
      "Are engines right on the whole? {} of {} distances from the exact distribution are beyond "
      "chance",
      beyond, all);
}

std::string block_of(const std::string& quantity, std::size_t i) {
  return fmt::format("{}_{}", quantity, i);
}

void add_panel(Sheet& sheet, const Quantity& quantity, const std::vector<Sample>& samples,
               const std::string& settings) {
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::string block = block_of(quantity.name, i);
    plots.push_back(fmt::format("${} using 1:2 {} notitle", block, style(samples[i].run)));
    if (!samples[i].run.exact()) plots.push_back(marks_on(block, samples[i].run, i));
  }
  sheet.panel(
      320, 84,
      settings + fmt::format("set xlabel {}\nset ylabel 'share of scenes'\n", in_quotes(quantity.axis)),
      plots);
}

/// A panel an engine's run, beside the exact distribution and over those of the others.
void add_small_panels(Sheet& sheet, const Quantity& quantity, const std::vector<Sample>& samples,
                      const std::string& settings) {
  std::vector<Multiple> series;
  std::vector<std::string> context;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (!samples[i].run.exact())
      context.push_back(fmt::format("${} using 1:2 with steps lw 1 lc rgb '{}' notitle",
                                    block_of(quantity.name, i), context_colour));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::string plot =
        fmt::format("${} using 1:2 {} notitle", block_of(quantity.name, i), style(samples[i].run));
    if (samples[i].run.exact())
      context.push_back(plot);
    else
      series.push_back({run_label(samples[i].run), style_of(samples[i].run).colour, {plot}});
  }
  add_multiples(sheet, series, context, settings, quantity.axis, "share");
}

}  // namespace

Drawing distributions(const Comparison& comparison, const ComparedScene& scene) {
  const std::vector<Run> runs = perturbed_runs(comparison, scene.name);
  const bool many = runs.size() > most_series + 1;
  Legend legend;
  for (const Run& run : runs)
    if (!many || run.exact())
      legend.emplace_back(run.exact() ? style(run) : mark_style(run, 1.6), run_label(run));
  Sheet sheet(heading(scene), legend, question(comparison, scene));
  for (const Quantity& quantity : quantities_of(scene)) {
    const std::vector<Sample> samples = samples_of(runs, quantity.name);
    if (samples.empty()) continue;
    const Span span = span_of(samples);
    for (std::size_t i = 0; i < samples.size(); ++i)
      sheet.data(data_block(block_of(quantity.name, i), shares(samples[i].values, span)));
    const std::string settings = fmt::format("set xrange [{}:{}]\nset yrange [-0.02:1.02]\nset ytics 0.2\n",
                                             plain(span.from), plain(span.to)) +
                                 linear_tics("x", span.from, span.to, many ? multiple_width : 1056) +
                                 grid_lines;
    if (many)
      add_small_panels(sheet, quantity, samples, settings);
    else
      add_panel(sheet, quantity, samples, settings);
  }
  add_distances(sheet, comparison, scene, runs);
  return sheet.finish();
}

}  // namespace rockstack::plots
