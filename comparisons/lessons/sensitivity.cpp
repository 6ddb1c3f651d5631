#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analytic/scene/input/scene_file.hpp"
#include "analytic/solve.hpp"
#include "comparisons/lessons/answers.hpp"
#include "comparisons/lessons/values.hpp"
#include "comparisons/lessons/wording.hpp"
#include "comparisons/statistics/kolmogorov_smirnov.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

constexpr double change = 1e-9;  // of the ground's acceleration, as a share
constexpr int seeds = 30;
constexpr double engine_step = 1e-3;  // s

Scene stronger(Scene scene, double share) {
  for (double& sample : scene.horizontal.samples) sample *= 1 + share;
  return scene;
}

/// When the top block's angles first differ by that much, s; negative if never.
double parting(const History& a, const History& b, double size) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    if (std::abs(a.angles_at(i)[1] - b.angles_at(i)[1]) > size) return a.times[i];
  return -1;
}

/// One column of partings.
struct Other {
  const char* label;
  const History& history;
};

Table partings(const History& exact, const std::vector<Other>& others) {
  Table table{{"difference of θ₂ (rad)"}, {}};
  for (const Other& other : others) table.columns.emplace_back(other.label);
  for (const double size : {1e-8, 1e-6, 1e-4, 1e-3, 1e-2}) {
    table.rows.push_back({cell(size)});
    for (const Other& other : others) {
      const double time = parting(exact, other.history, size);
      table.rows.back().push_back(time < 0 ? "never" : cell(time));
    }
  }
  return table;
}

double peak_of_top(const History& history) {
  double most = 0;
  for (std::size_t i = 0; i < history.size(); ++i) most = std::max(most, std::abs(history.angles_at(i)[1]));
  return most;
}

/// Peaks of the top block over many earthquakes, in the order of the seeds.
struct Peaks {
  std::vector<double> exact, changed, bullet, ode;
};

Peaks peaks_over_seeds(const NamedScene& named) {
  Peaks peaks;
  const auto file = shipped("scenes") / (named.name + ".toml");
  for (int seed = 1; seed <= seeds; ++seed) {
    const Scene scene = read_scene(file, {fmt::format("ground.horizontal.synthetic={}", seed)});
    peaks.exact.push_back(solve(scene, {.peaks = true}).peaks[1]);
    peaks.changed.push_back(solve(stronger(scene, 1e-3), {.peaks = true}).peaks[1]);
    peaks.bullet.push_back(peak_of_top(answer("bullet", "tuned", scene, engine_step)));
    peaks.ode.push_back(peak_of_top(answer("ode", "tuned", scene, engine_step)));
  }
  return peaks;
}

/// The value below which that share of a sample lies.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

Table quantiles(const Peaks& peaks) {
  Table table{
      {"share of earthquakes below", "exact: largest |θ₂| (rad)", "Bullet, 1 ms (rad)", "ODE, 1 ms (rad)"},
      {}};
  for (const double share : {0.1, 0.25, 0.5, 0.75, 0.9})
    table.rows.push_back({cell(share), cell(quantile(peaks.exact, share)),
                          cell(quantile(peaks.bullet, share)), cell(quantile(peaks.ode, share))});
  return table;
}

std::vector<double> relative_differences(const std::vector<double>& exact, const std::vector<double>& other) {
  std::vector<double> list;
  for (std::size_t i = 0; i < exact.size(); ++i) list.push_back(std::abs(other[i] - exact[i]) / exact[i]);
  return list;
}

void add_engine(const std::string& name, const std::vector<double>& exact, const std::vector<double>& engine,
                LessonValues& values) {
  const std::vector<double> apart = relative_differences(exact, engine);
  const KolmogorovSmirnov test = kolmogorov_smirnov(exact, engine);
  values.numbers[name + "_median"] = percent(quantile(apart, 0.5), 0);
  values.numbers[name + "_most"] = percent(quantile(apart, 1.0), 0);
  values.numbers[name + "_distance"] = fixed(test.distance, 3);
  values.numbers[name + "_verdict"] = test.distance > test.critical ? "differ" : "cannot be told apart";
}

}  // namespace

LessonValues sensitivity_values(const Suite& suite, const std::vector<RunMetrics>& rows) {
  const NamedScene& named = suite.scenes.front();
  const Scene& scene = named.scene;
  const History exact = exact_answer(scene), changed = exact_answer(stronger(scene, change));
  const History thousandth = exact_answer(stronger(scene, 1e-3));
  const History bullet = answer("bullet", "tuned", scene, engine_step),
                ode = answer("ode", "tuned", scene, engine_step);
  const Peaks peaks = peaks_over_seeds(named);
  const KolmogorovSmirnov changed_test = kolmogorov_smirnov(peaks.exact, peaks.changed);
  LessonValues values;
  values.numbers = {
      {"change", power(change, 0)},
      {"parted_exact", fixed(parting(exact, changed, 1e-6), 2)},
      {"bullet_until", fixed(*find_run(rows, "bullet", "tuned", engine_step).agreement_time, 2)},
      {"ode_until", fixed(*find_run(rows, "ode", "tuned", engine_step).agreement_time, 2)},
      {"tolerance", fixed(suite.tolerance, 2)},
      {"seeds", std::to_string(seeds)},
      {"changed_distance", fixed(changed_test.distance, 3)},
      {"critical", fixed(changed_test.critical, 3)}};
  add_engine("bullet", peaks.exact, peaks.bullet, values);
  add_engine("ode", peaks.exact, peaks.ode, values);
  values.tables = {{"partings", partings(exact, {{"exact, ground changed by 1e-9 (s)", changed},
                                                 {"exact, ground changed by 1e-3 (s)", thousandth},
                                                 {"Bullet, 1 ms (s)", bullet},
                                                 {"ODE, 1 ms (s)", ode}})},
                   {"quantiles", quantiles(peaks)}};
  return values;
}

}  // namespace rockstack
