#include "plots/data/run_files.hpp"
#include "plots/figures/figure.hpp"

// Impact by impact: when each comes, and what it loses.

namespace rockstack::plots {
namespace {

constexpr auto number_words = "number of the exact impact";

/// Impacts are counted: the axis has whole numbers alone, up to `most` of them, and none beyond the last.
std::string number_settings(double last, double most) {
  int step = 1;
  for (int i = 0; last / step > most; ++i) step = i % 2 == 0 ? step * 5 : step * 2;
  return fmt::format("set xrange [0.4:{}]\nset xtics {}, {}, {}\n", plain(last + 0.6), step, step,
                     std::floor(last)) +
         grid_lines;
}

/// The impacts of an engine by the number of the exact ones, from 1.
struct Verdicts {
  Run run;
  std::vector<double> numbers = {}, lateness = {};  ///< matched; s, positive where the engine is late
  std::vector<double> missed = {};                  ///< exact impacts that it does not have
  std::vector<double> extra = {};  ///< its own, between the numbers of the exact impacts before and after
  int by_chance = 0;               ///< that match once the thread is lost
};

Verdicts verdicts_on(const Run& run) {
  Verdicts verdicts{run};
  const auto list = impacts_of(run);
  for (const AlignedImpact& one : *list) {
    if (one.exact && one.engine && *one.exact > thread_lost(*list, one.interface)) {
      ++verdicts.by_chance;
    } else if (one.exact && one.engine) {
      verdicts.numbers.push_back(value_of(one.number));
      verdicts.lateness.push_back(*one.engine - *one.exact);
    } else if (one.exact) {
      verdicts.missed.push_back(value_of(one.number));
    } else {
      const auto before = std::ranges::count_if(
          *list, [&](const AlignedImpact& other) { return other.exact && other.exact <= one.engine; });
      verdicts.extra.push_back(static_cast<double>(before) + 0.5);
    }
  }
  return verdicts;
}

/// A scale that is linear up to 10^first and logarithmic beyond, either side of zero; a unit a power of ten.
struct SignedLog {
  int first, last;

  double place(double value) const {
    const double size = std::abs(value) / std::pow(10, first);
    const double height = size <= 1 ? size : 1 + std::log10(size);
    return std::copysign(height, value);
  }
  double edge() const { return last - first + 1.5; }  ///< of the axis, on either side

