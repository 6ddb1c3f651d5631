#include "plots/data/patterns.hpp"
#include "plots/data/run_files.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

constexpr double millimetres = 1e3;   // in a metre
constexpr double least_drawn = 1e-6;  // m: what blocks slip and part less is not drawn

/// A panel: one column of the histories, a curve a run; empty of runs that do not tell it.
struct SlipPanel {
  std::string words;  ///< of its axis
  double scale = 1;
  std::vector<Curve> curves = {};
};

/// A panel a block; its words have the block's number in their place.
std::vector<SlipPanel> read_panels(const std::vector<Run>& runs, std::vector<double> History::*rows,
                                   int blocks, const std::function<std::string(int)>& words, double scale,
                                   const TimeAxis& axis) {
  const std::size_t bins = bins_for(runs.size() * 2 * static_cast<std::size_t>(blocks));
  std::vector<SlipPanel> panels;
  for (int k = 0; k < blocks; ++k) {
    panels.push_back({words(k + 1), scale});
    for (const Run& run : runs) {
      const auto history = history_of(run);
      Curve& curve = panels.back().curves.emplace_back();
      if (((*history).*rows).empty()) continue;
      std::vector<double> values = column_of(*history, rows, k);
      for (double& value : values) value *= scale;
      curve = thin({history->times, std::move(values)}, axis, bins);
    }
  }
  return panels;
}

std::vector<SlipPanel> read_slips(const std::vector<Run>& runs, int blocks, const TimeAxis& axis) {
  const auto words = [](int number) { return fmt::format("slip {} (mm)", number); };
  return read_panels(runs, &History::slips, blocks, words, millimetres, axis);
}

/// One panel a quantity, all runs in each, or a panel each where they are many.
Drawing drawn(const SceneSubject& subject, const std::vector<Run>& runs,
              const std::vector<SlipPanel>& quantities, const std::string& answer) {
  Legend legend = legend_of(runs, curve_style);
  for (std::size_t i = 0; i < legend.size(); ++i)
    if (!runs[i].tells_slips()) legend[i].second += ", where nothing slips";
  const TimeAxis axis = subject.time_axis(runs, legend);
  Sheet sheet = subject.sheet(legend, answer);
  std::vector<GridPanel> grid;
  const double usual = panel_height(static_cast<int>(quantities.size())),
               height = subject.height(usual, usual * static_cast<double>(quantities.size()));
  for (std::size_t p = 0; p < quantities.size(); ++p) {
    const SlipPanel& quantity = quantities[p];
    const Extent extent = extent_of(runs, quantity.curves, 1, least_drawn * quantity.scale);
    const auto axes = [&axis, extent](double, double up) {
      return time_range(axis) + linear_range("y", extent.low, extent.high, up) + grid_lines;
    };
    const bool last = p + 1 == quantities.size();
    const SeriesPanel panel{"time (s)", quantity.words, quantity.words, last, axes, height};
    grid.push_back({panel, extent, quantity.curves, fmt::format("contact_{}", p)});
  }
  if (!are_many(runs) && !subject.on_slide && grid.size() >= two_columns)
    add_grid(sheet, std::move(grid), runs);
  else
    for (const GridPanel& one : grid) add_curves(sheet, one.panel, runs, one.curves, one.stem);
  return sheet.finish();
}

/// When an exact run's interfaces are apart: the first times in words, and how many more there are. Those
/// that no figure shows do not count.
std::string flights_of(const Run& run, int blocks, double end) {
  constexpr std::size_t reported = 2;
  const double shortest = end / 1000;
  const auto history = history_of(run);
  const std::vector<PatternSpan> spans = pattern_spans(*history);
  std::vector<std::string> times;
  for (int k = 0; k < blocks; ++k) {
    double from = -1;
    const auto close = [&](double to) {
      if (from >= 0 && to - from > shortest)
        times.push_back(fmt::format("interface {} from {:.3g} to {:.3g} s", k + 1, from, to));
      from = -1;
    };
    for (const PatternSpan& span : spans) {
      const bool apart = span.pattern[k] == Contact::apart;
      if (!apart) close(span.from);
      if (apart && from < 0) from = span.from;
    }
    if (!history->times.empty()) close(history->times.back());
  }
  if (times.empty()) return "nothing flies";
  const std::string more =
      times.size() > reported ? fmt::format(" and {} more", times.size() - reported) : "";
  times.resize(std::min(reported, times.size()));
  return "held while blocks are apart: " + joined_texts(times, std::identity(), ", ") + more;
}

