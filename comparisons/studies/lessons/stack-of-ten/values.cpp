#include <fmt/format.h>

#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {
namespace {

// A column of blocks at rest as a solver sees it: n unknown forces, of which each contact's depends on those
// of its neighbours alone. A Gauss–Seidel sweep puts them right one after the other, from below.

/// One sweep over what is wrong with the forces: each is put right as the neighbours' errors allow.
void sweep_errors(const std::vector<double>& masses, std::vector<double>& errors) {
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const double below = k > 0 ? 1 / masses[k - 1] : 0, above = 1 / masses[k];
    const double pull =
        (k > 0 ? below * errors[k - 1] : 0) + (k + 1 < errors.size() ? above * errors[k + 1] : 0);
    errors[k] = pull / (below + above);
  }
}

/// How many sweeps leave a tenth of an error that was swept for long.
double sweeps_a_digit(const std::vector<double>& masses) {
  std::vector<double> errors(masses.size(), 1);
  double kept = 1;
  constexpr int settled = 20'000;
  for (int i = 0; i < settled; ++i) {
    sweep_errors(masses, errors);
    kept = std::ranges::max(errors);
    for (double& error : errors) error /= kept;
  }
  return std::log(10) / -std::log(kept);
}

/// Sweeps that ten blocks need where one of them is that many times as heavy as each other.
double sweeps_with_heavy(double ratio, std::size_t place) {
  std::vector<double> masses(10, 1);
  masses[place] = ratio;
  return sweeps_a_digit(masses);
}

/// The share of the error that a sweep leaves of n equal blocks is cos²(π/2n).
double sweeps_of_equal(double blocks) {
  return std::log(10) / (-2 * std::log(std::cos(pi<double> / (2 * blocks))));
}

Table heavy_ones() {
  Table table{{"mass over each other's", "heavy at the top: sweeps a digit", "heavy at the bottom"}};
  for (const double ratio : {1, 10, 100})
    table.rows.push_back(
        {cell(ratio), fixed(sweeps_with_heavy(ratio, 9), 0), fixed(sweeps_with_heavy(ratio, 0), 0)});
  return table;
}

constexpr std::array sweeps_made{10, 40, 160};

const RunMetrics& row_with_sweeps(const std::vector<RunMetrics>& rows, const std::string& scene,
                                  const std::string& solver, int sweeps) {
  return *std::ranges::find_if(rows, [&](const RunMetrics& row) {
    return row.scene == scene && row.engine + ":" + row.solver == solver &&
           row.settings.ends_with(fmt::format("Iterations={}", sweeps));
  });
}

/// A median with its quartiles, mm.
std::string median_off(const RunMetrics& row) {
  return fmt::format("{} ({} to {})", fixed(1e3 * *row.rms_position_difference, 2),
                     fixed(1e3 * *row.rms_position_difference_lower, 2),
                     fixed(1e3 * *row.rms_position_difference_upper, 2));
}

Table held_by_engines(const Suite& suite, const std::vector<RunMetrics>& rows) {
  Table table{{"solver", "sweeps", "equal blocks: off by (mm)", "ten times as heavy on top: off by (mm)"}};
  for (const auto& [label, solver] : {std::pair{"ODE, quickstep", "ode:quickstep"},
                                      {"Bullet, sequential impulses", "bullet:sequential-impulse"}})
    for (const int sweeps : sweeps_made)
      table.rows.push_back({label, std::to_string(sweeps),
                            median_off(row_with_sweeps(rows, suite.scenes[0].name, solver, sweeps)),
                            median_off(row_with_sweeps(rows, suite.scenes[1].name, solver, sweeps))});
  return table;
}

}  // namespace

LessonValues stack_of_ten_values(const Suite& suite, const std::vector<RunMetrics>& rows) {
  const std::string &equal = suite.scenes[0].name, &heavy = suite.scenes[1].name;
  const auto creep = [&](const std::string& scene, int sweeps) {
    return fixed(1e3 * row_with_sweeps(rows, scene, "bullet:sequential-impulse", sweeps).creep.value_or(0),
                 1);
  };
  const auto sunk = [&](const std::string& scene, int sweeps) {
    return fixed(1e3 * row_with_sweeps(rows, scene, "ode:quickstep", sweeps).sinking.value_or(0), 2);
  };
  const double ten = sweeps_of_equal(10), heavy_top = sweeps_with_heavy(10, 9);
  return {.numbers = {{"draws", std::to_string(suite.replicates.runs)},
                      {"ten", fixed(ten, 0)},
                      {"heavy", fixed(heavy_top, 0)},
                      {"heavy_bottom", fixed(sweeps_with_heavy(10, 0), 0)},
                      {"left", percent(std::pow(0.1, 10 / ten), 0)},
                      {"creep_few", creep(equal, 10)},
                      {"creep_many", creep(equal, 160)},
                      {"creep_heavy", creep(heavy, 10)},
                      {"sunk_few", sunk(equal, 10)},
                      {"sunk_heavy", sunk(heavy, 10)}},
          .tables = {{"heavy", heavy_ones()}, {"engines", held_by_engines(suite, rows)}},
          .player = {.time = 0.9, .speed = 0.1, .gain = 10},
          .measured = {{"ten", std::round(ten)}, {"heavy_ratio", heavy_top / ten}}};
}

}  // namespace rockstack
