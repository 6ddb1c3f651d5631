#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/figure.hpp"
#include "plots/figures/studies/sweep_facts.hpp"

namespace rockstack::plots {
namespace {

constexpr double end = 1.2;        // of the axis of peak angle over slenderness
constexpr double edge = 1.14;      // where blocks that topple are drawn
constexpr std::size_t enough = 7;  // motions, of which 16 % are one at least
constexpr auto run_style = "with points pt 7 ps 0.8*mark lc rgb '#8FA6BA'";
constexpr auto middle_style = "with lines lw 3 lc rgb '#0B4F8A'";
constexpr auto outer_style = "with lines lw 2.4 dt (10,6) lc rgb '#B03A00'";

/// What one motion does as it is scaled up.
struct ScaledMotion {
  std::vector<double> intensities, ratios;  ///< rising; of angle and slenderness, infinite where it topples
  std::vector<double> reached;              ///< the largest ratio up to each intensity
};

std::vector<ScaledMotion> read_motions(const std::filesystem::path& file) {
  const auto columns = read_columns(file, {"curve", "intensity", "peak_ratio", "toppled"});
  std::vector<ScaledMotion> motions;
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    if (i == 0 || columns[0][i] != columns[0][i - 1]) motions.emplace_back();
    ScaledMotion& motion = motions.back();
    motion.intensities.push_back(columns[1][i]);
    motion.ratios.push_back(columns[3][i] > 0 ? std::numeric_limits<double>::infinity() : columns[2][i]);
    motion.reached.push_back(motion.reached.empty() ? motion.ratios.back()
                                                    : std::max(motion.reached.back(), motion.ratios.back()));
  }
  return motions;
}

/// A mark a run: lines between them would go to and fro, since a stronger motion may turn a block less.
std::string runs_block(const std::vector<ScaledMotion>& motions) {
  std::string text = "$runs << END\n";
  for (const ScaledMotion& motion : motions)
    for (std::size_t i = 0; i < motion.ratios.size(); ++i)
      text += fmt::format("{} {}\n", plain(std::min(motion.ratios[i], edge)), plain(motion.intensities[i]));
  return text + "END\n";
}

/// A capacity curve: the angle that a share of the motions stays within up to each intensity. It never turns
/// back. `times` are angles over slenderness here, values intensities.
Curve capacity(const std::vector<ScaledMotion>& motions, double share) {
  std::map<double, std::vector<double>> levels;
  for (const ScaledMotion& motion : motions)
    for (std::size_t i = 0; i < motion.reached.size(); ++i)
      levels[motion.intensities[i]].push_back(motion.reached[i]);
  Curve curve;
  for (const auto& [intensity, reached] : levels) {
    curve.times.push_back(std::min(quantile(reached, share), edge));
    curve.values.push_back(intensity);
    if (curve.times.back() >= edge) break;
  }
  return curve;
}

/// The first intensity at which a capacity curve reaches the slenderness.
std::string answer_of(const Curve& median, const std::string& axis) {
  for (std::size_t i = 0; i < median.size(); ++i)
    if (median.times[i] >= 1)
      return "Half of the motions turn it by its slenderness at " + value_on(axis, median.values[i]);
  return "Half of the motions turn it by less than its slenderness throughout";
}

}  // namespace

Drawings incremental(const FolderSubject& subject) {
  const std::filesystem::path& results = subject.folder;
  const SweepFacts facts = sweep_facts(results);
  const std::vector<ScaledMotion> motions = read_motions(results / "incremental.csv");
  Legend legend{{run_style, fmt::format("runs of {} motions", motions.size())}};
  std::vector<std::string> plots{fmt::format("$runs using 1:2 {} notitle", run_style)};
  std::string answer = fmt::format("{} motions are too few for fractiles", motions.size());
  std::string data = runs_block(motions);
  if (motions.size() >= enough) {
    legend.emplace_back(middle_style, "largest angle up to there, median");
    legend.emplace_back(outer_style, "16 % and 84 %");
    for (const auto& [name, share, style] :
         {std::tuple{"low", 0.16, outer_style}, {"high", 0.84, outer_style}, {"middle", 0.5, middle_style}}) {
      data += data_block(name, capacity(motions, share));
      plots.push_back(fmt::format("${} using 1:2 {} notitle", name, style));
    }
    answer = answer_of(capacity(motions, 0.5), facts.intensity);
  }
  Sheet sheet = subject.sheet(facts.title, legend, answer);
  sheet.data(data);
  double top = 1e-9;
  for (const ScaledMotion& motion : motions) top = std::max(top, 1.04 * motion.intensities.back());
  if (facts.least_acceleration > 0) sheet.leave_room_beside();
  sheet.panel(560, 0,
              fmt::format("set xrange [0:{0}]\nset yrange [0:{1}]\n"
                          "set xtics (0, 0.2, 0.4, 0.6, 0.8, 1, 'toppled' {2})\n"
                          "set xlabel 'largest angle over slenderness'\nset ylabel {3} noenhanced\n"
                          "set arrow 1 from 1, graph 0 to 1, graph 1 nohead lw 1 dt (4,4) lc rgb '#606060'\n",
                          end, plain(top), edge, in_quotes(facts.intensity)) +
                  grid_lines +
                  dimensionless_axis("y", 0, top, facts.least_acceleration, "over g tan α, of uplift"),
              plots);
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
