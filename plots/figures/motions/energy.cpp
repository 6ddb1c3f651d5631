#include "plots/data/run_files.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// The energy of one engine run beside the exact one at the same times, and how far it is from that with what
/// its contacts have stored, J.
struct Energies {
  Run run;
  Curve exact, engine;
  Curve apart;  ///< the median of each stretch between exact impacts
};

/// The times of the exact impacts before an end, s, none nearer to the last than a part of the whole.
std::vector<double> stretches(const RunSelection& shown, double end) {
  std::vector<double> times;
  if (!shown.exact.empty())
    for (const Event& event : history_of(shown.exact.front())->events)
      if (event.kind == EventKind::impact && event.time < end) times.push_back(event.time);
  std::ranges::sort(times);
  constexpr double parts = 60;
  std::vector<double> kept{0};
  for (const double time : times)
    if (time - kept.back() > end / parts) kept.push_back(time);
  while (end - kept.back() > 4 * end / parts) kept.push_back(kept.back() + 2 * end / parts);
  kept.push_back(end);
  return kept;
}

/// The median of each stretch, as a level from its begin to its end: an engine that is a little late or early
/// is far off for a moment at each impact, which says nothing of its energy.
Curve medians(const std::vector<double>& times, const std::vector<double>& values,
              const std::vector<double>& bounds) {
  Curve levels;
  std::size_t i = 0;
  for (std::size_t k = 1; k < bounds.size(); ++k) {
    std::vector<double> inside;
    for (; i < times.size() && times[i] <= bounds[k]; ++i)
      if (std::isfinite(values[i])) inside.push_back(values[i]);
    if (inside.empty()) continue;
    levels.times.insert(levels.times.end(), {bounds[k - 1], bounds[k]});
    levels.values.insert(levels.values.end(), 2, median(std::move(inside)));
  }
  return levels;
}

Energies read_energies(const Run& run, const RunSelection& shown, const TimeAxis& axis, std::size_t bins) {
  const auto file = energies_of(run);
  std::vector<double> apart;
  for (std::size_t i = 0; i < file->times.size(); ++i)
    apart.push_back(file->balance[i] + file->input[i] - file->exact[i]);
  const double last = file->times.empty() ? axis.end : std::min(axis.end, std::max(file->times.back(), 1e-9));
  return {run, thin({file->times, file->exact}, axis, bins), thin({file->times, file->engine}, axis, bins),
          medians(file->times, apart, stretches(shown, last))};
}

std::string range_of(const std::vector<Curve>& curves, double height) {
  Extent reach{0, 0};
  for (const Curve& curve : curves)
    for (const double value : curve.values) reach.add(value);
  reach = reach.wider(std::max(0.06 * (reach.high - reach.low), 1e-9));
  return linear_range("y", reach.low, reach.high, height) + "set format y '%.5g'\n";
}

std::string answer(const std::vector<Energies>& all) {
  Extent largest;
  for (const Energies& one : all) largest.add(one.apart.largest());
  const auto text = [](double value) { return fmt::format("{:.3g}", value); };
  return fmt::format("Largest difference between impacts: {} J, by engine",
                     span_text(text(largest.low), text(largest.high)));
}

}  // namespace

Drawing energy(const SceneSubject& subject) {
  const RunSelection shown = subject.shown({"energy.csv"});
  if (shown.engines.empty()) return subject.nothing("No engine run of this scene tells its energy.");
  const bool many = are_many(shown.engines);
  const std::string in_grey = fmt::format("with lines lw 1 lc rgb '{}'", context_colour);
  Legend legend = legend_of(shown.engines, curve_style);
  legend.insert(legend.begin(), {exact_style, "exact"});
  if (many) legend.emplace_back(in_grey, "engines");
  const TimeAxis axis = subject.time_axis(all_runs(shown), legend);
  const std::vector<Energies> all = mapped(shown.engines, [&](const Run& run) {
    return read_energies(run, shown, axis, bins_for(3 * shown.engines.size()));
  });
  Sheet sheet = subject.sheet(legend, answer(all));
  const auto last = [](const Energies& one) { return one.exact.times.empty() ? 0 : one.exact.times.back(); };
  std::vector<Curve> levels{std::ranges::max_element(all, {}, last)->exact};
  sheet.data(data_block("exact", levels.front()));
  std::vector<std::string> plots;
  for (const Energies& one : all) {
    const std::string engine = fmt::format("engine_{}", plots.size());
    sheet.data(data_block(engine, one.engine));
    plots.push_back(plot_of(engine, many ? in_grey : curve_style(one.run, plots.size())));
    levels.push_back(one.engine);
  }
  DrawnPanel told{"time (s)", "energy (J)", false, {{"exact", "#1A1A1A", levels.front()}}};
  for (const Energies& one : all)
    told.curves.push_back({run_label(one.run), style_of(one.run).colour, one.engine});
  sheet.tell(std::move(told));
  plots.insert(plots.end(), {plot_of("exact", exact_style), exact_core("exact")});
  const std::string across = time_range(axis) + grid_lines;
  const double tall = subject.height(380, 640), low = subject.height(260, 640);
  sheet.panel(tall, 0,
              across + range_of(levels, tall) + without_horizontal_labels +
                  fmt::format("set ylabel 'energy{} (J)' offset 0\n", subject.on_slide ? "" : " above rest"),
              plots);
  const std::vector<Curve> differences = mapped(all, &Energies::apart);
  const auto axes = [&](double, double height) { return across + range_of(differences, height); };
  const char* apart = subject.on_slide ? "apart (J)" : "engine − exact (J)";
  SeriesPanel panel{"time (s)", "engine − exact, median (J)", apart, true, axes, low, 20};
  panel.under = {zero_line};
  add_curves(sheet, panel, shown.engines, differences, "apart", 2);
  return sheet.finish();
}

}  // namespace rockstack::plots
