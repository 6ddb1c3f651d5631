#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparisons/measures/statistics/samples.hpp"
#include "plots/data/run_files.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/series.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// The impacts of an engine by the number of the exact ones, from 1.
struct Verdicts {
  Run run;
  std::vector<double> numbers, lateness;  ///< of matched impacts; s, positive where the engine is late
  std::vector<double> missed;             ///< exact impacts that it does not have
  std::vector<double> extra;  ///< its own, between the numbers of the exact impacts before and after
};

Verdicts verdicts_on(const Run& run) {
  Verdicts verdicts{run, {}, {}, {}, {}};
  const auto list = impacts_of(run);
  for (const AlignedImpact& one : *list) {
    if (one.exact && one.engine) {
      verdicts.numbers.push_back(value_of(one.number));
      verdicts.lateness.push_back(*one.engine - *one.exact);
    } else if (one.exact) {
      verdicts.missed.push_back(value_of(one.number));
    } else {
      const auto before = std::count_if(list->begin(), list->end(), [&](const AlignedImpact& other) {
        return other.exact && other.exact <= one.engine;
      });
      verdicts.extra.push_back(static_cast<double>(before) + 0.5);
    }
  }
  return verdicts;
}

SignedLog scale_of(const std::vector<Verdicts>& all) {
  double low = 1e-3, high = 1e-5;
  for (const Verdicts& verdicts : all)
    for (const double late : verdicts.lateness) {
      high = std::max(high, std::abs(late));
      if (late != 0) low = std::min(low, std::abs(late));
    }
  return signed_log(low, high);
}

double last_number(const std::vector<Verdicts>& all) {
  double last = 1;
  for (const Verdicts& verdicts : all)
    for (const std::vector<double>* numbers : {&verdicts.numbers, &verdicts.missed, &verdicts.extra})
      for (const double number : *numbers) last = std::max(last, number);
  return last;
}

/// A row of marks of its own.
Curve row_of(const std::vector<double>& numbers, double height) {
  return {numbers, std::vector<double>(numbers.size(), height)};
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

/// Two rows a run under the panel of few: what it misses, and what it has beyond.
void add_unmatched(Sheet& sheet, const std::vector<Verdicts>& all, double last, double most) {
  const auto runs = static_cast<double>(all.size());
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double missed = 2 * runs - static_cast<double>(i);
    for (const auto& [name, row] : {std::pair{"missed", row_of(all[i].missed, missed)},
                                    {"extra", row_of(all[i].extra, missed - runs)}}) {
      if (row.size() == 0) continue;
      sheet.data(data_block(fmt::format("{}_{}", name, i), row));
      plots.push_back(fmt::format("${}_{} using 1:2 {} notitle", name, i, mark_style(all[i].run, 1.1)));
    }
  }
  sheet.panel(
      28 * runs + 16, 12,
      number_settings(last, most) +
          fmt::format("set yrange [0.3:{0}]\nset ytics ('missed' {1}, 'extra' {2})\nset grid x\n"
                      "set arrow from graph 0, first {3} to graph 1, first {3} nohead lc rgb '#888888'\n"
                      "set format x '%g'\nset xlabel 'number of the exact impact'\n",
                      plain(2 * runs + 0.7), plain(1.5 * runs + 0.5), plain(0.5 * runs + 0.5),
                      plain(runs + 0.5)),
      plots);
}

double median_size(const Verdicts& verdicts) {
  std::vector<double> sizes;
  for (const double late : verdicts.lateness) sizes.push_back(std::abs(late));
  return sizes.empty() ? std::numeric_limits<double>::infinity() : median(std::move(sizes));
}

/// From the engine that has least to the one that has most.
template <class Value>
std::string span_of(const std::vector<Verdicts>& all, const Value& value, std::string (*text)(double)) {
  std::vector<double> values;
  for (const Verdicts& one : all)
    if (!is_variant(one.run) && std::isfinite(value(one))) values.push_back(value(one));
  if (values.empty()) return "none";
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return span_text(text(*low), text(*high));
}

std::string count_text(double count) {
  return fmt::format("{:g}", count);
}

std::string answer(const std::vector<Verdicts>& all) {
  const auto size = [](std::vector<double> Verdicts::*list) {
    return [list](const Verdicts& one) { return static_cast<double>((one.*list).size()); };
  };
  return fmt::format(
      "Half of an engine's {} matched impacts within {}; {} missed, {} extra",
      span_of(all, size(&Verdicts::numbers), count_text), span_of(all, median_size, rounded_duration),
      span_of(all, size(&Verdicts::missed), count_text), span_of(all, size(&Verdicts::extra), count_text));
}

/// What there is to say where no impact is matched.
std::string without_matches(const std::vector<Verdicts>& all) {
  std::size_t missed = 0, extra = 0;
  for (const Verdicts& verdicts : all) {
    missed = std::max(missed, verdicts.missed.size());
    extra = std::max(extra, verdicts.extra.size());
  }
  if (missed + extra == 0) return "No impacts, neither in the exact motion nor in an engine.";
  return fmt::format("No impact is in both: the exact motion has {}, an engine at most {}.", missed, extra);
}

/// How late each matched impact is, by its number.
void add_differences(Sheet& sheet, const std::vector<Verdicts>& all, double last, double most) {
  constexpr double few = 40;
  const SignedLog scale = scale_of(all);
  std::vector<Series> series;
  for (const Verdicts& one : all) {
    const std::string name = fmt::format("matched_{}", series.size());
    Curve curve;
    for (std::size_t i = 0; i < one.numbers.size(); ++i) {
      curve.times.push_back(one.numbers[i] + aside(series.size(), all.size()));
      curve.values.push_back(scale.place(one.lateness[i]));
    }
    sheet.data(data_block(name, curve));
    series.push_back(mark_series(one.run, name, last > few ? 1.1 : 1.6));
    series.back().words += fmt::format(": −{} +{}", one.missed.size(), one.extra.size());
  }
  const auto axes = [&](double width, double height) {
    return number_settings(last, width < panel_width ? 8 : most) +
           fmt::format("set yrange [-{0}:{0}]\nset ytics ({1})\n", plain(scale.edge()), scale.tics(height));
  };
  add_series(sheet,
             {"number of the exact impact",
              "engine − exact impact time (s)",
              "late (s)",
              false,
              axes,
              380,
              0,
              {zero_line}},
             series, all.size() > most_series);
}

}  // namespace

Drawing impact_times(const SceneSubject& subject) {
  const Comparison& comparison = subject.comparison;
  const ComparedScene& scene = subject.scene;
  std::vector<Verdicts> all;
  std::vector<Run> runs;
  for (const Run& run : shown_runs(comparison, scene.name).engines)
    if (std::filesystem::exists(run.folder / "impacts.csv")) {
      runs.push_back(run);
      all.push_back(verdicts_on(run));
    }
  if (all.empty()) return subject.nothing("No engine run of this scene to compare.");
  if (std::all_of(all.begin(), all.end(), [](const Verdicts& one) { return one.numbers.empty(); }))
    return subject.nothing(without_matches(all));
  Sheet sheet = subject.sheet(
      legend_of(runs, [](const Run& run, std::size_t) { return mark_style(run, 1.6); }), answer(all));
  constexpr double most = 20;
  const double last = last_number(all);
  add_differences(sheet, all, last, most);
  if (are_many(runs))
    sheet.note("−: exact impacts that the engine misses; +: impacts of its own that match none", "#000000");
  else
    add_unmatched(sheet, all, last, most);
  return sheet.finish();
}

}  // namespace rockstack::plots
