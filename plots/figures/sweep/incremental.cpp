#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "comparisons/results/csv.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/figures/sweep/drawings.hpp"

namespace rockstack::plots {
namespace {

constexpr double end = 1.2;    // of the axis of peak angle over slenderness
constexpr double edge = 1.14;  // where blocks that topple are drawn
constexpr auto curve_style = "with linespoints pt 7 ps 0.35*mark lw 1 lc rgb '#9DB2C4'";
constexpr auto middle_style = "with lines lw 3 lc rgb '#0B4F8A'";
constexpr auto outer_style = "with lines lw 2.4 dt (10,6) lc rgb '#B03A00'";

/// A line a curve; runs that topple lie at the edge.
std::string curves(const std::filesystem::path& file) {
  const auto columns = read_columns(file, {"curve", "intensity", "peak_ratio", "toppled"});
  std::string text = "$curves << END\n";
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    if (i > 0 && columns[0][i] != columns[0][i - 1]) text += "\n";
    const double ratio = columns[3][i] > 0 ? edge : std::min(columns[2][i], edge);
    text += fmt::format("{} {}\n", plain(ratio), plain(columns[1][i]));
  }
  return text + "END\n";
}

std::string fractile(const std::string& name, const std::vector<double>& ratios,
                     const std::vector<double>& intensities) {
  std::string text = fmt::format("${} << END\n", name);
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    text += fmt::format("{} {}\n", plain(std::min(ratios[i], edge)), plain(intensities[i]));
  }
  return text + "END\n";
}

}  // namespace

Drawing incremental(const std::filesystem::path& results, const SweepFacts& facts) {
  const auto levels = read_columns(results / "incremental-fractiles.csv",
                                   {"intensity", "fractile_16", "fractile_50", "fractile_84"});
  Sheet sheet(facts.title, {{curve_style, "one motion"},
                            {middle_style, "median of the angle"},
                            {outer_style, "16 % and 84 % of the angle"}});
  sheet.data(curves(results / "incremental.csv"));
  sheet.data(fractile("low", levels[1], levels[0]));
  sheet.data(fractile("middle", levels[2], levels[0]));
  sheet.data(fractile("high", levels[3], levels[0]));
  const double top = levels[0].empty() ? 1 : 1.04 * *std::max_element(levels[0].begin(), levels[0].end());
  sheet.panel(
      560, 0,
      fmt::format("set grid lt 1 dt solid lw 1 lc rgb '#DADADA'\nset xrange [0:{0}]\nset yrange [0:{1}]\n"
                  "set xtics (0, 0.2, 0.4, 0.6, 0.8, 1, 'toppled' {2})\n"
                  "set xlabel 'largest angle over slenderness'\nset ylabel {3} noenhanced\n"
                  "set arrow 1 from 1, graph 0 to 1, graph 1 nohead lw 1 dt (4,4) lc rgb '#606060'\n",
                  end, plain(top), edge, in_quotes(facts.intensity)),
      {fmt::format("$curves using 1:2 {} notitle", curve_style),
       fmt::format("$low using 1:2 {} notitle", outer_style),
       fmt::format("$high using 1:2 {} notitle", outer_style),
       fmt::format("$middle using 1:2 {} notitle", middle_style)});
  return sheet.finish();
}

}  // namespace rockstack::plots
