#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "tests/analytic/unilateral/springs/stiff_sweep.hpp"

namespace rockstack::testing {
namespace {

/// From pale to dark with the damping, so that they are told apart in grey too; a colour and a mark each.
constexpr std::array<const char*, std::size(damping_ratios)> curve_styles{
    "with linespoints lw 2 pt 6 ps 1.0*mark lc rgb '#5BA3CF'",
    "with linespoints lw 2 pt 4 ps 1.0*mark lc rgb '#2E7EBC'",
    "with linespoints lw 2 pt 9 ps 1.1*mark lc rgb '#1561A9'",
    "with linespoints lw 2 pt 7 ps 1.0*mark lc rgb '#0B3C7D'"};
constexpr auto pushing_style = "with lines lw 4 lc rgb '#9A9A9A'";
constexpr auto paper_style = "with lines lw 3 dt 2 lc rgb '#C04A00'";

std::vector<std::string> quantities_of(const std::vector<StiffRow>& rows) {
  std::vector<std::string> result;
  for (const StiffRow& row : rows)
    if (result.empty() || result.back() != row.quantity) result.push_back(row.quantity);
  return result;
}

std::string block_name(std::size_t quantity, std::size_t ratio) {
  return fmt::format("stiff_{}_{}", quantity, ratio);
}

struct Panel {
  std::string data;
  std::vector<std::string> plots;
  double low, high;
};

/// Rows without a number leave gaps.
Panel panel_of(const std::vector<StiffRow>& rows, const std::string& quantity, std::size_t number) {
  const StiffRow& first =
      *std::find_if(rows.begin(), rows.end(), [&](const StiffRow& row) { return row.quantity == quantity; });
  Panel panel{{},
              {fmt::format("{} {} notitle", plots::plain(first.unilateral), pushing_style),
               fmt::format("{} {} notitle", plots::plain(first.paper), paper_style)},
              std::min(first.paper, first.unilateral),
              std::max(first.paper, first.unilateral)};
  for (std::size_t i = 0; i < std::size(damping_ratios); ++i) {
    plots::Curve curve;
    for (const StiffRow& row : rows) {
      if (row.quantity != quantity || row.ratio != damping_ratios[i] || std::isnan(row.springs)) continue;
      curve.times.push_back(row.stiffness);
      curve.values.push_back(row.springs);
      panel.low = std::min(panel.low, row.springs);
      panel.high = std::max(panel.high, row.springs);
    }
    if (curve.times.empty()) continue;
    panel.data += plots::data_block(block_name(number, i), curve);
    panel.plots.push_back(fmt::format("${} using 1:2 {} notitle", block_name(number, i), curve_styles[i]));
  }
  return panel;
}

plots::Legend legend() {
  plots::Legend entries;
  for (std::size_t i = 0; i < std::size(damping_ratios); ++i)
    entries.emplace_back(curve_styles[i],
                         fmt::format("springs, damping ratio {}", plots::plain(damping_ratios[i])));
  entries.emplace_back(pushing_style, "laws consistent and unilateral");
  entries.emplace_back(paper_style, "law paper");
  return entries;
}

}  // namespace

void draw(const std::vector<StiffRow>& rows, const std::filesystem::path& stem) {
  plots::Sheet sheet(
      "From soft to stiff springs at corners", legend(),
      "Which rigid law do stiff springs follow? Strongly damped, that of impulses that push, or nearly; "
      "weakly damped, none");
  const std::vector<std::string> quantities = quantities_of(rows);
  const auto [softest, stiffest] = std::minmax_element(
      rows.begin(), rows.end(),
      [](const StiffRow& one, const StiffRow& other) { return one.stiffness < other.stiffness; });
  constexpr double height = 190, gap = 40, words = 22;
  sheet.leave_room_above(words);
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const Panel panel = panel_of(rows, quantities[i], i);
    const double margin = 0.08 * (panel.high - panel.low);
    const bool lowest = i + 1 == quantities.size();
    sheet.data(panel.data);
    sheet.panel(
        height, gap,
        fmt::format("set logscale x\nset xrange [{}:{}]\nset yrange [{}:{}]\n"
                    "set label 2 {} noenhanced at graph 0, graph 1 left offset 0,0.7 font ',13'\n",
                    plots::plain(softest->stiffness), plots::plain(stiffest->stiffness),
                    plots::plain(panel.low - margin), plots::plain(panel.high + margin),
                    plots::in_quotes(quantities[i])) +
            plots::logarithmic_tics("x", softest->stiffness, stiffest->stiffness, 1000) +
            plots::linear_tics("y", panel.low - margin, panel.high + margin, height) + plots::grid_lines +
            (lowest ? "set xlabel 'stiffness of each corner (N/m)'\n" : plots::without_horizontal_labels),
        panel.plots);
  }
  plots::draw(sheet.finish(), stem);
}

}  // namespace rockstack::testing
