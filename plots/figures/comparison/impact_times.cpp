#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "plots/data/events.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

struct Verdicts {
  Run run;
  Impacts impacts;
};

/// A scale that is linear up to 10^first and logarithmic beyond, on both sides of zero; one unit a power of
/// ten.
struct SignedLog {
  int first = -6;
  int last = 0;

  double place(double value) const {
    const double size = std::abs(value) / std::pow(10, first);
    const double height = size <= 1 ? size : 1 + std::log10(size);
    return std::copysign(height, value);
  }
  double edge() const { return last - first + 1.5; }

  std::string tics() const {
    std::string text = "'0' 0";
    const int stride = 1 + (last - first) / 4;
    for (int power = last; power >= first; power -= stride) {
      text += fmt::format(", '+10^{{{0}}}' {1}, '−10^{{{0}}}' -{1}", power, power - first + 1);
    }
    return text;
  }
};

SignedLog scale_of(const std::vector<Verdicts>& all) {
  double low = 1e-3, high = 1e-5;
  for (const Verdicts& verdicts : all)
    for (const MatchedImpact& impact : verdicts.impacts.matched) {
      high = std::max(high, std::abs(impact.difference));
      if (impact.difference != 0) low = std::min(low, std::abs(impact.difference));
    }
  constexpr int most_decades = 8;
  const int last = static_cast<int>(std::ceil(std::log10(high) - 1e-9));
  return {std::clamp(static_cast<int>(std::floor(std::log10(low))), last - most_decades, last), last};
}

double last_number(const std::vector<Verdicts>& all) {
  double last = 1;
  for (const Verdicts& verdicts : all) {
    for (const MatchedImpact& impact : verdicts.impacts.matched) last = std::max(last, impact.number);
    for (const double number : verdicts.impacts.missed) last = std::max(last, number);
    for (const double number : verdicts.impacts.extra) last = std::max(last, number);
  }
  return last;
}

std::string block_name(const char* what, std::size_t run) {
  return fmt::format("{}_{}", what, run);
}

/// Points of one run in a row of its own.
Curve row_of(const std::vector<double>& numbers, double height) {
  return {numbers, std::vector<double>(numbers.size(), height)};
}

struct Rows {
  double missed, extra;  ///< heights of a run's rows in the lower panel
};

Rows rows_of(std::size_t run, std::size_t runs) {
  const auto from_top = static_cast<double>(2 * runs - run);
  return {from_top, from_top - static_cast<double>(runs)};
}

void add_data(Sheet& sheet, const std::vector<Verdicts>& all, const SignedLog& scale) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    Curve matched;
    for (const MatchedImpact& impact : all[i].impacts.matched) {
      matched.times.push_back(impact.number);
      matched.values.push_back(scale.place(impact.difference));
    }
    const Rows rows = rows_of(i, all.size());
    sheet.data(data_block(block_name("matched", i), matched));
    sheet.data(data_block(block_name("missed", i), row_of(all[i].impacts.missed, rows.missed)));
    sheet.data(data_block(block_name("extra", i), row_of(all[i].impacts.extra, rows.extra)));
  }
}

std::vector<std::string> matched_plots(const std::vector<Verdicts>& all, const Styles& styles, double size) {
  std::vector<std::string> plots{"0 with lines lw 1.5 lc rgb '#000000' notitle"};
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!all[i].impacts.matched.empty())
      plots.push_back(fmt::format("${} using 1:2 {} notitle", block_name("matched", i),
                                  mark_style(styles.at(solver_name(all[i].run)), false, size)));
  return plots;
}

std::vector<std::string> row_plots(const std::vector<Verdicts>& all, const Styles& styles) {
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string style = mark_style(styles.at(solver_name(all[i].run)), false, 1.1);
    if (!all[i].impacts.missed.empty())
      plots.push_back(fmt::format("${} using 1:2 {} notitle", block_name("missed", i), style));
    if (!all[i].impacts.extra.empty())
      plots.push_back(fmt::format("${} using 1:2 {} notitle", block_name("extra", i), style));
  }
  return plots;
}

std::string row_settings(std::size_t runs) {
  const auto count = static_cast<double>(runs);
  return fmt::format(
      "set yrange [0.3:{0}]\nset ytics ('missed' {1}, 'extra' {2})\nset grid x\nset ylabel\n"
      "set arrow from graph 0, first {3} to graph 1, first {3} nohead lc rgb '#888888'\n",
      plain(2 * count + 0.7), plain(1.5 * count + 0.5), plain(0.5 * count + 0.5), plain(count + 0.5));
}

}  // namespace

Drawing impact_times(const Comparison& comparison, const ComparedScene& scene, const Styles& styles) {
  std::vector<Verdicts> all;
  for (const Run& run : shown_runs(comparison, scene.name).engines)
    if (std::filesystem::exists(run.folder / "impacts.csv")) all.push_back({run, read_impacts(run)});
  if (all.empty()) return empty_sheet(heading(scene), "No engine run of this scene to compare.");
  const bool any = std::any_of(all.begin(), all.end(), [](const Verdicts& verdicts) {
    const Impacts& impacts = verdicts.impacts;
    return !impacts.matched.empty() || !impacts.missed.empty() || !impacts.extra.empty();
  });
  if (!any) return empty_sheet(heading(scene), "No impacts, neither in the exact motion nor in an engine.");

  const SignedLog scale = scale_of(all);
  const double last = last_number(all);
  const std::string number_range = fmt::format("set xrange [0.4:{}]\n", plain(last + 0.6));
  constexpr double few = 40;
  Legend legend;
  for (const Verdicts& verdicts : all)
    legend.emplace_back(mark_style(styles.at(solver_name(verdicts.run)), false, 1.6),
                        run_label(verdicts.run));
  Sheet sheet(heading(scene), legend);
  add_data(sheet, all, scale);
  sheet.panel(
      380, 0,
      number_range + without_horizontal_labels() +
          fmt::format("set yrange [-{0}:{0}]\nset ytics ({1})\nset grid lt 1 dt solid lw 1 lc rgb '#E4E4E4'\n"
                      "set ylabel 'engine − exact impact time (s)' offset 0\n",
                      plain(scale.edge()), scale.tics()),
      matched_plots(all, styles, last > few ? 1.1 : 1.7));
  sheet.panel(static_cast<double>(all.size()) * 28 + 16, 12,
              number_range + row_settings(all.size()) +
                  "set format x '%g'\nset xlabel 'number of the exact impact'\n",
              row_plots(all, styles));
  return sheet.finish();
}

}  // namespace rockstack::plots
