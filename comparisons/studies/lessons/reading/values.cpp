#include <fmt/format.h>

#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {
namespace {

constexpr double nominal = 1e-3;  // s

Table quartiles(const std::vector<std::pair<const char*, std::vector<double>>>& sets) {
  Table table{{"engine and set", "at 1 ms itself (rad)", "least of all (rad)", "lower quartile (rad)",
               "median (rad)", "upper quartile (rad)", "most of all (rad)"}};
  for (const auto& [name, errors] : sets)
    table.rows.push_back({name, cell(errors.front()), cell(quantile(errors, 0)), cell(quantile(errors, 0.25)),
                          cell(quantile(errors, 0.5)), cell(quantile(errors, 0.75)),
                          cell(quantile(errors, 1))});
  return table;
}

/// Impacts that match: of the engine, of the exact motion read at its steps, and by chance.
Table matches(const std::vector<RunMetrics>& rows) {
  Table table{{"run", "step (s)", "impacts, exact", "matched", "sampling limit: the exact motion itself",
               "chance level: random times", "chance level: shifted"}};
  for (const RunMetrics& row : rows) {
    if (!row.dt || !row.impacts_matched || !row.impacts_matched_null) continue;
    const auto count = [](const std::optional<int>& value) { return value ? std::to_string(*value) : ""; };
    table.rows.push_back({fmt::format("{} {}", row.engine, row.settings), cell(*row.dt),
                          std::to_string(*row.impacts_matched_null + *row.impacts_missed_null),
                          count(row.impacts_matched), count(row.impacts_matched_null),
                          count(row.impacts_matched_random), count(row.impacts_matched_shifted)});
  }
  return table;
}

}  // namespace

LessonValues reading_values(const Suite& suite, const std::vector<RunMetrics>& rows) {
  const std::vector<double> ode = errors_of_draws(suite, "ode", nominal),
                            bullet = errors_of_draws(suite, "bullet", nominal),
                            plain = errors_of_draws(suite, "ode", nominal, {}, "default");
  const MannWhitney engines = mann_whitney(ode, bullet), sets = mann_whitney(ode, plain);
  const RunMetrics& tuned = find_run(rows, "ode", nominal);
  return {.numbers = {{"draws", std::to_string(suite.replicates.runs)},
                      {"matched", std::to_string(*tuned.impacts_matched)},
                      {"matchable", std::to_string(*tuned.impacts_matched + *tuned.impacts_missed)},
                      {"one", power(ode.front(), 1)},
                      {"least", power(quantile(ode, 0), 1)},
                      {"median", power(quantile(ode, 0.5), 1)},
                      {"most", power(quantile(ode, 1), 1)},
                      {"factor", fixed(quantile(ode, 1) / quantile(ode, 0), 1)},
                      {"engines_share", percent(engines.superiority, 0)},
                      {"engines_p", power(engines.p_value, 1)},
                      {"sets_share", percent(sets.superiority, 0)},
                      {"sets_p", power(sets.p_value, 1)}},
          .tables = {{"quartiles",
                      quartiles({{"ODE, tuned", ode}, {"ODE, default", plain}, {"Bullet, tuned", bullet}})},
                     {"matches", matches(rows)}},
          .player = {.time = 0.55, .speed = 0.1, .gain = 3, .finest = true},
          .measured = {{"spread_factor", quantile(ode, 1) / quantile(ode, 0)}}};
}

}  // namespace rockstack
