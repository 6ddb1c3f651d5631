#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {
namespace {

constexpr double sample_step = 1e-3;  // s
constexpr double finer_step = 3e-4;   // s

History with_demands(const Scene& scene) {
  return solve(scene, {.sample_times = regular_times(1e-3, scene.duration), .validity = true});
}

/// How far an engine on a floor of that friction is from the exact motion, which does not slip; RMS, rad.
double slip_error(Scene scene, const char* engine, double friction, double dt) {
  scene.friction = {friction};
  return error_of(scene, answer(engine, scene, dt));
}

Table slipping(const Scene& scene) {
  Table table{{"friction of the scene", "Bullet: RMS difference (rad)", "ODE: RMS difference (rad)"}};
  for (const double friction : {0.05, 0.1, 0.13, 0.16, 0.2, 0.5})
    table.rows.push_back({cell(friction), fixed(slip_error(scene, "bullet", friction, sample_step), 4),
                          fixed(slip_error(scene, "ode", friction, sample_step), 4)});
  return table;
}

/// What falls of the ground, half a sine each, ask of the floor.
Table lifting(Scene scene) {
  Table table{{"ground falls with at most (g)", "least normal force (N)", "at (s)", "what the solver says"}};
  for (const double share : {0.25, 0.5, 0.75, 1.0, 1.25}) {
    scene.vertical = {};
    scene.vertical.pulse = {
        .shape = PulseShape::half_sine, .amplitude = -share * scene.gravity, .period = 0.4, .start = 0.1};
    const History history = with_demands(scene);
    const bool lifts = std::ranges::any_of(validity_warnings(scene, history), [](const std::string& warning) {
      return warning.find("lift off") != std::string::npos;
    });
    table.rows.push_back({cell(share), fixed(history.forces[0].least_normal, 1),
                          fixed(history.forces[0].least_normal_time, 4),
                          lifts ? "blocks would lift off" : "blocks stay on the ground"});
  }
  return table;
}

}  // namespace

LessonValues limits_values(const Suite& suite, const std::vector<RunMetrics>& rows) {
  const Scene& scene = suite.scenes.front().scene;
  const History history = with_demands(scene);
  const Demand& force = history.forces[0];
  const Demand& impulse = history.impulses[0];
  const double weight = weight_of(scene);
  return {
      .numbers = {{"force_friction", fixed(force.friction, 4)},
                  {"force_friction_time", fixed(force.friction_time, 2)},
                  {"enough_friction", fixed(std::max(force.friction, impulse.friction), 4)},
                  {"impulse_friction", fixed(impulse.friction, 4)},
                  {"impulse_friction_time", fixed(impulse.friction_time, 2)},
                  {"least_normal", fixed(force.least_normal, 0)},
                  {"least_share", percent(force.least_normal / weight, 1)},
                  {"weight", fixed(weight, 0)},
                  {"slippery", fixed(scene.friction.front(), 2)},
                  {"bullet_until", fixed(*find_run(rows, "bullet", sample_step).agreement_time, 2)},
                  {"ode_until", fixed(*find_run(rows, "ode", sample_step).agreement_time, 2)},
                  {"bullet_rough", fixed(slip_error(scene, "bullet", 0.5, sample_step), 4)},
                  {"bullet_rough_finer", fixed(slip_error(scene, "bullet", 0.5, finer_step), 4)},
                  {"finer_step", fixed(1e3 * finer_step, 1)},
                  {"duration", fixed(scene.duration, 0)},
                  {"tolerance", fixed(suite.tolerance, 2)}},
      .tables = {{"slipping", slipping(scene)}, {"lifting", lifting(scene)}},
      // When the engines have left the exact motion far enough for the eye.
      .player = {.time = *find_run(rows, "bullet", sample_step).agreement_time, .speed = 0.25, .gain = 3}};
}

}  // namespace rockstack
