#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/results/csv.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/figures/sweep/drawings.hpp"

namespace rockstack::plots {
namespace {

constexpr auto counted_style = "with yerrorbars pt 7 ps 1.1*mark lw 1.4 lc rgb '#1A1A1A'";
constexpr auto fitted_style = "with lines lw 2 lc rgb '#0B4F8A'";

/// The fitted curve from zero to the highest intensity.
Curve fitted_curve(double median, double beta, double end) {
  constexpr int points = 200;
  Curve curve;
  for (int i = 1; i <= points; ++i) {
    const double x = end * i / points;
    curve.times.push_back(x);
    curve.values.push_back(0.5 * std::erfc(-std::log(x / median) / (beta * std::numbers::sqrt2)));
  }
  return curve;
}

}  // namespace

std::string axis_title(const std::string& key) {
  const auto ends = [&](const char* end) { return key.ends_with(end); };
  if (ends(".peak")) return "peak ground acceleration (m/s²)";
  if (ends(".amplitude")) return "amplitude of the pulse (m/s²)";
  if (ends(".scale")) return "scale of the record";
  return key;
}

Drawing fragility(const std::filesystem::path& results, const SweepFacts& facts) {
  const auto levels =
      read_columns(results / "fragility.csv", {"intensity", "fraction", "lower", "upper", "runs"});
  const auto fit = read_columns(results / "fragility-fit.csv", {"median", "beta"});
  double end = 0, runs = 0;
  std::string data = "$levels << END\n";
  for (std::size_t i = 0; i < levels[0].size(); ++i) {
    end = std::max(end, levels[0][i]);
    runs = std::max(runs, levels[4][i]);
    if (std::isnan(levels[1][i])) continue;
    data += fmt::format("{} {} {} {}\n", plain(levels[0][i]), plain(levels[1][i]), plain(levels[2][i]),
                        plain(levels[3][i]));
  }
  end *= 1.04;
  Legend legend{{counted_style, fmt::format("counted, up to {:g} runs a level, with 95 % bounds", runs)}};
  std::vector<std::string> elements{fmt::format("$levels using 1:2:3:4 {} notitle", counted_style)};
  if (!fit[0].empty()) {
    legend.emplace_back(fitted_style,
                        fmt::format("lognormal fit, median {:.4g}, β {:.3g}", fit[0][0], fit[1][0]));
    elements.insert(elements.begin(), fmt::format("$fitted using 1:2 {} notitle", fitted_style));
  }
  Sheet sheet(facts.title, legend);
  sheet.data(data + "END\n");
  if (!fit[0].empty()) sheet.data(data_block("fitted", fitted_curve(fit[0][0], fit[1][0], end)));
  sheet.panel(460, 0,
              fmt::format("set grid lt 1 dt solid lw 1 lc rgb '#DADADA'\nset xrange [0:{}]\n"
                          "set yrange [-0.02:1.02]\nset ytics 0.2\nset xlabel {} noenhanced\n"
                          "set ylabel 'share of runs that topple'\n",
                          plain(end), in_quotes(facts.intensity)),
              elements);
  return sheet.finish();
}

}  // namespace rockstack::plots
