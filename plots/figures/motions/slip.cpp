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
  std::vector<Curve> curves;
};

SlipPanel read_quantity(const std::vector<Run>& runs, std::vector<double> History::*rows, int block,
                        const std::string& words, double scale, std::size_t bins) {
  SlipPanel quantity{words, scale, {}};
  for (const Run& run : runs) {
    const auto history = history_of(run);
    Curve& curve = quantity.curves.emplace_back();
    if (((*history).*rows).empty()) continue;
    std::vector<double> values = column_of(*history, rows, block);
    for (double& value : values) value *= scale;
    curve = thin({history->times, std::move(values)}, bins);
  }
  return quantity;
}

std::vector<SlipPanel> read_slips(const std::vector<Run>& runs, int blocks, std::size_t bins) {
  std::vector<SlipPanel> slips;
  slips.reserve(static_cast<std::size_t>(blocks));
  for (int k = 0; k < blocks; ++k)
    slips.push_back(
        read_quantity(runs, &History::slips, k, fmt::format("slip {} (mm)", k + 1), millimetres, bins));
  return slips;
}

double last_time(const std::vector<SlipPanel>& quantities) {
  double end = 1e-9;
  for (const SlipPanel& quantity : quantities)
    for (const Curve& curve : quantity.curves)
      if (curve.size() > 0) end = std::max(end, curve.times.back());
  return end;
}

/// One panel a quantity, all runs in each, or a panel each where they are many.
Drawing drawn(const SceneSubject& subject, const std::vector<Run>& runs,
              const std::vector<SlipPanel>& quantities, const std::string& answer) {
  Legend legend = legend_of(runs, curve_style);
  for (std::size_t i = 0; i < legend.size(); ++i)
    if (!tells_slips(runs[i])) legend[i].second += ", where nothing slips";
  const TimeAxis axis = subject.time_axis(runs, legend);
  Sheet sheet = subject.sheet(legend, answer);
  const double usual = panel_height(static_cast<int>(quantities.size()));
  for (std::size_t p = 0; p < quantities.size(); ++p) {
    const SlipPanel& quantity = quantities[p];
    const Reach extent = extent_of(runs, quantity.curves, 1, least_drawn * quantity.scale);
    const auto axes = [&](double, double height) {
      return time_range(axis) + linear_range("y", extent.low, extent.high, height) + grid_lines;
    };
    const SeriesPanel panel{
        "time (s)",     quantity.words,
        quantity.words, p + 1 == quantities.size(),
        axes,           subject.height(usual, usual * static_cast<double>(quantities.size()))};
    add_curves(sheet, panel, runs, quantity.curves, fmt::format("contact_{}", p));
  }
  return sheet.finish();
}

/// When an exact run's interfaces are apart: the first times in words, and how many more there are. Those
/// that no figure shows do not count.
std::string flights_of(const Run& run, int blocks, double end) {
  constexpr std::size_t reported = 2;
  const double shortest = end / 1000;
  const std::vector<PatternSpan> spans = pattern_spans(*history_of(run));
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
    close(end);
  }
  if (times.empty()) return "nothing flies";
  const std::string more =
      times.size() > reported ? fmt::format(" and {} more", times.size() - reported) : "";
  times.resize(std::min(reported, times.size()));
  return "apart: " + text_of_each(times, std::identity(), ", ") + more;
}

/// The largest slip of a run, and at which interface.
std::string slip_phrase(const std::vector<Run>& runs, std::size_t run, const std::vector<SlipPanel>& slips) {
  const auto largest = [&](const SlipPanel& slip) { return slip.curves[run].largest(); };
  const auto most = std::ranges::max_element(slips, {}, largest);
  return fmt::format("{:.3g} mm at interface {} ({})", largest(*most), most - slips.begin() + 1,
                     line_label(runs[run]));
}

std::string slip_answer(const std::vector<Run>& runs, const std::vector<SlipPanel>& slips) {
  const bool exact = runs.front().exact();
  std::string text =
      (exact ? "At most: " : "At most, without an exact motion: ") + slip_phrase(runs, 0, slips);
  if (exact) text += "; " + flights_of(runs.front(), static_cast<int>(slips.size()), last_time(slips));
  return text;
}

std::size_t bins_of(const std::vector<Run>& runs, int blocks) {
  return bins_for(runs.size() * 2 * static_cast<std::size_t>(blocks));
}

}  // namespace

Drawing slip(const SceneSubject& subject) {
  const ComparedScene& scene = subject.scene;
  std::vector<Run> runs = all_runs(subject.shown());
  std::erase_if(runs, [](const Run& run) { return !tells_slips(run); });
  const std::size_t bins = bins_of(runs, scene.blocks());
  std::vector<SlipPanel> panels = read_slips(runs, scene.blocks(), bins);
  const std::string answer = slip_answer(runs, panels);
  for (int k = 0; k < scene.blocks(); ++k)
    panels.push_back(
        read_quantity(runs, &History::gaps, k, fmt::format("gap {} (mm)", k + 1), millimetres, bins));
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
    if (run.exact() || has_own_friction(run)) runs.push_back(run);
  const std::size_t bins = bins_of(runs, scene.blocks());
  std::vector<SlipPanel> panels;
  panels.reserve(2 * static_cast<std::size_t>(scene.blocks()));
  for (int k = 0; k < scene.blocks(); ++k)
    panels.push_back(read_quantity(runs, &History::angles, k, angle_name(k + 1) + " (rad)", 1, bins));
  const std::vector<SlipPanel> slips = read_slips(runs, scene.blocks(), bins);
  panels.insert(panels.end(), slips.begin(), slips.end());
  std::string answer = "Largest slips: ";
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (tells_slips(runs[i])) answer += slip_phrase(runs, i, slips) + (i + 1 < runs.size() ? "; " : "");
  return drawn(subject, runs, panels, answer);
}

}  // namespace rockstack::plots
