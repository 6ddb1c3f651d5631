#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/studies/lessons/mechanics.hpp"

namespace rockstack {
namespace {

double ratio_of(const Block& block) {
  return block.half_height / block.half_width;
}

Scene with_friction(Scene scene, double friction) {
  scene.law = Law::unilateral;
  scene.friction.assign(scene.blocks.size(), friction);
  return scene;
}

/// The block just before an impact, so fast that the ground's force points straight up: m g h = ω² I about
/// the corner. Whatever slips, slips at the impact.
Scene before_impact(Scene scene, double friction) {
  const Block& block = scene.blocks.front();
  const double arm = std::hypot(block.half_width, block.half_height);
  const double speed =
      std::sqrt(block.mass * scene.gravity * block.half_height / (block.inertia + block.mass * arm * arm));
  scene.initial = {{0.01}, {-speed}};
  scene.duration = 0.02 / speed;
  return with_friction(std::move(scene), friction);
}

/// Angular velocity after over before the first impact, by an engine, read a fifth of the time later.
double engine_ratio(const char* engine, const Scene& scene, const Event& impact) {
  constexpr double dt = 1e-5;
  const History history = answer(engine, scene, dt);
  const double later = 1.2 * impact.time;
  std::size_t at = 0;
  while (at + 1 < history.size() && history.times[at] < later) ++at;
  return history.velocities_at(at)[0] / impact.before[0];
}

Table impact_ratios(const Scene& scene) {
  const double r = ratio_of(scene.blocks.front());
  Table table{{"friction", "slips", "ω⁺/ω⁻, closed form", "ω⁺/ω⁻, exact solver", "ω⁺/ω⁻, Bullet",
               "ω⁺/ω⁻, ODE quickstep", "ω⁺/ω⁻, ODE step"}};
  for (const double friction : {1.0, 0.6, 0.4, 0.345, 0.3, 0.2, 0.1}) {
    const Scene fast = before_impact(scene, friction);
    const Event impact = *first_event(solve(fast), EventKind::impact);
    const auto engine = [&](const char* name) { return fixed(engine_ratio(name, fast, impact), 3); };
    table.rows.push_back({cell(friction), impact.to.slides[0] != 0 ? "yes" : "no",
                          fixed(impact_ratio(r, friction), 6), fixed(impact.after[0] / impact.before[0], 6),
                          engine("bullet"), engine("ode:quickstep"), engine("ode:step")});
  }
  return table;
}

/// What a swing asks of the floor, from release to its impact.
Table demands(Scene scene) {
  Table table{{"released at (rad)", "turns at the impact with (rad/s)", "forces need", "the impact needs"}};
  for (const double angle : {0.01, 0.1, 0.2, 0.3, 0.4}) {
    scene.initial = {{angle}, {0}};
    scene.law = Law::consistent;
    const Event impact = *first_event(solve(scene), EventKind::impact);
    const Scene swing = lasting(scene, impact.time * (1 - 1e-9)),
                landed = lasting(scene, impact.time * (1 + 1e-9));
    table.rows.push_back({cell(angle), cell(std::abs(impact.before[0])),
                          fixed(contact_need(swing).force.friction, 4),
                          fixed(contact_need(landed).impulse.friction, 4)});
  }
  return table;
}

/// With how many of these events a slip begins.
std::string slips_from(const std::vector<Event>& events) {
  return std::to_string(std::ranges::count_if(events, [](const Event& event) {
    bool begins = false;
    for (std::size_t k = 0; k < static_cast<std::size_t>(event.from.size); ++k)
      begins = begins || (event.from.slides[k] == 0 && event.to.slides[k] != 0);
    return begins;
  }));
}

Table stack_slips(const Scene& scene) {
  Table table{{"friction", "slips", "of these begin at an impact", "top block slips by up to (mm)",
               "and is left at (mm)", "largest angle of the top block (rad)"}};
  for (const double friction : {2.0, 1.0, 0.5, 0.3}) {
    const History history = exact_answer(with_friction(scene, friction));
    const InterfaceSummary top = contact_summary(history).back();
    table.rows.push_back({cell(friction), slips_from(history.events), slips_from(impacts_of(history)),
                          cell(1e3 * top.largest_slip), cell(1e3 * top.final_slip),
                          cell(peak_angles(history).back())});
  }
  return table;
}

}  // namespace

LessonValues friction_values(const Suite& suite, const std::vector<RunMetrics>& /*rows*/) {
  const Scene& scene = suite.scenes.front().scene;
  const Scene stack = read_shipped("spanos-free-rocking");
  const double r = ratio_of(scene.blocks.front());
  const double friction = friction_of(scene).front();
  const History history = exact_answer(scene);
  const Event& impact = *first_event(history, EventKind::impact);
  const InterfaceSummary floor = contact_summary(history).front();
  const Scene swing = lasting(scene, impact.time * (1 - 1e-9));
  constexpr double flat_friction = 0.2;
  const double flat = crossing(0.8, 3, [](double height) { return impact_ratio(height, flat_friction); });
  const Demand top = solve(stack, {.events = EventsKept::summed, .validity = true}).forces.back();
  return {.numbers = {{"r", fixed(r, 0)},
                      {"friction", fixed(friction, 3)},
                      {"needed", fixed(impact_friction(r), 4)},
                      {"sticking_ratio", fixed(impact_ratio(r, 1), 4)},
                      {"form_ratio", fixed(impact_ratio(r, friction), 4)},
                      {"ratio", fixed(impact.after[0] / impact.before[0], 4)},
                      {"time", fixed(impact.time, 4)},
                      {"swing_friction", fixed(contact_need(swing).force.friction, 4)},
                      {"after", shown_pattern(impact.to)},
                      {"largest_slip", fixed(1e3 * floor.largest_slip, 2)},
                      {"final_slip", fixed(std::abs(1e3 * floor.final_slip), 2)},
                      {"step_slips_below", fixed(3 * r * (4 + r * r) / (4 * std::pow(1 + r * r, 2)), 2)},
                      {"flat_friction", fixed(flat_friction, 1)},
                      {"flat_width", fixed(2 * scene.blocks.front().half_height / flat, 3)},
                      {"slips", slips_from(history.events)},
                      {"stack_forces", fixed(top.friction, 2)},
                      {"stack_time", fixed(top.friction_time, 3)},
                      {"stack_impulses", fixed(contact_need(stack).impulse.friction, 2)}},
          .tables = {{"ratios", impact_ratios(scene)},
                     {"demands", demands(scene)},
                     {"stack", stack_slips(stack)}},
          .player = {.time = impact.time - 0.02, .speed = 0.05, .gain = 1}};
}

}  // namespace rockstack
