#include <fmt/format.h>

#include <Eigen/Core>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/difference.hpp"
#include "comparisons/measures/metrics/leans.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {
namespace {

constexpr double iteration_step = 1e-3;  // s
constexpr double finest_step = 2e-5;     // s, of single precision beside double

/// The least and the largest error of an engine's first impact over its steps, each in its own steps and the
/// median of replicates.
std::string shares(const std::vector<RunMetrics>& rows, const std::string& engine) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const RunMetrics& row : rows) {
    if (row.engine != engine || !row.dt || !row.first_impact_time_difference) continue;
    const double share = *row.first_impact_time_difference / *row.dt;
    least = std::min(least, share), most = std::max(most, share);
  }
  return fmt::format("{} to {}", fixed(least, 2), fixed(most, 2));
}

/// Until when how many replicates of a row agree, as its outcome begins: "to the end in 3 of 5 replicates".
std::string agreement_words(const RunMetrics& row) {
  constexpr std::string_view verb = "agrees ";
  const std::string first = row.outcome.substr(0, row.outcome.find(';'));
  return first.starts_with(verb) ? first.substr(verb.size()) : first;
}

Table over_steps(const std::vector<RunMetrics>& rows, const NamedScene& scene) {
  Table table{{"engine", "step (s)", "first impact, engine less exact (s)", "RMS angle difference (rad)",
               "lower quartile (rad)", "upper quartile (rad)", "agrees within the tolerance"}};
  for (const RunMetrics& row : rows)
    if (row.dt && row.scene == scene.name && row.rms_angle_difference)
      table.rows.push_back({row.engine + " " + row.solver, cell(*row.dt),
                            row.first_impact_time_difference ? cell(*row.first_impact_time_difference) : "",
                            cell(*row.rms_angle_difference), cell(*row.rms_angle_difference_lower),
                            cell(*row.rms_angle_difference_upper), agreement_words(row)});
  return table;
}

/// "0.0012 (0.0008 to 0.0015)": median and quartiles.
std::string spread_words(const std::vector<double>& errors) {
  return fmt::format("{:.2g} ({:.2g} to {:.2g})", median(errors), quantile(errors, 0.25),
                     quantile(errors, 0.75));
}

Table over_iterations(const Suite& suite) {
  Table table{{"iterations", "ODE QuickStep: RMS (rad), median (quartiles)",
               "Bullet sequential impulse: RMS (rad), median (quartiles)"}};
  const auto with = [&](const char* engine, const char* name, double count) {
    return spread_words(errors_of_draws(suite, engine, iteration_step, {{name, count}}));
  };
  for (const double count : {2.0, 5.0, 20.0, 100.0})
    table.rows.push_back({cell(count), with("ode:quickstep", "quickStepNumIterations", count),
                          with("bullet", "numIterations", count)});
  return table;
}

/// What the sliders show of Planck, where it is installed: when it has left the exact motion by the tolerance
/// at the largest step, and when with the fewest iterations.
std::string planck_answer(const Scene& scene, double tolerance) {
  if (engines_called("planck").empty()) return "Planck is not installed here.";
  constexpr double largest = 0.02, usual = 1e-3;  // s
  const auto until = [&](double dt, const Parameters& changes) {
    const History run = answer("planck", scene, dt, changes);
    return agreement_time(difference(solve(scene, {.sample_times = run.times}), run), tolerance);
  };
  const double by_step = until(largest, {}), by_iterations = until(usual, {{"velocityIterations", 1}});
  return fmt::format(
      "The {}. At a step of {} ms Planck has left the exact motion by {} rad at {} s; at {} ms and with a single velocity "
      "iteration at {} s.",
      by_step < by_iterations ? "step" : "iterations", 1e3 * largest, tolerance, fixed(by_step, 2),
      1e3 * usual, fixed(by_iterations, 2));
}

/// A block on its corner, let go: θ̈ = −p² sin(α − θ).
struct FallingBlock {
  double rate2, slenderness;  ///< p², 1/s², and α, rad
  double acceleration(double angle) const { return -rate2 * std::sin(slenderness - angle); }
};

/// Angle and angular velocity.
using FallState = Eigen::Vector2d;

FallState explicit_euler_step(const FallingBlock& falling, const FallState& from, double dt) {
  return from + dt * FallState{from[1], falling.acceleration(from[0])};
}

