#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "comparisons/measures/statistics/quantile.hpp"
#include "plots/data/run_files.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/series.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

struct Losses {
  Run run;
  std::vector<ImpactLoss> impacts;
};

/// The difference over what the exact impact loses, in percent, of those that lose a counted part of all.
struct Excess {
  Curve curve;         ///< over the impact's number
  double median = 0;   ///< of the absolute values
  double largest = 0;  ///< of them
};

constexpr double counted = 1e-3;      // of the largest loss
constexpr double most_percent = 100;  // where marks beyond stand on the edge

double largest_loss(const std::vector<Losses>& all) {
  double largest = 0;
  for (const Losses& one : all)
    for (const ImpactLoss& loss : one.impacts) largest = std::max(largest, loss.exact);
  return largest;
}

Excess excess_of(const Losses& one, double largest, double aside) {
  Excess excess;
  std::vector<double> sizes;
  for (const ImpactLoss& loss : one.impacts) {
    if (!(loss.exact > counted * largest)) continue;
    const double percent = 100 * (loss.engine / loss.exact - 1);
    excess.curve.times.push_back(loss.number + aside);
    excess.curve.values.push_back(std::clamp(percent, -most_percent, most_percent));
    sizes.push_back(std::abs(percent));
  }
  if (!sizes.empty()) excess.median = median(sizes), excess.largest = quantile(sizes, 1);
  return excess;
}

/// The impacts that all count, by number: exact losses of the run that has the most.
Curve exact_losses(const std::vector<Losses>& all, double largest) {
  const auto most = std::max_element(all.begin(), all.end(), [](const Losses& a, const Losses& b) {
    return a.impacts.size() < b.impacts.size();
  });
  Curve curve;
  for (const ImpactLoss& loss : most->impacts) {
    if (!(loss.exact > counted * largest)) continue;
    curve.times.push_back(loss.number);
    curve.values.push_back(loss.exact);
  }
  return curve;
}

std::string numbers(double last) {
  return fmt::format("set xrange [0.4:{}]\nset xtics {}\n", plain(last + 0.6),
                     std::max(1, static_cast<int>(last / 8))) +
         grid_lines;
}

void add_exact_panel(Sheet& sheet, const Curve& exact, double largest, double last) {
  constexpr double height = 200;
  sheet.data(data_block("exact", exact));
  sheet.panel(height, 0,
              numbers(last) + without_horizontal_labels() +
                  logarithmic_range("y", counted * largest / 1.5, largest * 2, height) +
                  "set ylabel 'exact loss (J)'\n",
              {"$exact using 1:2 with impulses lw 3 lc rgb '#9A9A9A' notitle",
               "$exact using 1:2 with points pt 7 ps 1.1*mark lc rgb '#000000' notitle"});
}

}  // namespace

Drawing impact_energy(const SceneSubject& subject) {
  const Comparison& comparison = subject.comparison;
  const ComparedScene& scene = subject.scene;
  std::vector<Losses> all;
  for (const Run& run : shown_runs(comparison, scene.name).engines)
    if (std::filesystem::exists(run.folder / "energy.csv") &&
        std::filesystem::exists(run.folder / "impacts.csv"))
      all.push_back({run, impact_losses(run)});
  std::erase_if(all, [](const Losses& one) { return one.impacts.empty(); });
  const double largest = all.empty() ? 0 : largest_loss(all);
  if (!(largest > 0)) return subject.nothing("No impact that loses energy and that an engine has too.");
  const Curve exact = exact_losses(all, largest);
  double last = 1;
  for (const double number : exact.times) last = std::max(last, number);
  std::vector<Run> runs;
  std::vector<Series> series;
  std::string data;
  double least = 1e300, most = 0, widest = 1e-3;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Excess excess = excess_of(all[i], largest, aside(i, all.size()));
    const std::string name = fmt::format("excess_{}", i);
    data += data_block(name, excess.curve);
    widest = std::max(widest, excess.largest);
    least = std::min(least, excess.median), most = std::max(most, excess.median);
    runs.push_back(all[i].run);
    series.push_back(mark_series(all[i].run, name, 1.6));
  }
  Sheet sheet =
      subject.sheet(legend_of(runs, [](const Run& run, std::size_t) { return mark_style(run, 1.6); }),
                    fmt::format("Off by {} % at an engine's median",
                                span_text(fmt::format("{:.2g}", least), fmt::format("{:.2g}", most))));
  sheet.data(data);
  add_exact_panel(sheet, exact, largest, last);
  const double edge = 1.08 * std::min(widest, most_percent);
  const auto axes = [&](double, double height) {
    return numbers(last) + linear_range("y", -edge, edge, height);
  };
  add_series(sheet,
             {"number of the exact impact",
              "engine loses more (%)",
              "loses more (%)",
              true,
              axes,
              330,
              16,
              {zero_line}},
             series, all.size() > most_series);
  return sheet.finish();
}

}  // namespace rockstack::plots
