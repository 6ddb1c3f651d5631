#include "comparisons/measures/results/csv.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

constexpr double least_variation = 1e-3;  // of the weight above: what forces vary less by is not drawn

/// A panel: one force of one interface, a curve a run.
struct ForcePanel {
  std::string words;  ///< of its axis
  std::vector<Curve> curves = {};
};

/// What the interfaces of a run bear, as shares of the weight above each: N of each, then T.
std::vector<Curve> forces_of(const Run& run, const std::vector<double>& weights) {
  const auto blocks = static_cast<int>(weights.size());
  std::vector<std::string> names{"time"};
  for (const char* stem : {"normal_", "tangential_"})
    for (const std::string& name : numbered(stem, blocks)) names.push_back(name);
  std::vector<std::vector<double>> columns = read_columns(run.folder / "reactions.csv", names);
  std::vector<Curve> curves;
  for (std::size_t c = 1; c < columns.size(); ++c) {
    for (double& force : columns[c]) force /= weights[(c - 1) % weights.size()];
    curves.push_back({columns[0], std::move(columns[c])});
  }
  return curves;
}

/// Weight of each block with all above it, N.
std::vector<double> weights_of(const ComparedScene& scene) {
  std::vector<double> weights(scene.blocks.size());
  double sum = 0;
  for (std::size_t k = weights.size(); k-- > 0;) weights[k] = sum += scene.blocks[k].mass * scene.gravity;
  return weights;
}

/// Both forces of each interface in turn.
std::vector<ForcePanel> read_panels(const std::vector<Run>& runs, const ComparedScene& scene,
                                    const TimeAxis& axis) {
  const std::size_t blocks = scene.blocks.size(), bins = bins_for(2 * blocks * runs.size());
  std::vector<ForcePanel> panels;
  for (std::size_t k = 1; k <= blocks; ++k)
    for (const char* force : {"normal", "along"})
      panels.push_back({fmt::format("{} {} (weights)", force, k)});
  for (const Run& run : runs) {
    const std::vector<Curve> curves = forces_of(run, weights_of(scene));
    for (std::size_t p = 0; p < panels.size(); ++p)
      panels[p].curves.push_back(thin(curves[p / 2 + (p % 2) * blocks], axis, bins));
  }
  return panels;
}

/// What engines' rows say of a number, as a span in percent; empty where none does.
std::string percent_span(const std::vector<Run>& engines, std::optional<double> RunMetrics::*number) {
  Extent reach;
  for (const Run& run : engines)
    if (run.*number) reach.add(100 * std::abs(*(run.*number)));
  if (!(reach.low <= reach.high)) return "";
  const auto text = [](double value) { return fmt::format("{:.2g}", value); };
  return span_text(text(reach.low), text(reach.high)) + " %";
}

/// An impact's normal impulse in both motions, N·s.
struct Impulse {
  double number, exact, engine;
};

struct Impulses {
  Run run;
  std::vector<Impulse> impacts;
};

Impulses impulses_of(const Run& run) {
  const auto columns = read_columns(run.folder / "impulses.csv", {"number", "exact_normal", "engine_normal"});
  Impulses impulses{run, {}};
  for (std::size_t i = 0; i < columns[0].size(); ++i)
    impulses.impacts.push_back({columns[0][i], columns[1][i], columns[2][i]});
  return impulses;
}

constexpr double drawn_percent = 100;  // where marks beyond stand on the edge

/// By how much more an engine's impulses are than the exact ones, in percent of these.
Curve excess_of(const Impulses& one, double aside) {
  Curve curve;
  for (const Impulse& impact : one.impacts) {
    const double percent = 100 * (impact.engine / impact.exact - 1);
    curve.add(impact.number + aside, std::clamp(percent, -drawn_percent, drawn_percent));
  }
  return curve;
}

