#include "comparisons/measures/results/csv.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

using Shares = std::map<std::string, double>;

/// Shares of time of one engine run: in each pattern, the exact motion's and its own, and in the same one.
struct Occupancy {
  Run run;
  Shares exact = {}, engine = {};
  double same = 0;
};

Occupancy read_occupancy(const Run& run) {
  Occupancy result{run};
  for (CsvLine row(run.shown_folder() / "patterns.csv"); row.next();) {
    const std::string &exact = row.text("exact"), &engine = row.text("engine");
    const double share = row.value("share");
    result.exact[exact] += share;
    result.engine[engine] += share;
    if (exact == engine) result.same += share;
  }
  return result;
}

double share_in(const Shares& shares, const std::string& pattern) {
  return shares.contains(pattern) ? shares.at(pattern) : 0;
}

Shares largest_shares(const std::vector<Occupancy>& all) {
  Shares largest;
  for (const Occupancy& one : all)
    for (const Shares* shares : {&one.exact, &one.engine})
      for (const auto& [pattern, share] : *shares) largest[pattern] = std::max(largest[pattern], share);
  return largest;
}

/// Patterns that anybody spends a visible share of time in, the exact motion's longest first.
std::vector<std::string> patterns_of(const std::vector<Occupancy>& all) {
  constexpr double visible = 0.002;
  constexpr std::size_t most = 12;
  std::vector<std::string> patterns;
  for (const auto& [pattern, share] : largest_shares(all))
    if (share >= visible) patterns.push_back(pattern);
  const auto exact = [&](const std::string& pattern) { return share_in(all.front().exact, pattern); };
  std::ranges::stable_sort(patterns, std::greater(), exact);
  patterns.resize(std::min(patterns.size(), most));
  return patterns;
}

/// Marks of one run: the share, and the row's middle counted from above.
Curve marks(const std::vector<std::string>& patterns, const Shares& shares, double aside) {
  Curve curve;
  for (std::size_t i = 0; i < patterns.size(); ++i)
    curve.add(share_in(shares, patterns[i]), static_cast<double>(i) + aside);
  return curve;
}

/// The exact share as a bar behind the marks of its row.
constexpr auto exact_bar =
    "$exact using (0):2:(0):1:($2-0.42):($2+0.42) with boxxyerror fillcolor rgb '#9A9A9A' fillstyle solid 1 "
    "noborder notitle";

/// No more letters than have room beside the panel.
std::string shortened(const std::string& pattern) {
  constexpr std::size_t longest = 52;
  return pattern.size() > longest ? pattern.substr(0, longest - 1) + "…" : pattern;
}

/// Where the panel begins, so that the longest name has room beside it.
double names_room(const std::vector<std::string>& patterns) {
  constexpr double letter = 0.0072, widest = 0.42;  // shares of the figure's width
  std::size_t most = 0;
  for (const std::string& pattern : patterns) most = std::max(most, pattern.size());
  return std::clamp(0.045 + letter * static_cast<double>(most), left_edge, widest);
}

std::string answer(const std::vector<Occupancy>& all) {
  std::vector<Occupancy> engines = all;
  std::erase_if(engines, [](const Occupancy& one) { return one.run.is_variant(); });
  if (engines.empty()) engines = {all.front()};
  const auto [least, most] = std::ranges::minmax_element(engines, {}, &Occupancy::same);
  const auto words = [](const Occupancy& one) {
    return fmt::format("{} for {:.1f} % of the time", run_phrase(one.run), 100 * one.same);
  };
  return engines.size() == 1 ? words(*most) : words(*most) + ", " + words(*least);
}

std::string panel_settings(const std::vector<Occupancy>& all, const std::vector<std::string>& patterns,
                           double width) {
  double end = 0;
  for (const auto& [pattern, share] : largest_shares(all)) end = std::max(end, 1.06 * share);
  return fmt::format(
             "set yrange [{}:-0.6]\nset ytics ({}) noenhanced font ',11'\nset xrange [0:{}]\n"
             "set grid x lt 1 dt solid lw 1 lc rgb '#E4E4E4'\n",
             plain(static_cast<double>(patterns.size()) - 0.4), word_tics(mapped(patterns, shortened)),
             plain(end)) +
         linear_tics("x", 0, end, width);
}

}  // namespace

Drawing occupancy(const SceneSubject& subject) {
  const std::vector<Run> runs = subject.shown({"patterns.csv"}).engines;
  const std::vector<Occupancy> all = mapped(runs, read_occupancy);
  if (all.empty()) return subject.nothing("No engine run of this scene tells its patterns.");
  const std::vector<std::string> patterns = patterns_of(all);
  Legend legend = mark_legend(runs, 1.5);
  legend.insert(legend.begin(), {"with boxes fillcolor rgb '#9A9A9A' fillstyle solid 1 noborder", "exact"});
  Sheet sheet = subject.sheet(legend, answer(all));
  sheet.data(data_block("exact", marks(patterns, all.front().exact, 0)));
  std::vector<Series> series;
  for (const Occupancy& one : all) {
    const std::size_t order = series.size();
    const std::string block = fmt::format("marks_{}", order);
    sheet.data(data_block(block, marks(patterns, one.engine, aside(order, all.size()))));
    series.push_back(mark_series(one.run, block, 1.2));
    series.back().words += fmt::format(": {:.1f} %", 100 * one.same);
    series.back().context.clear();
  }
  const double row = 16 + 8 * static_cast<double>(all.size()),
               usual = std::max(static_cast<double>(patterns.size()) * row, 120.0);
  const auto axes = [&](double width, double) { return panel_settings(all, patterns, width); };
  SeriesPanel panel{"share of time", "", "", true, axes, subject.height(usual, usual), 0};
  panel.under = {exact_bar};
  panel.left = names_room(patterns);
  add_series(sheet, panel, series, are_many(runs));
  if (are_many(runs))
    sheet.note("in percent: for how much of the time each is in the exact pattern");
  else if (!subject.on_slide)
    for (const Occupancy& one : all)
      sheet.note(fmt::format("{}: in the exact pattern for {:.1f} % of the time", run_label(one.run),
                             100 * one.same),
                 style_of(one.run).colour);
  return sheet.finish();
}

}  // namespace rockstack::plots