FallState euler_step(const FallingBlock& falling, const FallState& from, double dt) {
  const double velocity = from[1] + dt * falling.acceleration(from[0]);
  return {from[0] + dt * velocity, velocity};
}

FallState fourth_order_step(const FallingBlock& falling, const FallState& from, double dt) {
  const auto rate = [&](double share, const FallState& slope) {
    const FallState at = from + share * dt * slope;
    return FallState{at[1], falling.acceleration(at[0])};
  };
  const FallState a = rate(0, {0, 0}), b = rate(0.5, a), c = rate(0.5, b), d = rate(1, c);
  return from + dt / 6 * (a + 2 * b + 2 * c + d);
}

/// When the block is down: the end of the step in which it lands, and the time within that step at which it
/// does, s.
std::pair<double, double> landing_by_steps(FallState (*step)(const FallingBlock&, const FallState&, double),
                                           const FallingBlock& falling, double angle, double dt) {
  FallState state{angle, 0}, next = step(falling, state, dt);
  int done = 0;
  for (; next[0] > 0; ++done) {
    state = next;
    next = step(falling, state, dt);
  }
  const double within = crossing(0, dt, [&](double time) { return step(falling, state, time)[0]; });
  return {(done + 1) * dt, done * dt + within};
}

FallingBlock falling_block(const Scene& scene) {
  const Block& block = scene.blocks.front();
  const double b = block.half_width, h = block.half_height, radius2 = b * b + h * h;
  return {block.mass * scene.gravity * std::sqrt(radius2) / (block.inertia + block.mass * radius2),
          std::atan2(b, h)};
}

constexpr double fall_time = 0.4;  // s, before the block lands

/// State of the fall after fall_time by steps of that length, which divide it.
FallState fallen(FallState (*step)(const FallingBlock&, const FallState&, double), const Scene& scene,
                 double dt) {
  const FallingBlock falling = falling_block(scene);
  FallState state{scene.initial.angles.front(), 0};
  for (int i = 0; i < std::lround(fall_time / dt); ++i) state = step(falling, state, dt);
  return state;
}

/// Housner's block by three schemes and two engines, beside the exact one, after fall_time: as numbers.
std::map<std::string, std::string> fall_numbers(const Scene& scene) {
  constexpr double dt = 1e-2, fine = 1e-4;  // s
  const double exact = angle_at(exact_answer(scene), 0, fall_time);
  const double speed = -fallen(fourth_order_step, scene, fine)[1];
  const auto steps = [&](double off) { return fixed(std::abs(off) / speed / dt, 2); };
  Json engines = Json::array();
  std::string leads;
  for (const auto& [name, engine] : {std::pair{"Bullet", "bullet"}, {"ODE", "ode"}}) {
    Json errors = Json::array();
    for (const double step : {dt, dt / 5, dt / 10})
      errors.push_back({step, angle_at(answer(engine, scene, step), 0, fall_time) - exact});
    leads += (leads.empty() ? "" : " and ") + steps(errors[0][1].get<double>());
    engines.push_back({name, errors});
  }
  return {{"fall_exact", cell(exact)},
          {"fall_engines", engines.dump()},
          {"euler_steps", steps(fallen(explicit_euler_step, scene, dt)[0] - exact)},
          {"semi_steps", steps(fallen(euler_step, scene, dt)[0] - exact)},
          {"engine_steps", leads}};
}

/// One fall by two methods, with the landing at the end of its step and where it is in it, less the exact
/// time.
Table by_steps(const Scene& scene) {
  const FallingBlock falling = falling_block(scene);
  const double exact = first_event(exact_answer(scene), EventKind::impact)->time;
  Table table{{"step (s)", "semi-implicit Euler, end of step (s)", "Runge–Kutta of order 4, end of step (s)",
               "semi-implicit Euler, in the step (s)", "Runge–Kutta of order 4, in the step (s)"}};
  std::vector<double> first, last;
  constexpr double coarsest = 0.04, finest = 0.0025;  // s
  for (double dt = coarsest; dt >= finest; dt /= 2) {
    const double angle = scene.initial.angles.front();
    const auto [euler_end, euler_within] = landing_by_steps(euler_step, falling, angle, dt);
    const auto [fourth_end, fourth_within] = landing_by_steps(fourth_order_step, falling, angle, dt);
    last = {euler_end - exact, fourth_end - exact, euler_within - exact, fourth_within - exact};
    if (first.empty()) first = last;
    table.rows.push_back({cell(dt)});
    for (const double error : last) table.rows.back().push_back(cell(error));
  }
  table.rows.push_back({"order, first to last", "none", "none"});
  for (std::size_t i = 2; i < last.size(); ++i)
    table.rows.back().push_back(
        fixed(std::log(std::abs(first[i] / last[i])) / std::log(coarsest / finest), 2));
  return table;
}

