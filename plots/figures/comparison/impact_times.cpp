#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "plots/data/events.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

struct Verdicts {
  Run run;
  Impacts impacts;
};

SignedLog scale_of(const std::vector<Verdicts>& all) {
  double low = 1e-3, high = 1e-5;
  for (const Verdicts& verdicts : all)
    for (const MatchedImpact& impact : verdicts.impacts.matched) {
      high = std::max(high, std::abs(impact.difference));
      if (impact.difference != 0) low = std::min(low, std::abs(impact.difference));
    }
  return signed_log(low, high);
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

/// A row of marks of its own.
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
      matched.times.push_back(impact.number + aside(i, all.size()));
      matched.values.push_back(scale.place(impact.difference));
    }
    const Rows rows = rows_of(i, all.size());
    sheet.data(data_block(block_name("matched", i), matched));
    sheet.data(data_block(block_name("missed", i), row_of(all[i].impacts.missed, rows.missed)));
    sheet.data(data_block(block_name("extra", i), row_of(all[i].impacts.extra, rows.extra)));
  }
}

std::vector<std::string> matched_plots(const std::vector<Verdicts>& all, double size) {
  std::vector<std::string> plots{zero_line};
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!all[i].impacts.matched.empty())
      plots.push_back(
          fmt::format("${} using 1:2 {} notitle", block_name("matched", i), mark_style(all[i].run, size)));
  return plots;
}

std::vector<std::string> row_plots(const std::vector<Verdicts>& all) {
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string style = mark_style(all[i].run, 1.1);
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

/// Impacts are counted, so that the axis has whole numbers alone, up to `most` of them, and none beyond the
/// last.
std::string number_settings(double last, double most) {
  int step = 1;
  for (int i = 0; last / step > most; ++i) step = i % 2 == 0 ? step * 5 : step * 2;
  return fmt::format("set xrange [0.4:{}]\nset xtics {}, {}, {}\n", plain(last + 0.6), step, step,
                     std::floor(last)) +
         grid_lines;
}

double median_size(const Impacts& impacts) {
  std::vector<double> sizes;
  for (const MatchedImpact& impact : impacts.matched) sizes.push_back(std::abs(impact.difference));
  if (sizes.empty()) return std::numeric_limits<double>::infinity();
  std::sort(sizes.begin(), sizes.end());
  return sizes[sizes.size() / 2];
}

std::string question(const std::vector<Verdicts>& all) {
  const auto best = std::min_element(all.begin(), all.end(), [](const Verdicts& a, const Verdicts& b) {
    if (is_variant(a.run) != is_variant(b.run)) return is_variant(b.run);
    return median_size(a.impacts) < median_size(b.impacts);
  });
  return fmt::format(
      "How late or early is each impact? Nearest: {}, half of its {} within {}, {} missed, {} extra",
      run_phrase(best->run), best->impacts.matched.size(), rounded_duration(median_size(best->impacts)),
      best->impacts.missed.size(), best->impacts.extra.size());
}

/// What there is to say where no impact is matched.
std::string without_matches(const std::vector<Verdicts>& all) {
  std::size_t missed = 0, extra = 0;
  for (const Verdicts& verdicts : all) {
    missed = std::max(missed, verdicts.impacts.missed.size());
    extra = std::max(extra, verdicts.impacts.extra.size());
  }
  if (missed + extra == 0) return "No impacts, neither in the exact motion nor in an engine.";
  return fmt::format("No impact is in both: the exact motion has {}, an engine at most {}.", missed, extra);
}

std::string difference_settings(const SignedLog& scale, double height) {
  return fmt::format("set yrange [-{0}:{0}]\nset ytics ({1})\n", plain(scale.edge()), scale.tics(height));
}

void add_panels(Sheet& sheet, const std::vector<Verdicts>& all, const SignedLog& scale, double last) {
  constexpr double few = 40, most = 20, height = 380;
  sheet.panel(height, 0,
              number_settings(last, most) + without_horizontal_labels() + difference_settings(scale, height) +
                  "set ylabel 'engine − exact impact time (s)' offset 0\n",
              matched_plots(all, last > few ? 1.1 : 1.6));
  sheet.panel(static_cast<double>(all.size()) * 28 + 16, 12,
              number_settings(last, most) + row_settings(all.size()) +
                  "set format x '%g'\nset xlabel 'number of the exact impact'\n",
              row_plots(all));
}

void add_small_panels(Sheet& sheet, const std::vector<Verdicts>& all, const SignedLog& scale, double last) {
  std::vector<Multiple> series;
  std::vector<std::string> context{zero_line};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Impacts& impacts = all[i].impacts;
    Multiple one{
        fmt::format("{}: −{} +{}", line_label(all[i].run), impacts.missed.size(), impacts.extra.size()),
        style_of(all[i].run).colour,
        {}};
    if (!impacts.matched.empty()) {
      context.push_back(fmt::format("${} using 1:2 with points pt 7 ps 0.6*mark lc rgb '{}' notitle",
                                    block_name("matched", i), context_colour));
      one.plots.push_back(
          fmt::format("${} using 1:2 {} notitle", block_name("matched", i), mark_style(all[i].run, 1.1)));
    }
    series.push_back(one);
  }
  add_multiples(sheet, series, context,
                number_settings(last, 8) + difference_settings(scale, multiple_height),
                "number of the exact impact", "late (s)");
  sheet.note("−: exact impacts that the engine misses; +: impacts of its own that match none", "#000000");
}

}  // namespace

Drawing impact_times(const Comparison& comparison, const ComparedScene& scene) {
  std::vector<Verdicts> all;
  for (const Run& run : shown_runs(comparison, scene.name).engines)
    if (std::filesystem::exists(run.folder / "impacts.csv")) all.push_back({run, read_impacts(run)});
  if (all.empty()) return empty_sheet(heading(scene), "No engine run of this scene to compare.");
  if (std::all_of(all.begin(), all.end(), [](const Verdicts& one) { return one.impacts.matched.empty(); }))
    return empty_sheet(heading(scene), without_matches(all));
  const SignedLog scale = scale_of(all);
  const bool many = all.size() > most_series;
  Legend legend;
  if (!many)
    for (const Verdicts& verdicts : all)
      legend.emplace_back(mark_style(verdicts.run, 1.6), run_label(verdicts.run));
  Sheet sheet(heading(scene), legend, question(all));
  add_data(sheet, all, scale);
  if (many)
    add_small_panels(sheet, all, scale, last_number(all));
  else
    add_panels(sheet, all, scale, last_number(all));
  return sheet.finish();
}

}  // namespace rockstack::plots
