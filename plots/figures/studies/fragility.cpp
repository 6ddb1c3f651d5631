#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "comparisons/measures/results/csv.hpp"
#include "plots/data/fragility_fit.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/figure.hpp"
#include "plots/figures/studies/sweep_facts.hpp"

namespace rockstack::plots {
namespace {

constexpr auto counted_style = "with yerrorbars pt 7 ps 1.1*mark lw 1.4 lc rgb '#1A1A1A'";
constexpr auto fitted_style = "with lines lw 2 lc rgb '#0B4F8A'";

constexpr auto bounds_style = "with filledcurves fc rgb '#CFE0EE' fs solid 1 noborder";

/// The fitted curve between its bounds, from zero to the highest intensity.
std::string fitted_curve(const FragilityFit& fit, double end) {
  constexpr int points = 200;
  std::string text = "$fitted << END\n";
  for (int i = 1; i <= points; ++i) {
    const double x = end * i / points;
    text += fmt::format("{} {} {} {}\n", plain(x), plain(fit.probability(x)), plain(fit.lower(x)),
                        plain(fit.upper(x)));
  }
  return text + "END\n";
}

std::string fit_words(const FragilityFit& fit, double median, double beta) {
  return fmt::format("lognormal fit, median {:.4g} ({:.3g}–{:.3g}), β {:.3g}", median, fit.median_lower(),
                     fit.median_upper(), beta);
}

}  // namespace

Drawings fragility(const FolderSubject& subject) {
  const std::filesystem::path& results = subject.folder;
  const SweepFacts facts = sweep_facts(results);
  const auto levels =
      read_columns(results / "fragility.csv", {"intensity", "fraction", "lower", "upper", "runs"});
  const auto fit = read_columns(results / "fragility-fit.csv", {"median", "beta"});
  double end = 0, runs = 0;
  std::vector<TestedLevel> tested;
  std::string data = "$levels << END\n";
  for (std::size_t i = 0; i < levels[0].size(); ++i) {
    end = std::max(end, levels[0][i]);
    runs = std::max(runs, levels[4][i]);
    if (std::isnan(levels[1][i])) continue;
    tested.push_back({levels[0][i], levels[4][i]});
    data += fmt::format("{} {} {} {}\n", plain(levels[0][i]), plain(levels[1][i]), plain(levels[2][i]),
                        plain(levels[3][i]));
  }
  end *= 1.04;
  data += "END\n";
  Legend legend{{counted_style, fmt::format("counted, up to {:g} runs a level, with 95 % bounds", runs)}};
  std::vector<std::string> elements{fmt::format("$levels using 1:2:3:4 {} notitle", counted_style)};
  std::string answer = "No curve fits these counts";
  if (!fit[0].empty()) {
    const double median = fit[0][0], beta = fit[1][0];
    const FragilityFit fitted(median, beta, tested);
    legend.emplace_back(fitted_style, fit_words(fitted, median, beta));
    legend.emplace_back(bounds_style, "95 % bounds of the fit");
    elements.insert(elements.begin(), {fmt::format("$fitted using 1:3:4 {} notitle", bounds_style),
                                       fmt::format("$fitted using 1:2 {} notitle", fitted_style)});
    answer = fmt::format("Half of the motions topple it at {}", value_on(facts.intensity, median));
    if (facts.least_acceleration > 0)
      answer += fmt::format(", {:.3g} times g tan α", median / facts.least_acceleration);
    data += fitted_curve(fitted, end);
  }
  Sheet sheet = subject.sheet(facts.title, legend, answer);
  sheet.data(data);
  if (facts.least_acceleration > 0) sheet.leave_room_above(axis_above);
  sheet.panel(
      460, 0,
      fmt::format("set xrange [0:{}]\nset yrange [-0.02:1.02]\nset ytics 0.2\nset xlabel {} noenhanced\n"
                  "set ylabel 'share of runs that topple'\n",
                  plain(end), in_quotes(facts.intensity)) +
          grid_lines + dimensionless_axis("x", 0, end, facts.least_acceleration, "over g tan α, of uplift"),
      elements);
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
