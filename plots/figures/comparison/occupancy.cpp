#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>

#include "comparisons/results/csv.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

using Shares = std::map<std::string, double>;

/// Shares of time of one engine run: in each pattern, the exact motion's and its own, and in the same one.
struct Occupancy {
  Run run;
  Shares exact, engine;
  double same = 0;
};

Occupancy read_occupancy(const Run& run) {
  const std::filesystem::path file = run.folder / "patterns.csv";
  const Table table = read_table(file);
  const std::size_t exact = column(table, "exact", file), engine = column(table, "engine", file),
                    share = column(table, "share", file);
  Occupancy result{.run = run, .exact = {}, .engine = {}};
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<std::string>& row = table.rows[i];
    const double part = number(row[share], fmt::format("{}:{}", file.string(), i + 2), "share");
    result.exact[row[exact]] += part;
    result.engine[row[engine]] += part;
    if (row[exact] == row[engine]) result.same += part;
  }
  return result;
}

/// Patterns that anybody spends a visible share of time in, the exact motion's longest first.
std::vector<std::string> patterns_of(const std::vector<Occupancy>& all) {
  constexpr double visible = 0.002;
  constexpr std::size_t most = 12;
  Shares largest;
  for (const Occupancy& one : all)
    for (const Shares* shares : {&one.exact, &one.engine})
      for (const auto& [pattern, share] : *shares) largest[pattern] = std::max(largest[pattern], share);
  std::vector<std::string> patterns;
  for (const auto& [pattern, share] : largest)
    if (share >= visible) patterns.push_back(pattern);
  const auto share_of = [&](const std::string& pattern) {
    const auto found = all.front().exact.find(pattern);
    return found == all.front().exact.end() ? 0 : found->second;
  };
  std::stable_sort(patterns.begin(), patterns.end(),
                   [&](const std::string& a, const std::string& b) { return share_of(a) > share_of(b); });
  patterns.resize(std::min(patterns.size(), most));
  return patterns;
}

double share_in(const Shares& shares, const std::string& pattern) {
  const auto found = shares.find(pattern);
  return found == shares.end() ? 0 : found->second;
}

/// Bars of one solver: the share, and the row's middle counted from above.
Curve bars(const std::vector<std::string>& patterns, const Shares& shares, std::size_t order,
           std::size_t solvers) {
  Curve curve;
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    const double slot = 0.8 / static_cast<double>(solvers);
    curve.times.push_back(share_in(shares, patterns[i]));
    curve.values.push_back(static_cast<double>(i) - 0.4 + (static_cast<double>(order) + 0.5) * slot);
  }
  return curve;
}

/// Filled for the exact motion; hatched otherwise, each its own way, so that grey tells them apart.
std::string fill(const std::string& colour, std::size_t order) {
  constexpr std::array hatches{1, 2, 4, 5, 6, 7};
  const std::string style =
      order == 0 ? "solid 0.55" : fmt::format("pattern {}", hatches[(order - 1) % hatches.size()]);
  return fmt::format("fillcolor rgb '{0}' fillstyle {1} border lc rgb '{0}' lw 1.5", colour, style);
}

std::string bar_plot(const std::string& colour, std::size_t order, std::size_t solvers) {
  return fmt::format("$bars_{0} using (0):2:(0):1:($2-{1}):($2+{1}) with boxxyerror {2} notitle", order,
                     plain(0.36 / static_cast<double>(solvers)), fill(colour, order));
}

/// For how much of the time each is in the exact pattern, where the short bars leave room.
std::string agreements(const std::vector<Occupancy>& all, double height) {
  constexpr double row = 20, first = 16;  // pixels from below
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i)
    text += fmt::format("set label {} noenhanced at graph 0.985, graph {} right font ',12' front\n",
                        in_quotes(fmt::format("{}: in the exact pattern for {:.1f} % of the time",
                                              run_label(all[i].run), 100 * all[i].same)),
                        plain((first + row * static_cast<double>(all.size() - 1 - i)) / height));
  return text;
}

std::string pattern_tics(const std::vector<std::string>& patterns) {
  std::string tics;
  for (std::size_t i = 0; i < patterns.size(); ++i)
    tics += fmt::format("{}{} {}", i > 0 ? ", " : "", in_quotes(patterns[i]), i);
  return tics;
}

}  // namespace

Drawing occupancy(const Comparison& comparison, const ComparedScene& scene, const Styles& styles) {
  std::vector<Occupancy> all;
  for (const Run& run : shown_runs(comparison, scene.name).engines)
    if (std::filesystem::exists(run.folder / "patterns.csv")) all.push_back(read_occupancy(run));
  if (all.empty()) return empty_sheet(heading(scene), "No engine run of this scene tells its patterns.");
  const std::vector<std::string> patterns = patterns_of(all);
  const std::size_t solvers = all.size() + 1;
  Legend legend{{"with boxes " + fill("#000000", 0), "exact"}};
  std::vector<std::string> plots{bar_plot("#000000", 0, solvers)};
  for (const Occupancy& one : all) {
    const std::string& colour = styles.at(solver_name(one.run)).colour;
    legend.emplace_back("with boxes " + fill(colour, plots.size()), run_label(one.run));
    plots.push_back(bar_plot(colour, plots.size(), solvers));
  }
  Sheet sheet(heading(scene), legend);
  sheet.data(data_block("bars_0", bars(patterns, all.front().exact, 0, solvers)));
  for (std::size_t i = 0; i < all.size(); ++i)
    sheet.data(data_block(fmt::format("bars_{}", i + 1), bars(patterns, all[i].engine, i + 1, solvers)));
  const auto rows = static_cast<double>(patterns.size());
  const double height = std::clamp(rows * (14 * static_cast<double>(solvers) + 10), 120.0, 900.0);
  sheet.panel(
      height, 0,
      fmt::format("set yrange [{}:-0.6]\nset ytics ({}) noenhanced\nset ylabel 'pattern' offset 0\n"
                  "set xrange [0:*]\nset format x '%g'\nset grid x lt 1 dt solid lw 1 lc rgb '#E4E4E4'\n"
                  "set xlabel 'share of time'\n",
                  plain(rows - 0.4), pattern_tics(patterns)) +
          agreements(all, height),
      plots);
  return sheet.finish();
}

}  // namespace rockstack::plots
