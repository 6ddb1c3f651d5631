#include "plots/figures/contact/slip.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "comparisons/measures/results/csv.hpp"
#include "plots/data/contacts.hpp"
#include "plots/data/events.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"

namespace rockstack::plots {
namespace {

constexpr double millimetres = 1e3;  // in a metre
constexpr double least = 1e-6;       // m: what blocks slip and part less is not drawn

/// A panel: one column of the histories.
struct Quantity {
  std::string column;  ///< of history.csv
  std::string words;   ///< of its axis
  double scale = 1;
};

/// The curve of one run in one panel.
struct Trace {
  Run run;
  Curve curve;
};

struct Panel {
  Quantity quantity;
  std::vector<Trace> traces;  ///< of the runs that tell it
};

Panel read_panel(const Quantity& quantity, const std::vector<Run>& runs, std::size_t bins) {
  Panel panel{quantity, {}};
  for (const Run& run : runs) {
    if (!has_column(run, quantity.column)) continue;
    std::vector<std::vector<double>> columns =
        read_columns(run.folder / "history.csv", {"time", quantity.column});
    for (double& value : columns[1]) value *= quantity.scale;
    panel.traces.push_back({run, thin({std::move(columns[0]), std::move(columns[1])}, bins)});
  }
  return panel;
}

bool tells_slips(const Run& run) {
  return has_column(run, "slip_1");
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(const Curve& curve) {
    for (const double value : curve.values) low = std::min(low, value), high = std::max(high, value);
  }
  bool empty() const { return low > high; }
};

/// All curves, but where an exact one is among them no more than its own span beyond it: an engine whose
/// blocks slide away must not flatten the rest.
Range range_of(const Panel& panel) {
  Range all, exact;
  for (const Trace& trace : panel.traces) {
    all.add(trace.curve);
    if (trace.run.exact()) exact.add(trace.curve);
  }
  if (const double span = exact.high - exact.low; !exact.empty() && span > least * panel.quantity.scale)
    all = {std::max(all.low, exact.low - span), std::min(all.high, exact.high + span)};
  if (all.empty()) all = {0, 0};
  const double margin = std::max(0.08 * (all.high - all.low), least * panel.quantity.scale);
  return {all.low - margin, all.high + margin};
}

double last_time(const std::vector<Panel>& panels) {
  double end = 1e-9;
  for (const Panel& panel : panels)
    for (const Trace& trace : panel.traces)
      if (!trace.curve.times.empty()) end = std::max(end, trace.curve.times.back());
  return end;
}

std::string data_name(std::size_t panel, std::size_t trace) {
  return fmt::format("contact_{}_{}", panel, trace);
}

/// The place of a run among all, which sets its marks apart in every panel alike.
std::size_t order_of(const Run& run, const std::vector<Run>& runs) {
  const auto same = [&](const Run& other) { return other.name == run.name; };
  return static_cast<std::size_t>(std::find_if(runs.begin(), runs.end(), same) - runs.begin());
}

std::vector<std::string> curves_of(const Panel& panel, std::size_t number, const std::vector<Run>& runs) {
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < panel.traces.size(); ++i) {
    const Run& run = panel.traces[i].run;
    if (panel.traces[i].curve.times.empty()) continue;
    plots.push_back(
        fmt::format("${} using 1:2 {} notitle", data_name(number, i), curve_style(run, order_of(run, runs))));
  }
  return plots;
}

std::string settings_of(const Panel& panel, double end, bool lowest, double height) {
  const Range range = range_of(panel);
  return fmt::format("set xrange [0:{}]\nset yrange [{}:{}]\n", plain(end), plain(range.low),
                     plain(range.high)) +
         linear_tics("y", range.low, range.high, height) + grid_lines +
         (lowest ? "set format x '%g'\nset xlabel 'time (s)'\n" : without_horizontal_labels()) +
         fmt::format("set ylabel '{}' offset 0.5\n", panel.quantity.words);
}

/// A panel a run, over the exact curve.
void add_small_panels(Sheet& sheet, const Panel& panel, std::size_t number, double end) {
  std::vector<std::string> context;
  std::vector<Multiple> series;
  for (std::size_t i = 0; i < panel.traces.size(); ++i) {
    const Run& run = panel.traces[i].run;
    const std::string data = "$" + data_name(number, i) + " using 1:2 with lines ";
    const std::string colour = style_of(run).colour;
    if (run.exact())
      context.push_back(data + "lw 3 lc rgb '#BDBDBD' notitle");
    else
      series.push_back({line_label(run), colour, {data + fmt::format("lw 1.5 lc rgb '{}' notitle", colour)}});
  }
  const Range range = range_of(panel);
  add_multiples(sheet, series, context,
                fmt::format("set xrange [0:{}]\nset yrange [{}:{}]\n", plain(end), plain(range.low),
                            plain(range.high)) +
                    linear_tics("y", range.low, range.high, multiple_height) + grid_lines,
                "time (s)", panel.quantity.words);
}

/// One panel a quantity, all runs in each, or a panel each where they are many.
Drawing drawn(const ComparedScene& scene, const std::vector<Run>& runs, const std::vector<Panel>& panels,
              const std::string& question) {
  const bool many = runs.size() > most_series + 1;
  Legend legend;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (!many || runs[i].exact())
      legend.emplace_back(curve_style(runs[i], i),
                          run_label(runs[i]) + (tells_slips(runs[i]) ? "" : ", where nothing slips"));
  Sheet sheet(heading(scene), legend, question);
  const double end = last_time(panels), height = panel_height(static_cast<int>(panels.size()));
  for (std::size_t p = 0; p < panels.size(); ++p) {
    for (std::size_t i = 0; i < panels[p].traces.size(); ++i)
      sheet.data(data_block(data_name(p, i), panels[p].traces[i].curve));
    if (many)
      add_small_panels(sheet, panels[p], p, end);
    else
      sheet.panel(height, 16, settings_of(panels[p], end, p + 1 == panels.size(), height),
                  curves_of(panels[p], p, runs));
  }
  return sheet.finish();
}

double largest_of(const Run& run, const Panel& panel) {
  double most = 0;
  for (const Trace& trace : panel.traces)
    if (trace.run.name == run.name)
      for (const double value : trace.curve.values) most = std::max(most, std::abs(value));
  return most;
}

/// When an exact run's interfaces are apart: the first times in words, and how many more there are. Those
/// that no figure shows do not count.
std::string flights_of(const Run& run, int blocks, double end) {
  constexpr std::size_t told = 2;
  const double shortest = end / 1000;
  std::vector<std::string> times;
  for (int k = 0; k < blocks; ++k) {
    double from = -1;
    const auto close = [&](double to) {
      if (from >= 0 && to - from > shortest)
        times.push_back(fmt::format("interface {} from {:.3g} to {:.3g} s", k + 1, from, to));
      from = -1;
    };
    for (const PatternSpan& span : read_events(run, blocks, end, starting_pattern(run)).spans) {
      const bool apart = contacts_in(span.pattern, blocks)[static_cast<std::size_t>(k)].side == 2;
      if (!apart) close(span.from);
      if (apart && from < 0) from = span.from;
    }
    close(end);
  }
  if (times.empty()) return "nothing flies";
  std::string text = "apart: ";
  for (std::size_t i = 0; i < std::min(told, times.size()); ++i) text += (i > 0 ? ", " : "") + times[i];
  return text + (times.size() > told ? fmt::format(" and {} more", times.size() - told) : "");
}

/// The largest slip of a run, and at which interface.
std::string slip_phrase(const Run& run, const std::vector<Panel>& slips) {
  const auto less = [&](const Panel& a, const Panel& b) { return largest_of(run, a) < largest_of(run, b); };
  const auto most = std::max_element(slips.begin(), slips.end(), less);
  return fmt::format("{:.3g} mm at interface {} ({})", largest_of(run, *most), most - slips.begin() + 1,
                     line_label(run));
}

std::string slip_answer(const std::vector<Run>& runs, const std::vector<Panel>& slips, double end) {
  std::string text = "How far do blocks slide, and when do they fly? ";
  const bool told = runs.front().exact();
  text += (told ? "At most: " : "At most, without an exact motion: ") + slip_phrase(runs.front(), slips);
  if (told) text += "; " + flights_of(runs.front(), static_cast<int>(slips.size()), end);
  return text;
}

std::vector<Panel> slip_panels(const ComparedScene& scene, const std::vector<Run>& runs, std::size_t bins) {
  std::vector<Panel> panels;
  for (int k = 1; k <= scene.blocks; ++k)
    panels.push_back(
        read_panel({fmt::format("slip_{}", k), fmt::format("slip {} (mm)", k), millimetres}, runs, bins));
  return panels;
}

}  // namespace

