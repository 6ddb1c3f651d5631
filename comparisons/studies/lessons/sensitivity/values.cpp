#include <fmt/format.h>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/leans.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {
namespace {

constexpr double change = 1e-6;         // of the ground's acceleration, as a share
constexpr double unseen_change = 1e-9;  // a change that stays out of sight
constexpr double parted = 1e-2;         // rad
constexpr int seeds = 30;
constexpr double engine_step = 1e-3;  // s

Scene stronger(Scene scene, double share) {
  for (double& sample : scene.horizontal.samples) sample *= 1 + share;
  return scene;
}

/// The largest difference of the top block's angles so far, rad, at each time.
std::vector<double> differences_so_far(const History& a, const History& b) {
  std::vector<double> list;
  double most = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    list.push_back(most = std::max(most, std::abs(a.angles_at(i)[1] - b.angles_at(i)[1])));
  return list;
}

/// When they first exceed a size, s; negative if never.
double parting(const std::vector<double>& times, const std::vector<double>& differences, double size) {
  const auto first = std::ranges::upper_bound(differences, size);
  return first == differences.end() ? -1 : times[static_cast<std::size_t>(first - differences.begin())];
}

/// The straight line ln δ = offset + rate · t through a difference while it grows.
struct Growth {
  double rate = 0, offset = 0;  ///< 1/s, and of δ in rad
  double from = 0, until = 0;   ///< the time that was fitted, s
};

/// By least squares, from where a difference can be seen beside rounding to three quarters of its way up.
Growth growth(const std::vector<double>& times, const std::vector<double>& differences) {
  constexpr double visible = 1e-11;  // rad
  const double end = std::pow(differences.back(), 0.75) * std::pow(visible, 0.25);
  double n = 0, t = 0, d = 0, tt = 0, td = 0;
  Growth line;
  for (std::size_t i = 0; i < differences.size() && differences[i] < end; ++i) {
    if (differences[i] < visible) continue;
    if (n == 0) line.from = times[i];
    line.until = times[i];
    const double log = std::log(differences[i]);
    n += 1, t += times[i], d += log, tt += times[i] * times[i], td += times[i] * log;
  }
  line.rate = (n * td - t * d) / (n * tt - t * t);
  line.offset = (d - line.rate * t) / n;
  return line;
}

// The drawing: 10 s from left to right, 62 units each.
double across(double time) {
  return 70 + 62 * time;
}

/// A path through every 20th sample of the first ten seconds, `height` giving the place of one.
template <class Height>
std::string path(const History& history, const Height& height) {
  std::string text;
  for (std::size_t i = 0; i < history.size() && history.times[i] <= 10; i += 20)
    text += fmt::format("{}{:.1f} {:.1f}", i == 0 ? "M" : " ", across(history.times[i]), height(i));
  return text;
}

/// Place of a difference: 18.75 units a power of ten, 10⁻⁴ at 210.
double decades_down(double difference) {
  return 210 - 18.75 * (std::log10(std::max(difference, 1e-12)) + 4);
}

std::map<std::string, std::string> paths(const History& exact, const History& changed,
                                         const std::vector<double>& differences, const Growth& line) {
  const auto angle = [](const History& history) {
    return [&](std::size_t i) { return 95 - 75 / 0.16 * history.angles_at(i)[1]; };
  };
  const auto end = [&](double time) {
    return fmt::format("{:.1f} {:.1f}", across(time), decades_down(std::exp(line.offset + line.rate * time)));
  };
  return {{"path_exact", path(exact, angle(exact))},
          {"path_changed", path(changed, angle(changed))},
          {"path_difference", path(exact, [&](std::size_t i) { return decades_down(differences[i]); })},
          {"path_line", "M" + end(line.from) + "L" + end(line.until)}};
}

/// When histories' differences_so_far() part from the exact one, a column each.
Table partings(const std::vector<double>& times,
               const std::vector<std::pair<const char*, std::vector<double>>>& others) {
  Table table{{"difference of θ₂ (rad)"}};
  for (const auto& [label, differences] : others) table.columns.emplace_back(label);
  for (const double size : {1e-8, 1e-6, 1e-4, 1e-3, 1e-2}) {
    table.rows.push_back({cell(size)});
    for (const auto& [label, differences] : others) {
      const double time = parting(times, differences, size);
      table.rows.back().push_back(time < 0 ? "never" : cell(time));
    }
  }
  return table;
}

/// Peaks of the top block over many earthquakes, in the order of the seeds, by what gives them.
using Peaks = std::map<std::string, std::vector<double>>;

Peaks peaks_over_seeds(const NamedScene& named) {
  Peaks peaks;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Scene scene = read_shipped(named.name, {fmt::format("ground.horizontal.synthetic={}", seed)});
    peaks["exact"].push_back(solve(scene, {.peaks = true}).peaks[1]);
    peaks["changed"].push_back(solve(stronger(scene, 1e-3), {.peaks = true}).peaks[1]);
    for (const char* engine : {"bullet", "ode"})
      peaks[engine].push_back(peak_angles(answer(engine, scene, engine_step))[1]);
  }
  return peaks;
}

Table quantiles(const Peaks& peaks) {
  Table table{
      {"share of earthquakes below", "exact: largest |θ₂| (rad)", "Bullet, 1 ms (rad)", "ODE, 1 ms (rad)"}};
  for (const double share : {0.1, 0.25, 0.5, 0.75, 0.9})
    table.rows.push_back({cell(share), cell(quantile(peaks.at("exact"), share)),
                          cell(quantile(peaks.at("bullet"), share)), cell(quantile(peaks.at("ode"), share))});
  return table;
}

