#include <fmt/format.h>

#include "comparisons/studies/lessons/inside-a-solver/sweeps.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {
namespace {

constexpr double sweeping_step = 0.01;  // s
constexpr double sinking_time = 1;      // s
constexpr double nearly_solved = 0.01;  // share that a contact may lack
constexpr double bullet_keeps = 0.85;   // of its impulses, as it comes
constexpr double heavy_top = 10;        // times as heavy as another block

SweptStack stack_of(const Scene& scene) {
  SweptStack stack = equal_blocks(scene.blocks.size());
  stack.masses = mapped(scene.blocks, &Block::mass);
  return stack;
}

/// What the contacts give in a first step, N·s.
std::vector<double> first_step(const Scene& scene, int sweeps) {
  SweptStack stack = stack_of(scene);
  begin_step(stack, scene.gravity * sweeping_step, 0);
  for (int i = 0; i < sweeps; ++i) sweep(stack, true);
  return stack.impulses;
}

/// Share of its weight that the ground lacks in the first step.
double ground_lacks(const Scene& scene, int sweeps) {
  return 1 - first_step(scene, sweeps).front() / (weight_of(scene) * sweeping_step);
}

double sunk(const Scene& scene, int sweeps, double kept, double time = sinking_time) {
  return sinking(stack_of(scene), sweeps, kept, sweeping_step, time, scene.gravity);
}

/// The whole weight above each contact, and what sweeps come to.
Table contact_forces(const Scene& scene) {
  constexpr std::array counts{1, 10, 50};
  constexpr double kilo = 1000;
  Table table{{"contact under block", "weight that it carries (kN)", "exact solver (kN)"}};
  for (const int count : counts)
    table.columns.push_back(fmt::format("after {} sweep{} (kN)", count, count == 1 ? "" : "s"));
  const History exact = exact_answer(scene);
  const std::vector<double> weights = carrying_impulses(stack_of(scene), scene.gravity);
  for (std::size_t i = weights.size(); i-- > 0;) {
    table.rows.push_back(
        {std::to_string(i + 1), fixed(weights[i] / kilo, 3), fixed(exact.reactions[i].normal / kilo, 3)});
    for (const int count : counts)
      table.rows.back().push_back(fixed(first_step(scene, count)[i] / sweeping_step / kilo, 3));
  }
  return table;
}

/// How far an engine lets the top block sink, m.
double sunk_in(const std::string& engine, const Scene& scene, const Parameters& parameters) {
  const History history = answer(engine, scene, sweeping_step, parameters);
  return history.centres[2 * scene.blocks.size() - 1] - history.centres.back();
}

double sunk_in_bullet(const Scene& scene, double sweeps, double kept) {
  return sunk_in("bullet", scene, {{"numIterations", sweeps}, {"warmstartingFactor", kept}});
}

Table engines_sink(const Scene& scene) {
  Table table{{"sweeps", "the iteration, cold", "QuickStep, cold", "Bullet, cold", "the iteration, 85 % kept",
               "Bullet, 85 % kept"}};
  for (const int sweeps : {2, 5, 10, 20, 50}) {
    table.rows.push_back({std::to_string(sweeps)});
    for (const double metres :
         {sunk(scene, sweeps, 0), sunk_in("ode:quickstep", scene, {{"quickStepNumIterations", sweeps}}),
          sunk_in_bullet(scene, sweeps, 0), sunk(scene, sweeps, bullet_keeps),
          sunk_in_bullet(scene, sweeps, bullet_keeps)})
      table.rows.back().push_back(fixed(1000 * metres, 2));
  }
  return table;
}

/// What a sweep leaves under one block that stands on two corners: the square of how much an impulse at the
/// one moves the other, beside the corner itself, (1 − q)/(1 + q) with q = m b²/I.
double left_by_corners(const Block& block) {
  const double q = block.mass * block.half_width * block.half_width / block.inertia;
  return std::pow((1 - q) / (1 + q), 2);
}

/// The momentum that the ground takes from a block that falls flat, by the exact solver, N·s.
double landing_impulse(const Scene& scene, const Event& impact) {
  constexpr std::size_t before = 3, after = 5;  // vertical velocities, in rows of x and y
  return scene.blocks.front().mass * (impact.centres[after] - impact.centres[before]);
}

}  // namespace

LessonValues inside_a_solver_values(const Suite& suite, const std::vector<RunMetrics>&) {
  const Scene& scene = suite.scenes.front().scene;
  const std::size_t count = scene.blocks.size();
  const Scene dropped = read_shipped("dropped-block");
  const Block& cube = dropped.blocks.front();
  const History fall = exact_answer(dropped);
  const Event& landing = *first_event(fall, EventKind::impact);
  SweptStack heavy = equal_blocks(count);
  heavy.masses.back() = heavy_top;
  const double first = 1 - ground_lacks(scene, 1);
  const int five = sweeps_until(equal_blocks(count), nearly_solved);
  const int ten = sweeps_until(equal_blocks(2 * count), nearly_solved);
  const double creep =
      (sunk(scene, 10, 0) - sunk(scene, 10, 0, sinking_time - sweeping_step)) / sweeping_step;
  return {.numbers = {{"cube_mass", fixed(cube.mass, 0)},
                      {"cube_speed", fixed(*landing.approach, 3)},
                      {"cube_impulse",
                       fixed(cube.mass * std::sqrt(2 * dropped.gravity * dropped.initial.gaps.front()), 1)},
                      {"cube_exact", fixed(landing_impulse(dropped, landing), 1)},
                      {"step", fixed(1000 * sweeping_step, 0)},
                      {"steps", fixed(sinking_time / sweeping_step, 0)},
                      {"first_share", percent(first, 0)},
                      {"sweeps_two", std::to_string(sweeps_until(equal_blocks(2), nearly_solved))},
                      {"sweeps_five", std::to_string(five)},
                      {"sweeps_ten", std::to_string(ten)},
                      {"sweeps_heavy", std::to_string(sweeps_until(heavy, nearly_solved))},
                      {"ten_times", fixed(static_cast<double>(ten) / five, 1)},
                      {"left_five", percent(left_by_sweep(count), 1)},
                      {"left_ten", percent(left_by_sweep(2 * count), 1)},
                      {"ten_lacks", percent(ground_lacks(scene, 10), 0)},
                      {"twenty_lacks", percent(ground_lacks(scene, 20), 0)},
                      {"creep", fixed(1000 * creep, 0)},
                      {"bullet_share",
                       percent(sunk_in_bullet(scene, 20, bullet_keeps) / sunk_in_bullet(scene, 20, 0), 1)},
                      {"page_share", percent(sunk(scene, 20, bullet_keeps) / sunk(scene, 20, 0), 1)},
                      {"corners_cube", percent(left_by_corners(cube), 0)},
                      {"corners_flat", percent(left_by_corners(scene.blocks.front()), 0)}},
          .tables = {{"contacts", contact_forces(scene)}, {"engines", engines_sink(scene)}},
          .player = {.time = 0.3, .speed = 0.25, .overlaid = false},
          .measured = {
              {"first_share", first}, {"sweeps_five", five}, {"ten_times", static_cast<double>(ten) / five}}};
}

}  // namespace rockstack
