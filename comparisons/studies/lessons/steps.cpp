#include <cmath>

#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {
namespace {

constexpr double iteration_step = 1e-3;  // s
constexpr double finest_step = 2e-5;     // s, of single precision beside double

Table over_steps(const std::vector<RunMetrics>& rows, const std::string& scene) {
  Table table{{"engine", "step (s)", "first impact, engine less exact (s)", "RMS angle difference (rad)",
               "agrees within tolerance until (s)"},
              {}};
  for (const RunMetrics& row : rows)
    if (row.dt && row.scene == scene && row.rms_angle_difference)
      table.rows.push_back({row.engine + ":" + row.solver, cell(*row.dt),
                            row.first_impact_time_difference ? cell(*row.first_impact_time_difference) : "",
                            cell(*row.rms_angle_difference), cell(*row.agreement_time)});
  return table;
}

Table over_iterations(const Scene& scene) {
  Table table{{"iterations", "ODE QuickStep: RMS (rad)", "Bullet sequential impulse: RMS (rad)"}, {}};
  for (const double count : {2.0, 5.0, 20.0, 100.0, 500.0})
    table.rows.push_back({cell(count),
                          cell(error_of(scene, answer("ode:quickstep", "tuned", scene, iteration_step,
                                                      {{"quickStepNumIterations", count}}))),
                          cell(error_of(scene, answer("bullet", "tuned", scene, iteration_step,
                                                      {{"numIterations", count}})))});
  return table;
}

/// Slope of the first impact's error between two steps, in logarithms.
double slope(const std::vector<RunMetrics>& rows, const std::string& engine, double large, double small) {
  const double first = std::abs(*find_run(rows, engine, "tuned", large).first_impact_time_difference);
  const double second = std::abs(*find_run(rows, engine, "tuned", small).first_impact_time_difference);
  return std::log(first / second) / std::log(large / small);
}

}  // namespace

LessonValues steps_values(const Suite& suite, const std::vector<RunMetrics>& rows) {
  const NamedScene& scene = suite.scenes.front();
  const auto rms = [&](const char* engine, double dt) {
    return power(*find_run(rows, engine, "tuned", dt).rms_angle_difference, 1);
  };
  const auto finer = [&](const char* engine) {
    return power(error_of(scene.scene, answer(engine, "tuned", scene.scene, finest_step)), 1);
  };
  const double first_impact = first_event(exact_answer(scene.scene), EventKind::impact)->time;
  return {
      .numbers = {{"bullet_slope", fixed(slope(rows, "bullet", 1e-2, 1e-4), 2)},
                  {"ode_slope", fixed(slope(rows, "ode", 1e-2, 1e-4), 2)},
                  {"bullet_share",
                   fixed(*find_run(rows, "bullet", "tuned", 1e-3).first_impact_time_difference / 1e-3, 2)},
                  {"ode_share",
                   fixed(*find_run(rows, "ode", "tuned", 1e-3).first_impact_time_difference / 1e-3, 2)},
                  {"tolerance", fixed(suite.tolerance, 2)},
                  {"bullet_coarse", rms("bullet", 1e-2)},
                  {"bullet_fine", rms("bullet", 1e-4)},
                  {"ode_coarse", rms("ode", 1e-2)},
                  {"ode_fine", rms("ode", 1e-4)},
                  {"single_fine", rms("bullet-single", 1e-4)},
                  {"bullet_middle", rms("bullet", 1e-3)},
                  {"single_middle", rms("bullet-single", 1e-3)},
                  {"single_finer", finer("bullet-single")},
                  {"double_finer", finer("bullet")},
                  {"gravity_step", power(scene.scene.gravity * finest_step, 1)},
                  {"single_rounding", power(std::ldexp(1.0, -24), 1)}},
      .tables = {{"steps", over_steps(rows, scene.name)}, {"iterations", over_iterations(scene.scene)}},
      .player = {.time = first_impact - 0.005, .speed = 0.01, .gain = 10, .overlaid = true},
      .measured = {{"first_impact_in_steps",
                    *find_run(rows, "ode", "tuned", 1e-3).first_impact_time_difference / 1e-3},
                   {"rms_fall", *find_run(rows, "ode", "tuned", 1e-2).rms_angle_difference /
                                    *find_run(rows, "ode", "tuned", 1e-4).rms_angle_difference}}};
}

}  // namespace rockstack
