#include <fmt/format.h>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "plots/data/results.hpp"
#include "plots/figures/figure.hpp"
#include "plots/figures/studies/sweep_facts.hpp"

// The least of a number that topples a stack, and what lies beyond it.

namespace rockstack::plots {
namespace {

constexpr auto tried_style = "with points pt 7 ps 0.9*mark lc rgb '#1A1A1A'";
constexpr auto happens_style = "with boxes fs solid 1.0 noborder lc rgb '#F3D2C4'";
constexpr auto first_style = "with linespoints pt 7 ps 1.1*mark lw 2 lc rgb '#0B4F8A'";

}  // namespace

Drawings thresholds(const FolderSubject& subject) {
  const Json facts = read_json(subject.folder / "threshold.json");
  const Json& vary = facts.at("vary");
  const double low = vary.at("low"), high = vary.at("high");
  const std::string axis = axis_title(vary.at("key"));
  const auto tried = read_columns(subject.folder / "threshold.csv", {"value", "peak_ratio", "toppled"});
  const auto ranges = read_columns(subject.folder / "threshold-ranges.csv", {"from", "to", "happens"});
  std::string shaded;
  for (std::size_t i = 0; i < ranges[0].size(); ++i)
    if (ranges[2][i] > 0)
      shaded += fmt::format(
          "set object rectangle from {}, graph 0 to {}, graph 1 fillcolor rgb '#F3D2C4' fillstyle solid noborder "
          "behind\n",
          plain(ranges[0][i]), plain(ranges[1][i]));
  double top = last_ratio;  // what stands may have leant beyond its slenderness
  for (std::size_t i = 0; i < tried[0].size(); ++i)
    if (tried[2][i] == 0) top = std::max(top, last_ratio * tried[1][i]);
  const double toppled = top * edge / last_ratio;
  Numbers marks;
  for (std::size_t i = 0; i < tried[0].size(); ++i)
    if (!std::isnan(tried[1][i])) marks.push_back({tried[0][i], tried[2][i] == 0 ? tried[1][i] : toppled});
  Sheet sheet = subject.sheet(facts.at("title"),
                              {{tried_style, counted(marks.size(), "motion")},
                               {happens_style, facts.at("happens").get<std::string>()}},
                              facts.at("headline").at(0));
  Plots plots(sheet, "tried");
  plots.add(marks, {fmt::format("using 1:2 {}", tried_style)});
  if (subject.tells())
    sheet.tell({axis, "largest angle over slenderness", false, {drawn_curve("motions", marks)}});
  sheet.panel(subject.height(420), 0,
              fmt::format("{}set xrange [{}:{}]\nset yrange [0:{}]\n"
                          "set ytics add ('toppled' {})\n"
                          "set xlabel {} noenhanced\nset ylabel 'largest angle over slenderness'\n",
                          shaded, plain(low), plain(high), plain(top), plain(toppled), in_quotes(axis)) +
                  grid_lines,
              plots.list());
  return {{"", sheet.finish()}};
}

Drawings threshold_spectrum(const FolderSubject& subject) {
  const Json facts = read_json(subject.folder / "threshold.json");
  const Json &vary = facts.at("vary"), &over = facts.at("over");
  const auto found = read_columns(subject.folder / "threshold-spectrum.csv", {"value", "first"});
  Numbers marks;
  double top = 0;
  for (std::size_t i = 0; i < found[0].size(); ++i) {
    if (std::isnan(found[1][i])) continue;
    marks.push_back({found[0][i], found[1][i]});
    top = std::max(top, 1.08 * found[1][i]);
  }
  const std::string words = fmt::format("first {}", facts.at("happens").get<std::string>());
  Sheet sheet = subject.sheet(
      facts.at("title"), {{first_style, words}},
      marks.empty() ? "No threshold lies in the range"
                    : fmt::format("It {} from {:.4g} on at the least", words,
                                  std::ranges::min(marks, {}, [](const auto& mark) { return mark[1]; })[1]));
  Plots plots(sheet, "first");
  plots.add(marks, {fmt::format("using 1:2 {}", first_style)});
  sheet.panel(
      subject.height(420), 0,
      fmt::format(
          "set xrange [{}:{}]\nset yrange [0:{}]\nset xlabel {} noenhanced\nset ylabel {} noenhanced\n",
          plain(over.at("low")), plain(over.at("high")), plain(top > 0 ? top : vary.at("high").get<double>()),
          in_quotes(axis_title(over.at("key"))), in_quotes(axis_title(vary.at("key")))) +
          grid_lines,
      plots.list());
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