/// Phrase on the slip of the whole motion.
std::string slip_phrase(const Run& run, int blocks) {
  const auto history = history_of(run);
  std::vector<double> slips;
  slips.reserve(static_cast<std::size_t>(blocks));
  for (int k = 0; k < blocks; ++k)
    slips.push_back(millimetres * largest_magnitude(column_of(*history, &History::slips, k)));
  const auto most = std::ranges::max_element(slips);
  return fmt::format("{:.3g} mm at interface {} ({})", *most, most - slips.begin() + 1, line_label(run));
}

}  // namespace

Drawing slip(const SceneSubject& subject) {
  const ComparedScene& scene = subject.scene;
  std::vector<Run> runs = all_runs(subject.shown());
  std::erase_if(runs, [](const Run& run) { return !run.tells_slips(); });
  const TimeAxis axis = subject.time_axis(runs);
  std::vector<SlipPanel> panels = read_slips(runs, scene.block_count(), axis);
  const bool exact = runs.front().exact();
  std::string answer = (exact ? "At most: " : "At most, without an exact motion: ") +
                       slip_phrase(runs.front(), scene.block_count());
  if (exact) answer += "; " + flights_of(runs.front(), scene.block_count(), axis.end);
  const auto words = [](int number) { return fmt::format("gap {} (mm)", number); };
  const auto gaps = read_panels(runs, &History::gaps, scene.block_count(), words, millimetres, axis);
  panels.insert(panels.end(), gaps.begin(), gaps.end());
  const auto is_still = [&](const SlipPanel& panel) {
    return std::ranges::all_of(
        panel.curves, [](const Curve& curve) { return curve.largest() <= least_drawn * millimetres; });
  };
  panels.erase(std::remove_if(panels.begin() + 1, panels.end(), is_still), panels.end());
  return drawn(subject, runs, panels, answer);
}

Drawing friction(const SceneSubject& subject) {
  const ComparedScene& scene = subject.scene;
  std::vector<Run> runs;
  for (const Run& run : done_runs(subject.comparison, scene.name))
    if (run.exact() || run.has_own_friction()) runs.push_back(run);
  const auto words = [](int number) { return angle_name(number) + " (rad)"; };
  const TimeAxis axis = subject.time_axis(runs);
  std::vector<SlipPanel> panels = read_panels(runs, &History::angles, scene.block_count(), words, 1, axis);
  for (SlipPanel& panel : panels) {
    const Extent extent = extent_of(runs, panel.curves, 1, 0);
    const AngleUnit unit = subject.unit(std::max(std::abs(extent.low), std::abs(extent.high)));
    panel.words.replace(panel.words.find("rad"), panel.words.npos, std::string(unit.name) + ")");
    panel.scale = unit.scale;
    plots::scale(panel.curves, unit.scale);
  }
  const std::vector<SlipPanel> slips = read_slips(runs, scene.block_count(), axis);
  panels.insert(panels.end(), slips.begin(), slips.end());
  std::vector<std::vector<Curve>*> curves;
  curves.reserve(panels.size());
  for (SlipPanel& panel : panels) curves.push_back(&panel.curves);
  const std::vector<std::string> hidden = take_out_hidden(runs, curves);
  std::string answer = "Largest slips: ";
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (runs[i].tells_slips())
      answer += slip_phrase(runs[i], scene.block_count()) + (i + 1 < runs.size() ? "; " : "");
  if (!hidden.empty())
    answer += "; on the exact motion, left out: " + joined_texts(hidden, std::identity(), ", ");
  return drawn(subject, runs, panels, answer);
}

}  // namespace rockstack::plots