  /// For "set ytics (…)" of a panel that is so many pixels high: as many powers as there is room for.
  std::string tics(double height) const {
    constexpr double room = 26;  // pixels a number
    const double unit = height / (2 * edge());
    const int stride = std::max(1 + (last - first) / 4, static_cast<int>(std::ceil(room / unit)));
    std::string text = "'0' 0";
    for (int power = last; power >= first && (power - first + 1) * unit >= room; power -= stride)
      text += fmt::format(", '+10^{{{0}}}' {1}, '−10^{{{0}}}' -{1}", power, power - first + 1);
    return text;
  }
};

/// Scale of all that are late or early; at most eight decades.
SignedLog scale_of(const std::vector<Verdicts>& all) {
  double low = 1e-3, high = 1e-5;
  for (const Verdicts& verdicts : all)
    for (const double late : verdicts.lateness) {
      high = std::max(high, std::abs(late));
      if (late != 0) low = std::min(low, std::abs(late));
    }
  constexpr int most_decades = 8;
  const int last = static_cast<int>(std::ceil(std::log10(high) - 1e-9));
  return {std::clamp(static_cast<int>(std::floor(std::log10(low))), last - most_decades, last), last};
}

constexpr double most_numbers = 20;  // along the panel of few

/// Two rows a run under the panel of few: what it misses, and what it has beyond.
void add_unmatched(Sheet& sheet, const std::vector<Verdicts>& all, double last) {
  const auto runs = static_cast<double>(all.size());
  Plots plots(sheet, "unmatched");
  double row = 2 * runs;
  for (const Verdicts& one : all) {
    for (const auto& numbers_at : {std::pair{&one.missed, row}, {&one.extra, row - runs}}) {
      const auto mark = [&](double number) { return std::vector{number, numbers_at.second}; };
      const Numbers marks = mapped(*numbers_at.first, mark);
      if (!marks.empty()) plots.add(marks, {"using 1:2 " + mark_style(one.run, 1.1)});
    }
    --row;
  }
  sheet.panel(
      28 * runs + 16, 12,
      number_settings(last, most_numbers) +
          fmt::format("set yrange [0.3:{0}]\nset ytics ('missed' {1}, 'extra' {2})\nset grid x\n"
                      "set arrow from graph 0, first {3} to graph 1, first {3} nohead lc rgb '#888888'\n"
                      "set format x '%g'\nset xlabel '{4}'\n",
                      plain(2 * runs + 0.7), plain(1.5 * runs + 0.5), plain(0.5 * runs + 0.5),
                      plain(runs + 0.5), number_words),
      plots.list());
}

double median_size(const Verdicts& verdicts) {
  if (verdicts.lateness.empty()) return std::numeric_limits<double>::infinity();
  return median(mapped(verdicts.lateness, [](double late) { return std::abs(late); }));
}

/// From the engine that has least to the one that has most.
template <class Value, class Text>
std::string span_of(const std::vector<Verdicts>& all, const Value& value, const Text& text) {
  Extent reach;
  for (const Verdicts& one : all)
    if (!one.run.is_variant() && std::isfinite(value(one))) reach.add(value(one));
  return reach.low > reach.high ? "none" : span_text(text(reach.low), text(reach.high));
}

/// Counts of replicates are the medians that a row has: those of the run that is drawn are one draw.
std::string answer(const std::vector<Verdicts>& all) {
  const auto replicated = [](const Verdicts& one) { return one.run.draws.value_or(1) > 1; };
  const auto count = [&](std::optional<int> RunMetrics::*median, std::vector<double> Verdicts::*list) {
    return span_of(
        all,
        [&](const Verdicts& one) {
          const std::optional<int>& of_row = one.run.*median;
          return replicated(one) && of_row ? static_cast<double>(*of_row)
                                           : static_cast<double>((one.*list).size());
        },
        [](double number) { return fmt::format("{:g}", number); });
  };
  const std::string matched = count(&RunMetrics::impacts_matched, &Verdicts::numbers);
  return fmt::format("By engine: {} {} matched, in the median {} off; {} missed, {} extra{}", matched,
                     matched == "1" ? "impact" : "impacts", span_of(all, median_size, rounded_duration),
                     count(&RunMetrics::impacts_missed, &Verdicts::missed),
                     count(&RunMetrics::impacts_extra, &Verdicts::extra),
                     std::ranges::any_of(all, replicated)
                         ? "; counts are medians of replicates, marks those of one run"
                         : "");
}

/// What there is to say where no impact is matched. Precondition: there are runs.
std::string without_matches(const std::vector<Verdicts>& all) {
  const auto most = [&](std::vector<double> Verdicts::*list) {
    return std::ranges::max(mapped(all, [&](const Verdicts& one) { return (one.*list).size(); }));
  };
  const std::size_t missed = most(&Verdicts::missed), extra = most(&Verdicts::extra);
  if (missed + extra == 0) return "No impacts, neither in the exact motion nor in an engine.";
  return fmt::format("No impact is in both: the exact motion has {}, an engine at most {}.", missed, extra);
}

void add_differences(Sheet& sheet, const std::vector<Verdicts>& all, double last, double height) {
  constexpr double few = 40;
  const SignedLog scale = scale_of(all);
  std::vector<Series> series;
  for (const Verdicts& one : all) {
    const std::string name = fmt::format("matched_{}", series.size());
    Curve curve;
    for (std::size_t i = 0; i < one.numbers.size(); ++i)
      curve.add(one.numbers[i] + aside(series.size(), all.size()), scale.place(one.lateness[i]));
    sheet.data(data_block(name, curve));
    series.push_back(mark_series(one.run, name, last > few ? 1.1 : 1.6));
    series.back().words += fmt::format(": −{} +{}", one.missed.size(), one.extra.size());
  }
  const auto axes = [&](double width, double up) {
    return number_settings(last, width > multiple_width ? most_numbers : 8) +
           fmt::format("set yrange [-{0}:{0}]\nset ytics ({1})\n", plain(scale.edge()), scale.tics(up));
  };
  SeriesPanel panel{number_words, "engine − exact impact time (s)", "late (s)", false, axes, height, 0};
  panel.under = {zero_line};
  add_series(sheet, panel, series, all.size() > most_series);
}

constexpr double counted_share = 1e-3;  // of the largest loss
constexpr double most_percent = 100;    // where marks beyond stand on the edge

/// The impacts of an engine that lose a counted part of all.
struct Losses {
  Run run;
  std::vector<ImpactLoss> impacts;
};

/// The difference over what the exact impact loses, in percent.
struct Excess {
  Curve curve;         ///< over the impact's number
  double median = 0;   ///< of the absolute values
  double largest = 0;  ///< of them
};

Excess excess_of(const Losses& one, double aside) {
  Excess excess;
  std::vector<double> sizes;
  for (const ImpactLoss& loss : one.impacts) {
    const double percent = 100 * (loss.engine / loss.exact - 1);
    excess.curve.add(loss.number + aside, std::clamp(percent, -most_percent, most_percent));
    sizes.push_back(std::abs(percent));
  }
  if (!sizes.empty()) excess.median = median(sizes), excess.largest = quantile(sizes, 1);
  return excess;
}

std::string numbers(double last) {
  return fmt::format("set xrange [0.4:{}]\nset xtics {}\n", plain(last + 0.6),
                     std::max(1, static_cast<int>(last / 8))) +
         grid_lines;
}

}  // namespace

Drawing impact_times(const SceneSubject& subject) {
  const std::vector<Run> runs = subject.shown({"impacts.csv"}).engines;
  if (runs.empty()) return subject.nothing("No engine run with impacts to compare.");
  const std::vector<Verdicts> all = mapped(runs, verdicts_on);
  if (std::ranges::all_of(all, [](const Verdicts& one) { return one.numbers.empty(); }))
    return subject.nothing(without_matches(all));
  Sheet sheet = subject.sheet(mark_legend(runs, 1.6), answer(all));
  double last = 1;
  for (const Verdicts& verdicts : all)
    for (const std::vector<double>* numbers : {&verdicts.numbers, &verdicts.missed, &verdicts.extra})
      for (const double number : *numbers) last = std::max(last, number);
  add_differences(sheet, all, last, subject.height(380, 480));
  if (are_many(runs))
    sheet.note("−: exact impacts that the engine misses; +: impacts of its own that match none");
  else
    add_unmatched(sheet, all, last);
  int by_chance = 0;
  for (const Verdicts& verdicts : all) by_chance += verdicts.by_chance;
  if (by_chance > 0)
    sheet.note(fmt::format(
        "Not drawn: {} that match by chance, after both motions had two in a row that do not", by_chance));
  return sheet.finish();
}

Drawing impact_energy(const SceneSubject& subject) {
  std::vector<Losses> all = mapped(subject.shown({"energy.csv", "impacts.csv"}).engines, [](const Run& run) {
    return Losses{run, impact_losses(run)};
  });
  std::erase_if(all, [](const Losses& one) { return one.impacts.empty(); });
  double largest = 0;
  for (const Losses& one : all)
    for (const ImpactLoss& loss : one.impacts) largest = std::max(largest, loss.exact);
  if (!(largest > 0)) return subject.nothing("No impact that loses energy and that an engine has too.");
  if (std::ranges::all_of(all, [](const Losses& one) { return one.impacts.size() == 1; }))
    return subject.nothing("One impact alone: before and after it is the whole motion.");
  const auto count = [](const Losses& one) { return one.impacts.size(); };
  const auto most = std::ranges::max_element(all, {}, count) - all.begin();
  for (Losses& one : all)
    std::erase_if(one.impacts,
                  [&](const ImpactLoss& loss) { return !(loss.exact > counted_share * largest); });
  Curve exact;  // of the run that has the most, by number
  for (const ImpactLoss& loss : all[static_cast<std::size_t>(most)].impacts)
    exact.add(loss.number, loss.exact);
  const double last = exact.times.empty() ? 1 : exact.times.back();
  std::vector<Series> series;
  std::string data = data_block("exact", exact);
  double widest = 1e-3;
  Extent medians;
  for (const Losses& one : all) {
    const Excess excess = excess_of(one, aside(series.size(), all.size()));
    const std::string name = fmt::format("excess_{}", series.size());
    data += data_block(name, excess.curve);
    widest = std::max(widest, excess.largest);
    medians.add(excess.median);
    series.push_back(mark_series(one.run, name, 1.6));
  }
  const auto percent = [](double value) { return fmt::format("{:.2g}", value); };
  Sheet sheet = subject.sheet(mark_legend(mapped(all, &Losses::run), 1.6),
                              fmt::format("Off by {} % at an engine's median",
                                          span_text(percent(medians.low), percent(medians.high))));
  sheet.data(data);
  constexpr double height = 200;
  sheet.panel(height, 0,
              numbers(last) + without_horizontal_labels +
                  logarithmic_range("y", counted_share * largest / 1.5, largest * 2, height) +
                  "set ylabel 'exact loss (J)'\n",
              {"$exact using 1:2 with impulses lw 3 lc rgb '#9A9A9A' notitle",
               "$exact using 1:2 with points pt 7 ps 1.1*mark lc rgb '#000000' notitle"});
  const double edge = 1.08 * std::min(widest, most_percent);
  const auto axes = [&](double, double up) { return numbers(last) + linear_range("y", -edge, edge, up); };
  SeriesPanel panel{number_words, "engine loses more (%)", "loses more (%)", true, axes, 330};
  panel.under = {zero_line};
  add_series(sheet, panel, series, all.size() > most_series);
  return sheet.finish();
}

}  // namespace rockstack::plots