Drawing slip(const Comparison& comparison, const ComparedScene& scene) {
  const Shown shown = shown_runs(comparison, scene.name);
  std::vector<Run> runs;
  for (const std::vector<Run>& list : {shown.exact, shown.engines})
    std::copy_if(list.begin(), list.end(), std::back_inserter(runs), tells_slips);
  const std::size_t bins = bins_for(runs.size() * 2 * static_cast<std::size_t>(scene.blocks));
  std::vector<Panel> panels = slip_panels(scene, runs, bins);
  const std::string question = slip_answer(runs, panels, last_time(panels));
  const auto is_still = [&](const Panel& panel) {
    return std::none_of(runs.begin(), runs.end(), [&](const Run& run) {
      return largest_of(run, panel) > least * panel.quantity.scale;
    });
  };
  for (int k = 1; k <= scene.blocks; ++k)
    panels.push_back(
        read_panel({fmt::format("gap_{}", k), fmt::format("gap {} (mm)", k), millimetres}, runs, bins));
  panels.erase(std::remove_if(panels.begin() + 1, panels.end(), is_still), panels.end());
  return drawn(scene, runs, panels, question);
}

Drawing friction(const Comparison& comparison, const ComparedScene& scene) {
  std::vector<Run> runs;
  for (const Run& run : done_runs(comparison, scene.name))
    if (run.exact() || has_own_friction(run)) runs.push_back(run);
  const std::size_t bins = bins_for(runs.size() * 2 * static_cast<std::size_t>(scene.blocks));
  std::vector<Panel> panels;
  for (int k = 1; k <= scene.blocks; ++k)
    panels.push_back(read_panel({fmt::format("theta_{}", k), angle_name(k) + " (rad)", 1}, runs, bins));
  const std::vector<Panel> slips = slip_panels(scene, runs, bins);
  panels.insert(panels.end(), slips.begin(), slips.end());
  std::string question = "What does friction do? Largest slips: ";
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (tells_slips(runs[i])) question += slip_phrase(runs[i], slips) + (i + 1 < runs.size() ? "; " : "");
  return drawn(scene, runs, panels, question);
}

}  // namespace rockstack::plots