std::string number_range(double last) {
  return fmt::format("set xrange [0.4:{}]\nset xtics {}\n", plain(last + 0.6),
                     std::max(1, static_cast<int>(last / 8))) +
         grid_lines;
}

}  // namespace

Drawing forces(const SceneSubject& subject) {
  const ComparedScene& scene = subject.scene;
  const RunSelection shown = subject.shown({"reactions.csv"});
  std::vector<Run> runs = all_runs(shown);
  std::erase_if(runs, [](const Run& run) { return !fs::exists(run.folder / "reactions.csv"); });
  if (runs.empty()) return subject.nothing("No run of this scene tells its forces.");
  Legend legend = legend_of(runs, curve_style);
  const TimeAxis axis = subject.time_axis(runs, legend);
  const std::vector<ForcePanel> panels = read_panels(runs, scene, axis);
  const std::string off = percent_span(shown.engines, &RunMetrics::normal_force_error);
  Sheet sheet = subject.sheet(
      legend,
      off.empty() ? "" : "Between impacts normal forces are off by " + off + " of the weight above, RMS");
  const double usual = panel_height(static_cast<int>(panels.size())),
               height = subject.height(usual, usual * static_cast<double>(panels.size()));
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Extent extent = extent_of(runs, panels[p].curves, 0.5, least_variation);
    const auto axes = [&](double, double up) {
      return time_range(axis) + linear_range("y", extent.low, extent.high, up) + grid_lines;
    };
    const bool last = p + 1 == panels.size();
    const SeriesPanel panel{"time (s)", panels[p].words, panels[p].words, last, axes, height};
    add_curves(sheet, panel, runs, panels[p].curves, fmt::format("force_{}", p));
  }
  return sheet.finish();
}

Drawing impulses(const SceneSubject& subject) {
  std::vector<Impulses> all = mapped(subject.shown({"impulses.csv"}).engines, impulses_of);
  std::erase_if(all, [](const Impulses& one) { return one.impacts.empty(); });
  if (all.empty()) return subject.nothing("No impact that an engine which tells its forces has too.");
  std::map<double, double> exact;
  for (const Impulses& one : all)
    for (const Impulse& impact : one.impacts) exact[impact.number] = impact.exact;
  Curve curve;
  for (const auto& [number, impulse] : exact) curve.add(number, impulse);
  const double last = curve.times.back(), largest = curve.largest();
  std::vector<Series> series;
  std::string data = data_block("exact", curve);
  double widest = 1;
  for (const Impulses& one : all) {
    const Curve excess = excess_of(one, aside(series.size(), all.size()));
    const std::string name = fmt::format("impulse_{}", series.size());
    data += data_block(name, excess);
    widest = std::max(widest, excess.largest());
    series.push_back(mark_series(one.run, name, 1.6));
  }
  const std::vector<Run> runs = mapped(all, &Impulses::run);
  Sheet sheet =
      subject.sheet(mark_legend(runs, 1.6), "Off by " + percent_span(runs, &RunMetrics::impulse_error) +
                                                " of all exact impulses, RMS");
  sheet.data(data);
  const double high = subject.height(200, 530);
  sheet.panel(high, 0,
              number_range(last) + without_horizontal_labels + linear_range("y", 0, 1.1 * largest, high) +
                  "set ylabel 'exact impulse (N s)'\n",
              {"$exact using 1:2 with impulses lw 3 lc rgb '#9A9A9A' notitle",
               "$exact using 1:2 with points pt 7 ps 1.1*mark lc rgb '#000000' notitle"});
  const double edge = 1.08 * widest;
  const auto axes = [&](double, double up) {
    return number_range(last) + linear_range("y", -edge, edge, up);
  };
  SeriesPanel panel{"number of the exact impact", "engine gives more (%)", "gives more (%)", true, axes,
                    subject.height(330, 530)};
  panel.under = {zero_line};
  add_series(sheet, panel, series, all.size() > most_series);
  return sheet.finish();
}

}  // namespace rockstack::plots
