#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "comparisons/measures/results/csv.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

bool by_size(double one, double other) {
  return std::abs(one) < std::abs(other);
}

/// A mark on the largest absolute value, and its words in the panel's other right corner.
std::string peak_mark(const Curve& curve, std::size_t peak) {
  constexpr auto colour = "#B03A00";
  const double value = curve.values[peak];
  return fmt::format(
      "set label '' at {}, {} point pt 6 ps 1.4*mark lc rgb '{}' front\n"
      "set label {} noenhanced at graph 0.985, graph {} right textcolor rgb '{}' front font ',12'\n",
      plain(curve.times[peak]), plain(value), colour,
      in_quotes(fmt::format("{:.4g} m/s² at {:.4g} s", value, curve.times[peak])), value > 0 ? 0.1 : 0.9,
      colour);
}

void add_axis(Sheet& sheet, const std::string& name, const Curve& curve, const TimeAxis& axis, bool last) {
  const auto peak = static_cast<std::size_t>(
      std::max_element(curve.values.begin(), curve.values.end(), by_size) - curve.values.begin());
  const double reach = 1.12 * std::max(std::abs(curve.values[peak]), 1e-12);
  sheet.data(data_block(name, thin(curve, bins_for(2))));
  sheet.panel(220, 16,
              "set grid lt 1 dt solid lw 1 lc rgb '#DADADA'\n" + time_range(axis) +
                  fmt::format("set yrange [{}:{}]\nset ylabel '{} (m/s²)' offset 0.5\n", plain(-reach),
                              plain(reach), name) +
                  (last ? "set format x '%g'\nset xlabel 'time (s)'\n" : without_horizontal_labels()) +
                  peak_mark(curve, peak),
              {fmt::format("${} using 1:2 with lines lw 1.5 lc rgb '#0B4F8A' notitle", name)});
}

}  // namespace

Drawing ground_motion(const SceneSubject& subject) {
  const ComparedScene& scene = subject.scene;
  const auto columns = read_columns(scene.ground_motion, {"time", "horizontal", "vertical"});
  const auto moves = [](const std::vector<double>& values) {
    return std::any_of(values.begin(), values.end(), [](double value) { return value != 0; });
  };
  if (!moves(columns[1]) && !moves(columns[2])) return subject.nothing("the ground stands still");
  double peak = 0;
  for (const auto* axis : {&columns[1], &columns[2]})
    for (const double value : *axis) peak = std::max(peak, std::abs(value));
  const double end = columns[0].back();
  const TimeAxis axis =
      scene.horizon() < scene.duration ? TimeAxis{end, scene.horizon()} : TimeAxis{.end = end};
  Legend legend;
  explain_shade(axis, legend);
  Sheet sheet = subject.sheet(
      legend, fmt::format("At most {:.4g} m/s², {:.3g} times gravity", peak, peak / scene.gravity));
  const bool vertical = moves(columns[2]);
  if (moves(columns[1])) add_axis(sheet, "horizontal", {columns[0], columns[1]}, axis, !vertical);
  if (vertical) add_axis(sheet, "vertical", {columns[0], columns[2]}, axis, true);
  return sheet.finish();
}

}  // namespace rockstack::plots