/// Until when a run agrees; beyond the horizon nothing is compared.
std::string agreement(const RunMetrics& row) {
  const bool to_horizon = row.horizon && *row.agreement_time >= *row.horizon;
  return fmt::format("until {} s{}", fixed(*row.agreement_time, 2),
                     to_horizon ? ", the horizon, at least" : "");
}

/// How often two samples of n values of one distribution are k/n apart or more, by Kolmogorov and Smirnov:
/// paths of n steps up and n down that come k from the middle, 2 Σ (−1)^(j+1) (2n choose n − jk)/(2n choose
/// n).
double chance_apart_by(int k, int n) {
  double sum = 0;
  for (int j = 1; j * k <= n; ++j)
    sum += (j % 2 == 1 ? 2 : -2) *
           std::exp(2 * std::lgamma(n + 1) - std::lgamma(n - j * k + 1) - std::lgamma(n + j * k + 1));
  return sum;
}

/// The least k/n that a test at a level of one in twenty rejects: k.
int least_rejected(int n) {
  constexpr double level = 0.05;
  int k = 1;
  while (chance_apart_by(k, n) > level) ++k;
  return k;
}

void add_engine(const std::string& name, const Peaks& peaks, LessonValues& values) {
  const std::vector<double>&exact = peaks.at("exact"), &engine = peaks.at(name);
  std::vector<double> apart;
  for (std::size_t i = 0; i < exact.size(); ++i) apart.push_back(std::abs(engine[i] - exact[i]) / exact[i]);
  const double distance = kolmogorov_smirnov(exact, engine).distance;
  const auto apart_by = static_cast<int>(std::lround(distance * seeds));
  values.numbers[name + "_median"] = percent(quantile(apart, 0.5), 0);
  values.numbers[name + "_most"] = percent(quantile(apart, 1.0), 0);
  values.numbers[name + "_distance"] = fixed(distance, 3);
  values.numbers[name + "_verdict"] = apart_by < least_rejected(seeds) ? "cannot be told apart"
                                      : apart_by == least_rejected(seeds)
                                          ? "differ, but by no more than that least distance"
                                          : "differ";
}

}  // namespace

LessonValues sensitivity_values(const Suite& suite, const std::vector<RunMetrics>& rows) {
  const NamedScene& named = suite.scenes.front();
  const Scene& scene = named.scene;
  const History exact = exact_answer(scene), changed = exact_answer(stronger(scene, change));
  const auto from_exact = [&](const History& other) { return differences_so_far(exact, other); };
  const std::vector<double> unseen = from_exact(exact_answer(stronger(scene, unseen_change))),
                            seen = from_exact(changed);
  const double parted_at = parting(exact.times, seen, parted);
  const Growth line = growth(exact.times, unseen);
  const Peaks peaks = peaks_over_seeds(named);
  const double changed_distance = kolmogorov_smirnov(peaks.at("exact"), peaks.at("changed")).distance;
  const int least = least_rejected(seeds);
  LessonValues values;
  values.numbers = {{"change", power(change, 0)},
                    {"small", power(unseen_change, 0)},
                    {"parted_exact", fixed(parted_at, 1)},
                    {"most", fixed(seen.back(), 2)},
                    {"lambda", fixed(line.rate, 1)},
                    {"doubling", fixed(std::log(2.0) / line.rate, 2)},
                    {"factor", fixed(std::exp(line.rate), 0)},
                    {"peak", fixed(peak_angles(exact)[1], 2)},
                    {"small_most", power(unseen.back(), 0)},
                    {"small_time", fixed(parting(exact.times, unseen, 0.999 * unseen.back()), 1)},
                    {"rest", fixed(exact.events.back().time, 1)},
                    {"parted", fixed(parted, 2)},
                    {"from", fixed(line.from, 1)},
                    {"until", fixed(line.until, 1)},
                    {"bullet_until", agreement(find_run(rows, "bullet", engine_step))},
                    {"ode_until", agreement(find_run(rows, "ode", engine_step))},
                    {"tolerance", fixed(suite.tolerance, 2)},
                    {"seeds", std::to_string(seeds)},
                    {"changed_distance", fixed(changed_distance, 3)},
                    {"least", fixed(1.0 * least / seeds, 3)},
                    {"least_odds", fixed(1 / chance_apart_by(least, seeds), 0)},
                    {"next", fixed(1.0 * (least - 1) / seeds, 3)},
                    {"next_odds", fixed(1 / chance_apart_by(least - 1, seeds), 0)}};
  values.numbers.merge(paths(exact, changed, unseen, line));
  int place = 0;
  for (const double share : {5e-4, 5e-3, 2e-2}) {
    const double time = parting(exact.times, from_exact(exact_answer(stronger(scene, share))), parted);
    values.numbers[fmt::format("slider_{}", ++place)] = fmt::format("{} %", 100 * share);
    values.numbers[fmt::format("parted_{}", place)] =
        time < 0 ? "never" : fmt::format("from {} s on", fixed(time, 2));
  }
  for (const char* engine : {"bullet", "ode"}) add_engine(engine, peaks, values);
  values.tables = {
      {"partings",
       partings(exact.times, {{"exact, ground changed by 1e-9 (s)", unseen},
                              {"exact, ground changed by 1e-6 (s)", seen},
                              {"Bullet, 1 ms (s)", from_exact(answer("bullet", scene, engine_step))},
                              {"ODE, 1 ms (s)", from_exact(answer("ode", scene, engine_step))}})},
      {"quantiles", quantiles(peaks)}};
  values.measured = {{"parted_exact", parted_at}};
  values.player = {.time = parted_at, .speed = 0.25, .gain = 5};
  return values;
}

}  // namespace rockstack
