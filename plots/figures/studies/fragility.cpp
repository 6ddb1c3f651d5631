#include "comparisons/measures/statistics/fragility.hpp"
#include "comparisons/measures/results/long_table.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/statistics/draws.hpp"
#include "plots/figures/figure.hpp"
#include "plots/figures/studies/sweep_facts.hpp"

// What a stack bears as a motion grows: how likely it topples, and how far it turns.

namespace rockstack::plots {
namespace {

constexpr auto counted_style = "with yerrorbars pt 7 ps 1.1*mark lw 1.4 lc rgb '#1A1A1A'";
constexpr auto fitted_style = "with lines lw 2 lc rgb '#0B4F8A'";
constexpr auto bounds_style = "with filledcurves fc rgb '#CFE0EE' fs solid 1 noborder";

Numbers fitted_curve(const Fragility& fit, const FragilityBounds& bounds, double end) {
  constexpr int points = 200;
  Numbers numbers;
  for (int i = 1; i <= points; ++i) {
    const double x = end * i / points;
    numbers.push_back({x, probability(fit, x), bounds.at(x).lower, bounds.at(x).upper});
  }
  return numbers;
}

constexpr std::size_t enough = 7;  // motions, of which 16 % are one at least
constexpr auto run_style = "with points pt 7 ps 0.8*mark lc rgb '#8FA6BA'";
constexpr auto middle_style = "with lines lw 3 lc rgb '#0B4F8A'";
constexpr auto outer_style = "with lines lw 2.4 dt (10,6) lc rgb '#B03A00'";

/// What one motion does as it is scaled up.
struct ScaledMotion {
  std::vector<double> intensities, ratios;  ///< rising; of angle and slenderness, infinite where it topples
  std::vector<double> reached;              ///< the largest ratio up to each intensity
};

std::vector<ScaledMotion> read_motions(const fs::path& file) {
  std::vector<ScaledMotion> motions;
  double curve = 0;
  for (TableRows row(file, {"curve", "intensity", "peak_ratio", "toppled"}); row.next();) {
    if (motions.empty() || row.value(0) != curve) motions.emplace_back();
    curve = row.value(0);
    ScaledMotion& motion = motions.back();
    motion.intensities.push_back(row.value(1));
    motion.ratios.push_back(row.value(3) > 0 ? std::numeric_limits<double>::infinity() : row.value(2));
    motion.reached.push_back(motion.reached.empty() ? motion.ratios.back()
                                                    : std::max(motion.reached.back(), motion.ratios.back()));
  }
  return motions;
}

constexpr std::size_t most_marks = 4000;  // more are a page of megabytes, and no longer marks
constexpr std::uint64_t marks_seed = 1;

/// The motions whose runs are marked: all of them, or as many as have so many marks, drawn at random.
std::vector<ScaledMotion> marked_motions(const std::vector<ScaledMotion>& motions) {
  std::vector<std::pair<double, std::size_t>> places;
  std::size_t marks = 0;
  places.reserve(motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    places.emplace_back(rockstack::draw({Distribution::Kind::uniform, 0, 1}, {marks_seed, i, 0}), i);
    marks += motions[i].ratios.size();
  }
  if (marks <= most_marks) return motions;
  std::ranges::sort(places);
  std::set<std::size_t> drawn;
  marks = 0;
  for (const auto& [place, i] : places)
    if ((marks += motions[i].ratios.size()) <= most_marks || drawn.empty())
      drawn.insert(i);
    else
      break;
  return mapped(drawn, [&](std::size_t i) { return motions[i]; });
}

/// A capacity curve: the angle that a share of the motions stays within up to each intensity, or of very many
/// to some of them. It never turns back. A line is an angle over slenderness, and an intensity.
Numbers capacity(const std::vector<ScaledMotion>& motions, double share) {
  constexpr std::size_t most_points = 100;
  std::set<double> all;
  for (const ScaledMotion& motion : motions) all.insert(motion.intensities.begin(), motion.intensities.end());
  const std::size_t stride = 1 + (all.size() - 1) / most_points;
  Numbers curve;
  std::size_t i = 0;
  for (const double intensity : all) {
    if (i++ % stride != 0 && i != all.size()) continue;
    std::vector<double> reached;  // of each motion that has a run there or below
    for (const ScaledMotion& motion : motions) {
      const auto above = std::ranges::upper_bound(motion.intensities, intensity);
      if (above != motion.intensities.begin())
        reached.push_back(motion.reached[static_cast<std::size_t>(above - motion.intensities.begin()) - 1]);
    }
    curve.push_back({std::min(quantile(reached, share), edge), intensity});
    if (curve.back()[0] >= edge) break;
  }
  return curve;
}

/// Where half of the motions come to the slenderness first, between two intensities that were tried.
std::string answer_of(const Numbers& median, const std::string& axis) {
  const auto past =
      std::ranges::find_if(median, [](const std::vector<double>& line) { return line[0] >= 1; });
  if (past == median.end()) return "Half of the motions turn it by less than its slenderness throughout";
  if (past == median.begin())
    return "Half of the motions turn it by its slenderness at no more than " + value_on(axis, (*past)[1]);
  const std::string range = fmt::format("{:.3g} to {:.3g}", (*std::prev(past))[1], (*past)[1]);
  return "Half of the motions first turn it by its slenderness at " + value_on(axis, range);
}

/// Runs by their motions, where the runs of one are known as such; else each by itself.
std::vector<RunGroup> groups_of(const fs::path& folder, const std::vector<Level>& levels) {
  const fs::path file = folder / "incremental.csv";
  if (!fs::exists(table_file(file))) return single_runs(levels);
  std::vector<RunGroup> groups;
  double curve = 0;
  for (TableRows row(file, {"curve", "intensity", "toppled"}); row.next();) {
    if (groups.empty() || row.value(0) != curve) groups.emplace_back();
    curve = row.value(0);
    groups.back().push_back({row.value(1), 1, row.value(2) > 0 ? std::size_t{1} : std::size_t{0}});
  }
  return groups;
}

}  // namespace

Drawings fragility(const FolderSubject& subject) {
  const SweepFacts facts = sweep_facts(subject.folder);
  const auto levels = read_columns(subject.folder / "fragility.csv",
                                   {"intensity", "fraction", "lower", "upper", "runs", "toppled"});
  const auto fit = read_columns(subject.folder / "fragility-fit.csv", {"median", "beta"});
  double end = 0, runs = 0;
  std::vector<Level> tested;
  Numbers counts;
  for (std::size_t i = 0; i < levels[0].size(); ++i) {
    end = std::max(end, levels[0][i]);
    runs = std::max(runs, levels[4][i]);
    if (std::isnan(levels[1][i])) continue;
    tested.push_back(
        {levels[0][i], static_cast<std::size_t>(levels[4][i]), static_cast<std::size_t>(levels[5][i])});
    counts.push_back({levels[0][i], levels[1][i], levels[2][i], levels[3][i]});
  }
  end *= 1.04;
  Legend legend{{counted_style, fmt::format("counted, up to {:g} runs, 95 % bounds", runs)}};
  std::string answer = "No curve fits these counts";
  Numbers curve;
  if (!fit[0].empty()) {
    const Fragility fitted{fit[0][0], fit[1][0]};
    const std::vector<RunGroup> groups = groups_of(subject.folder, tested);
    const FragilityBounds bounds(fitted, groups);
    const auto [lower, upper] = bounds.of_median();
    const std::string between = groups.size() > 1 ? fmt::format(" ({:.3g}–{:.3g})", lower, upper) : "";
    legend.emplace_back(fitted_style,
                        fmt::format("fit: median {:.4g}{}, β {:.3g}", fitted.median, between, fitted.beta));
    if (groups.size() > 1)
      legend.emplace_back(bounds_style,
                          fmt::format("95 % bounds of the fit, from {}", counted(groups.size(), "motion")));
    answer = fmt::format("Half of the runs topple at {}{}", value_on(facts.intensity, fitted.median),
                         facts.cut_short > 0 ? " or less" : "");
    if (facts.least_acceleration > 0)
      answer += fmt::format(", {:.3g} times g tan α", fitted.median / facts.least_acceleration);
    curve = fitted_curve(fitted, bounds, end);
  }
  Sheet sheet = subject.sheet(facts.title, legend, answer);
  Plots plots(sheet, "share");
  if (!curve.empty())
    plots.add(curve,
              {fmt::format("using 1:3:4 {}", bounds_style), fmt::format("using 1:2 {}", fitted_style)});
  plots.add(counts, {fmt::format("using 1:2:3:4 {}", counted_style)});
  DrawnPanel told{facts.intensity, "share of runs that topple"};
  told.curves = {drawn_curve("counted", counts), drawn_curve("counted, lower bound", counts, 2),
                 drawn_curve("counted, upper bound", counts, 3)};
  if (!curve.empty())
    told.curves.insert(told.curves.end(),
                       {drawn_curve("fit", curve), drawn_curve("fit, lower bound", curve, 2),
                        drawn_curve("fit, upper bound", curve, 3)});
  if (subject.tells()) sheet.tell(std::move(told));
  if (facts.least_acceleration > 0) sheet.leave_room_above(axis_above);
  sheet.panel(
      subject.height(460), 0,
      fmt::format("set xrange [0:{}]\nset yrange [-0.02:1.02]\nset ytics 0.2\nset xlabel {} noenhanced\n"
                  "set ylabel 'share of runs that topple'\n",
                  plain(end), in_quotes(facts.intensity)) +
          grid_lines + dimensionless_axis("x", 0, end, facts.least_acceleration),
      plots.list());
  if (subject.width == full_width) sheet.note(facts.caution());
  return {{"", sheet.finish()}};
}

Drawings incremental(const FolderSubject& subject) {
  const SweepFacts facts = sweep_facts(subject.folder);
  const std::vector<ScaledMotion> motions = read_motions(subject.folder / "incremental.csv");
  const std::vector<ScaledMotion> marked = marked_motions(motions);
  Legend legend{{run_style, marked.size() == motions.size()
                                ? fmt::format("runs of {} motions", motions.size())
                                : fmt::format("runs of {} motions, drawn from {} by seed {}", marked.size(),
                                              motions.size(), marks_seed)}};
  std::string answer = fmt::format("{} motions are too few for fractiles", motions.size());
  const bool are_enough = motions.size() >= enough;
  if (are_enough) {
    legend.emplace_back(middle_style, "largest angle up to there, median");
    legend.emplace_back(outer_style, "16 % and 84 %");
    answer = answer_of(capacity(motions, 0.5), facts.intensity);
  }
  Sheet sheet = subject.sheet(facts.title, legend, answer);
  Plots plots(sheet, "motions");
  Numbers runs;  // marks: lines would go to and fro, since a stronger motion may turn a block less
  for (const ScaledMotion& motion : marked)
    for (std::size_t i = 0; i < motion.ratios.size(); ++i)
      runs.push_back({std::min(motion.ratios[i], edge), motion.intensities[i]});
  plots.add(runs, {fmt::format("using 1:2 {}", run_style)});
  if (are_enough)
    for (const auto& [share, style] :
         {std::pair{0.16, outer_style}, {0.84, outer_style}, {0.5, middle_style}})
      plots.add(capacity(motions, share), {fmt::format("using 1:2 {}", style)});
  double top = 1e-9;
  for (const ScaledMotion& motion : motions) top = std::max(top, 1.04 * motion.intensities.back());
  if (facts.least_acceleration > 0) sheet.leave_room_beside();
  sheet.panel(subject.height(560), 0,
              fmt::format("set xrange [0:{0}]\nset yrange [0:{1}]\n"
                          "set xtics (0, 0.2, 0.4, 0.6, 0.8, 1, 'toppled' {2})\n"
                          "set xlabel 'largest angle over slenderness'\nset ylabel {3} noenhanced\n"
                          "set arrow 1 from 1, graph 0 to 1, graph 1 nohead lw 1 dt (4,4) lc rgb '#606060'\n",
                          last_ratio, plain(top), edge, in_quotes(facts.intensity)) +
                  grid_lines + dimensionless_axis("y", 0, top, facts.least_acceleration),
              plots.list());
  sheet.note(facts.caution());
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