/// Slope of the first impact's error between two steps, in logarithms.
double slope(const std::vector<RunMetrics>& rows, const std::string& engine, double large, double small) {
  const double first = std::abs(*find_run(rows, engine, large).first_impact_time_difference);
  const double second = std::abs(*find_run(rows, engine, small).first_impact_time_difference);
  return std::log(first / second) / std::log(large / small);
}

}  // namespace

LessonValues steps_values(const Suite& suite, const std::vector<RunMetrics>& rows) {
  const NamedScene& scene = suite.scenes.front();
  const auto rms = [&](const char* engine, double dt) {
    const RunMetrics& row = find_run(rows, engine, dt);
    return fmt::format("{} ({} to {})", power(*row.rms_angle_difference, 1),
                       power(*row.rms_angle_difference_lower, 1), power(*row.rms_angle_difference_upper, 1));
  };
  // From the coarsest step to the finest: by the medians, and by the quartiles at the least and at the most.
  using Number = std::optional<double> RunMetrics::*;
  const auto fall = [&](const char* engine, Number from = &RunMetrics::rms_angle_difference,
                        Number to = &RunMetrics::rms_angle_difference) {
    return *(find_run(rows, engine, 1e-2).*from) / *(find_run(rows, engine, 1e-4).*to);
  };
  const auto falls = [&](const char* engine) {
    constexpr Number lower = &RunMetrics::rms_angle_difference_lower,
                     upper = &RunMetrics::rms_angle_difference_upper;
    return fmt::format("{} times ({} to {})", fixed(fall(engine), 0), fixed(fall(engine, lower, upper), 0),
                       fixed(fall(engine, upper, lower), 0));
  };
  const double landing_time =
      first_event(exact_answer(read_shipped("housner-block")), EventKind::impact)->time;
  Suite few = suite;
  set_runs(few.replicates, 3);
  const auto finer = [&](const char* engine) {
    return power(median(errors_of_draws(few, engine, finest_step)), 1);
  };
  const double first_impact = first_event(exact_answer(scene.scene), EventKind::impact)->time;
  std::map<std::string, std::string> falls_by_steps = fall_numbers(read_shipped("housner-block"));
  LessonValues values{
      .numbers = {{"bullet_slope", fixed(slope(rows, "bullet", 1e-2, 1e-4), 2)},
                  {"ode_slope", fixed(slope(rows, "ode", 1e-2, 1e-4), 2)},
                  {"bullet_shares", shares(rows, "bullet")},
                  {"ode_shares", shares(rows, "ode")},
                  {"ode_share", fixed(*find_run(rows, "ode", 1e-3).first_impact_time_difference / 1e-3, 2)},
                  {"tolerance", fixed(suite.tolerance, 2)},
                  {"peak", fixed(std::ranges::max(peak_angles(exact_answer(scene.scene))), 2)},
                  {"seen_at", fixed(std::ceil(landing_time / 0.01) * 0.01, 2)},
                  {"draws", std::to_string(suite.replicates.runs)},
                  {"few", std::to_string(few.replicates.runs)},
                  {"bullet_fall", falls("bullet")},
                  {"ode_fall", falls("ode")},
                  {"planck_answer", planck_answer(scene.scene, suite.tolerance)},
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
      .tables = {{"steps", over_steps(rows, scene)},
                 {"iterations", over_iterations(suite)},
                 {"by_steps", by_steps(read_shipped("housner-block"))}},
      .player = {.time = first_impact - 0.005, .speed = 0.01, .gain = 10, .overlaid = true},
      .measured = {
          {"first_impact_in_steps", *find_run(rows, "ode", 1e-3).first_impact_time_difference / 1e-3},
          {"rms_fall", fall("ode")}}};
  values.numbers.merge(falls_by_steps);
  return values;
}

}  // namespace rockstack
