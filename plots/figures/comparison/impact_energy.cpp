#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "plots/data/impact_losses.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/comparison/drawings.hpp"

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
  std::sort(sizes.begin(), sizes.end());
  if (!sizes.empty()) excess.median = sizes[sizes.size() / 2], excess.largest = sizes.back();
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

/// As wide as the largest difference asks for.
std::string percent_settings(double largest, double height) {
  const double edge = 1.08 * std::min(largest, most_percent);
  return fmt::format("set yrange [-{0}:{0}]\n", plain(edge)) + linear_tics("y", -edge, edge, height);
}

void add_exact_panel(Sheet& sheet, const Curve& exact, double largest, double last) {
  sheet.data(data_block("exact", exact));
  sheet.panel(200, 0,
              numbers(last) + without_horizontal_labels() +
                  fmt::format("set logscale y\nset yrange [{}:{}]\n", plain(counted * largest / 1.5),
                              plain(largest * 2)) +
                  logarithmic_tics("y", counted * largest / 1.5, largest * 2, 200) +
                  "set ylabel 'exact loss (J)'\n",
              {"$exact using 1:2 with impulses lw 3 lc rgb '#9A9A9A' notitle",
               "$exact using 1:2 with points pt 7 ps 1.1*mark lc rgb '#000000' notitle"});
}

void add_panel(Sheet& sheet, const std::vector<Losses>& all, double last, double widest) {
  constexpr double height = 330;
  std::vector<std::string> plots{zero_line};
  for (std::size_t i = 0; i < all.size(); ++i)
    plots.push_back(fmt::format("$excess_{} using 1:2 {} notitle", i, mark_style(all[i].run, 1.6)));
  sheet.panel(height, 16,
              numbers(last) + percent_settings(widest, height) +
                  "set xlabel 'number of the exact impact'\nset ylabel 'engine loses more (%)'\n",
              plots);
}

void add_small_panels(Sheet& sheet, const std::vector<Losses>& all, double last, double widest) {
  std::vector<Multiple> series;
  std::vector<std::string> context{zero_line};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string data = fmt::format("$excess_{} using 1:2 ", i);
    context.push_back(data + fmt::format("with points pt 7 ps 0.6*mark lc rgb '{}' notitle", context_colour));
    series.push_back({line_label(all[i].run),
                      style_of(all[i].run).colour,
                      {data + mark_style(all[i].run, 1.1) + " notitle"}});
  }
  add_multiples(sheet, series, context, numbers(last) + percent_settings(widest, multiple_height),
                "number of the exact impact", "loses more (%)");
}

}  // namespace

Drawing impact_energy(const Comparison& comparison, const ComparedScene& scene) {
  std::vector<Losses> all;
  for (const Run& run : shown_runs(comparison, scene.name).engines)
    if (std::filesystem::exists(run.folder / "energy.csv") &&
        std::filesystem::exists(run.folder / "impacts.csv"))
      all.push_back({run, read_impact_losses(run)});
  std::erase_if(all, [](const Losses& one) { return one.impacts.empty(); });
  const double largest = all.empty() ? 0 : largest_loss(all);
  if (!(largest > 0))
    return empty_sheet(heading(scene), "No impact that loses energy and that an engine has too.");
  const bool many = all.size() > most_series;
  const Curve exact = exact_losses(all, largest);
  double last = 1;
  for (const double number : exact.times) last = std::max(last, number);
  Legend legend;
  std::string data;
  std::size_t best = 0;
  double least = 1e300, widest = 1e-3;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Excess excess = excess_of(all[i], largest, aside(i, all.size()));
    data += data_block(fmt::format("excess_{}", i), excess.curve);
    widest = std::max(widest, excess.largest);
    if (excess.median < least) least = excess.median, best = i;
    if (!many) legend.emplace_back(mark_style(all[i].run, 1.6), run_label(all[i].run));
  }
  Sheet sheet(heading(scene), legend,
              fmt::format("Does each impact lose what it should? Nearest: {}, off by {:.2g} % at the median",
                          run_phrase(all[best].run), least));
  sheet.data(data);
  add_exact_panel(sheet, exact, largest, last);
  if (many)
    add_small_panels(sheet, all, last, widest);
  else
    add_panel(sheet, all, last, widest);
  return sheet.finish();
}

}  // namespace rockstack::plots
