#include <fmt/format.h>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/studies/lessons/mechanics.hpp"

namespace rockstack {
namespace {

constexpr double quoted_time = 1.0;     // s, where the paper gives the top block's angle
constexpr double quoted_angle = 0.183;  // rad, as the paper gives it
constexpr double visible_gap = 1e-3;    // rad, that shows above an engine's own wobble

/// The stack turning as one body until it lands: when, and how fast.
Event landing_of_one_body(Scene scene) {
  scene.blocks = {welded(scene)};
  scene.initial = {{scene.initial.angles.front()}, {0}};
  return *first_event(solve(scene), EventKind::impact);
}

/// The top block's angle at the quoted time if the stack lands as one body.
double angle_after(Scene scene, const Event& landed, const Landing& landing) {
  const double left = quoted_time - landed.time;
  scene.initial = {{0, 0}, {landing.base * landed.before[0], landing.top * landed.before[0]}};
  scene.duration = left;
  return solve(scene, {.sample_times = {left}}).angles_at(0)[1];
}

Table readings(const Scene& scene) {
  Table table{{"equations", "θ̇₁ after / before", "θ̇₂ after / before", "kinetic energy after / before"}};
  const auto add = [&](const char* label, const Misprints& misprints) {
    const Landing landing = land(scene, misprints);
    table.rows.push_back({label, cell(landing.base), cell(landing.top), cell(landing.energy)});
  };
  add("put right", {});
  add("(137) as printed", {.eq137 = true});
  add("(138) as printed", {.eq138 = true});
  add("both as printed", {true, true});
  return table;
}

Table first_events(const History& history) {
  Table table{{"time (s)", "event", "interface", "pattern before", "pattern after", "θ₁ (rad)", "θ₂ (rad)"}};
  constexpr std::size_t count = 6;
  for (const Event& event : history.events) {
    if (table.rows.size() == count) break;
    table.rows.push_back({cell(event.time), name(event.kind), std::to_string(event.interface),
                          name(event.from), name(event.to), cell(event.angles[0]), cell(event.angles[1])});
  }
  return table;
}

/// When the gap between the blocks can first be seen in sampled motion, s; negative where it never can.
double first_gap(const History& history) {
  for (std::size_t i = 0; i < history.size(); ++i)
    if (std::abs(relative_at(history.angles_at(i), 1)) > visible_gap) return history.times[i];
  return -1;
}

Table solvers(const Scene& scene, const History& exact) {
  Table table{{"solver", "gap of 0.001 rad between the blocks at (s)", "θ₂ at 1 s (rad)"}};
  const auto add = [&](const char* label, const History& history) {
    table.rows.push_back({label, cell(first_gap(history)), cell(angle_at(history, 1, quoted_time))});
  };
  add("exact", exact);
  add("Bullet, tuned, 0.1 ms", answer("bullet", scene, 1e-4));
  add("ODE, tuned, 0.1 ms", answer("ode", scene, 1e-4));
  return table;
}

/// The paper's example with a top block of that height, in m.
History with_top(double height) {
  return solve(read_shipped("spanos-free-rocking", {fmt::format("blocks.2.height={}", height)}));
}

/// Above 0 where the blocks part before they land.
double parts_first(double height) {
  return with_top(height).events.front().kind == EventKind::opening ? 1 : -1;
}

}  // namespace

LessonValues separation_values(const Suite& suite, const std::vector<RunMetrics>& rows) {
  const Scene& scene = suite.scenes.front().scene;
  const History history = exact_answer(scene, 1e-4);
  const Event& opening = *first_event(history, EventKind::opening);
  const Event& impact = *first_event(history, EventKind::impact);
  const Event landed = landing_of_one_body(scene);
  const Landing right = land(scene, {}), printed = land(scene, {true, true});
  const double height = 2 * scene.blocks.back().half_height;
  constexpr double lower = 2;  // m
  // The top block stands on the base, whose face is the wider one.
  const double start = reactions_of(scene, history).at(1).centre / scene.blocks.back().half_width;
  return {.numbers = {{"opening", fixed(opening.time, 4)},
                      {"centre_start", percent(start, 0)},
                      {"height", fixed(height, 1)},
                      {"lower", fixed(lower, 1)},
                      {"lower_opening", fixed(first_event(with_top(lower), EventKind::opening)->time, 4)},
                      {"least_height", fixed(crossing(1, height, parts_first), 2)},
                      {"opening_angle", fixed(opening.angles[0], 4)},
                      {"impact", fixed(impact.time, 4)},
                      {"impact_from", name(impact.from)},
                      {"impact_to", name(impact.to)},
                      {"gap", fixed(impact.angles[1] - impact.angles[0], 4)},
                      {"angle", fixed(std::abs(angle_at(history, 1, quoted_time)), 4)},
                      {"quoted", fixed(quoted_angle, 3)},
                      {"one_body_landing", fixed(landed.time, 4)},
                      {"one_body_angle", fixed(std::abs(angle_after(scene, landed, right)), 4)},
                      {"printed_angle", fixed(std::abs(angle_after(scene, landed, printed)), 4)},
                      {"right_base", fixed(right.base, 3)},
                      {"only138_base", fixed(land(scene, {.eq138 = true}).base, 3)},
                      {"only138_energy", fixed(land(scene, {.eq138 = true}).energy, 3)},
                      {"printed_energy", fixed(printed.energy, 3)},
                      {"gain", percent(printed.energy - 1, 0)},
                      {"loss", percent(1 - right.energy, 0)},
                      {"bullet_rms", power(*find_run(rows, "bullet", 1e-4).rms_angle_difference, 1)},
                      {"ode_rms", power(*find_run(rows, "ode", 1e-4).rms_angle_difference, 1)}},
          .tables = {{"readings", readings(scene)},
                     {"events", first_events(history)},
                     {"solvers", solvers(scene, history)}},
          .player = {.time = opening.time - 0.02, .speed = 0.05, .gain = 4}};
}

}  // namespace rockstack
