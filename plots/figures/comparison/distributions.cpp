#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "comparisons/results/csv.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

/// One answer's sorted values of one quantity.
struct Sample {
  Run run;
  std::vector<double> values;
};

std::vector<Sample> samples_of(const Shown& shown, const std::string& quantity) {
  std::vector<Sample> samples;
  for (const std::vector<Run>& runs : {shown.exact, shown.engines})
    for (const Run& run : runs) {
      const auto file = run.folder / "perturbed.csv";
      if (!std::filesystem::exists(file)) continue;
      Sample sample{run, read_columns(file, {quantity}).front()};
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

std::string style(const Run& run, const Styles& styles) {
  if (run.exact()) return "with steps lw 4 lc rgb '#000000'";
  const Style& style = styles.at(solver_name(run));
  return fmt::format("with steps lw 2 lc rgb '{}' dt {}", style.colour,
                     dash_of(style, run.settings, style.dash));
}

/// The distances of one quantity as a line above its panel.
std::string distance_line(const Comparison& comparison, const std::vector<Sample>& samples,
                          const std::string& quantity) {
  std::string label;
  for (const Sample& sample : samples)
    for (const Distance& one : comparison.distances) {
      if (one.run != sample.run.name || one.quantity != quantity) continue;
      if (label.empty())
        label = fmt::format("D, above {:.2f} once in twenty times by chance: ", one.critical);
      else
        label += ", ";
      const std::string& settings = sample.run.settings;
      label += fmt::format("{}{} {:.2f}", solver_name(sample.run),
                           settings.substr(std::min(settings.find('+'), settings.size())), one.distance);
    }
  return label.empty()
             ? ""
             : "set label " + in_quotes(label) + " noenhanced at graph 0, graph 1.05 left font ',11'\n";
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

}  // namespace

Drawing distributions(const Comparison& comparison, const ComparedScene& scene, const Styles& styles) {
  const Shown shown = shown_runs(comparison, scene.name);
  Legend legend;
  for (const Sample& sample : samples_of(shown, "impacts"))
    legend.emplace_back(style(sample.run, styles), run_label(sample.run));
  Sheet sheet(heading(scene), legend);
  for (const auto& [name, axis] : quantities_of(scene)) {
    const std::vector<Sample> samples = samples_of(shown, name);
    if (samples.empty()) continue;
    const Span span = span_of(samples);
    std::vector<std::string> plots;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const std::string block = fmt::format("{}_{}", name, i);
      sheet.data(data_block(block, shares(samples[i].values, span)));
      plots.push_back(fmt::format("${} using 1:2 {} notitle", block, style(samples[i].run, styles)));
    }
    sheet.panel(
        300, 110,
        fmt::format("set grid lt 1 dt solid lw 1 lc rgb '#E4E4E4'\nset xrange [{}:{}]\n"
                    "set yrange [-0.02:1.02]\nset ytics 0.2\nset xlabel {}\nset ylabel 'share of scenes'\n",
                    plain(span.from), plain(span.to), in_quotes(axis)) +
            distance_line(comparison, samples, name),
        plots);
  }
  return sheet.finish();
}

}  // namespace rockstack::plots
