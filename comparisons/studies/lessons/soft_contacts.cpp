#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {
namespace {

constexpr double contact_step = 1e-3;  // s
constexpr int heights = 15;
constexpr double lowest = 0.16, highest = 0.44;  // tilts, rad

/// How much of its angular speed a block has again after it has landed flat.
double rebound(const History& history, const Event& landing) {
  double most = 0;
  for (std::size_t i = 0; i < history.size(); ++i)
    if (history.times[i] > landing.time + 3 * contact_step)
      most = std::max(most, std::abs(history.velocities_at(i)[0]));
  return most / std::abs(landing.before[0]);
}

/// One fall: the scene with its tilt, and the landing of its exact motion.
struct Fall {
  Scene scene;
  Event landing;
};

std::vector<Fall> falls(Scene scene) {
  std::vector<Fall> list;
  for (int i = 0; i < heights; ++i) {
    scene.initial.angles = {lowest + (highest - lowest) * i / (heights - 1)};
    list.push_back({scene, *first_event(exact_answer(scene), EventKind::impact)});
  }
  return list;
}

struct Choice {
  const char* engine;
  const char* settings;
  const char* label;
  Parameters changes;
};

std::vector<Choice> choices() {
  return {
      {"ode", "default", "ODE, default: ERP 0.2", {}},
      {"ode", "default", "ODE, ERP 0.8", {{"erp", 0.8}}},
      {"ode", "default", "ODE, ERP 0.05", {{"erp", 0.05}}},
      {"ode", "tuned", "ODE, tuned: ERP 0.01", {}},
      {"ode", "default", "ODE, ERP 0.2, CFM 1e-5", {{"cfm", 1e-5}}},
      {"bullet", "default", "Bullet, default: ERP 0.2, split impulse below 0.04 m", {}},
      {"bullet", "default", "Bullet, ERP 0.8", {{"erp2", 0.8}}},
      {"bullet", "default", "Bullet, split impulse at any depth", {{"splitImpulsePenetrationThreshold", 0}}},
      {"bullet", "tuned", "Bullet, tuned", {}}};
}

/// The bounces of one choice over all falls.
std::vector<double> rebounds(const Choice& choice, const std::vector<Fall>& all) {
  std::vector<double> list;
  list.reserve(all.size());
  for (const Fall& fall : all)
    list.push_back(rebound(answer(choice.engine, choice.settings, fall.scene, contact_step, choice.changes),
                           fall.landing));
  return list;
}

/// "0.063 (0.006 to 0.17)", two digits of each.
std::string spread(const std::vector<double>& values) {
  return fmt::format("{:.2g} ({:.2g} to {:.2g})", median(values), quantile(values, 0), quantile(values, 1));
}

/// ERP and CFM as the spring and damper that they stand for at a step.
Table springs(double weight) {
  Table table{
      {"ERP", "CFM (s/kg)", "step (s)", "stiffness (N/m)", "damping (N s/m)", "sinks under the weight (m)"},
      {}};
  for (const double erp : {0.01, 0.2, 0.8})
    for (const double cfm : {1e-10, 1e-5}) {
      const double stiffness = erp / (contact_step * cfm);
      table.rows.push_back({cell(erp), cell(cfm), cell(contact_step), power(stiffness, 1),
                            power((1 - erp) / cfm, 1), power(weight / 2 / stiffness, 1)});
    }
  return table;
}

/// Per corner; its contact lasts some twenty steps.
constexpr double lesson_stiffness = 1e7;  // N/m

CornerSpring corner_of(const Block& block, double ratio) {
  const double critical = ratio / damping_ratio({lesson_stiffness, 1}, block);
  return {lesson_stiffness, critical};
}

/// The greatest angular speed back, as a share of that of landing.
double speed_back(const History& history, const Event& landing) {
  double most = 0;
  for (const double velocity : history.velocities) most = std::max(most, -velocity / landing.before[0]);
  return most;
}

/// ODE on that spring: two points bear a corner.
double speed_back_in_ode(const Scene& scene, const CornerSpring& corner, const Event& landing, double dt) {
  const Parameters spring{{"contactStiffness", corner.stiffness / 2}, {"contactDamping", corner.damping / 2}};
  return speed_back(answer("ode", "default", scene, dt, spring), landing);
}

/// Landings on springs of one stiffness, from undamped to more than critically damped. Without friction
/// nothing else is in the contact.
Table damped_landings(Scene scene, const Event& landing) {
  Table table{{"damping ratio ζ", "one corner alone", "this block, exact", "ODE, 1 ms", "ODE, 0.1 ms"}, {}};
  scene.friction = {0};
  for (const double ratio : {0.0, 0.1, 0.3, 1.0, 3.0}) {
    const CornerSpring corner = corner_of(scene.blocks.front(), ratio);
    const History exact = exact_answer(with_springs(scene, scene.friction, corner));
    table.rows.push_back({cell(ratio), fixed(restitution_of(ratio), 3), fixed(speed_back(exact, landing), 3),
                          fixed(speed_back_in_ode(scene, corner, landing, 1e-3), 3),
                          fixed(speed_back_in_ode(scene, corner, landing, 1e-4), 3)});
  }
  return table;
}

/// The parts of every difference of the suite; an empty cell where contacts are rigid.
Table parts(const std::vector<RunMetrics>& rows) {
  Table table{{"run", "step (s)", "ζ", "restitution", "contact model (rad)", "contact softness (rad)",
               "time step (rad)"},
              {}};
  const auto words = [](const std::optional<double>& value) { return value ? power(*value, 1) : ""; };
  for (const RunMetrics& row : rows) {
    if (!row.step_difference) continue;
    table.rows.push_back({row.engine + " " + row.settings, cell(*row.dt), words(row.contact_damping_ratio),
                          words(row.contact_restitution), words(row.model_difference),
                          words(row.softness_difference), words(row.step_difference)});
  }
  return table;
}

}  // namespace

LessonValues soft_contacts_values(const Suite& suite, const std::vector<RunMetrics>& rows) {
  const Scene& scene = suite.scenes.front().scene;
  const Event landing = *first_event(exact_answer(scene), EventKind::impact);
  const Block& block = scene.blocks.front();
  const double alpha = std::atan2(block.half_width, block.half_height);
  const std::vector<Choice> all = choices();
  const std::vector<Fall> every = falls(scene);
  Table table{{"engine and parameters", "speed after / before: median", "least", "most"}, {}};
  std::vector<std::string> bounces;
  std::vector<double> medians;
  for (const Choice& choice : all) {
    const std::vector<double> list = rebounds(choice, every);
    table.rows.push_back(
        {choice.label, cell(median(list)), cell(quantile(list, 0)), cell(quantile(list, 1))});
    bounces.push_back(spread(list));
    medians.push_back(median(list));
  }
  return {.numbers = {{"alpha", fixed(alpha, 3)},
                      {"ratio", fixed(1 - 1.5 * std::sin(alpha) * std::sin(alpha), 3)},
                      {"time", fixed(landing.time, 4)},
                      {"speed", fixed(std::abs(landing.before[0]), 3)},
                      {"corner_speed", fixed(std::abs(landing.before[0]) * 2 * block.half_width, 3)},
                      {"depth", power(std::abs(landing.before[0]) * 2 * block.half_width * contact_step, 1)},
                      {"step", fixed(contact_step, 3)},
                      {"after", name(landing.to)},
                      {"heights", std::to_string(heights)},
                      {"lowest", fixed(lowest, 2)},
                      {"highest", fixed(highest, 2)},
                      {"ode_default", bounces[0]},
                      {"ode_high", bounces[1]},
                      {"ode_tuned", bounces[3]},
                      {"bullet_default", bounces[5]},
                      {"bullet_split", bounces[7]},
                      {"bullet_tuned", bounces[8]},
                      {"stiffness", power(lesson_stiffness, 0)}},
          .tables = {{"rebounds", table},
                     {"springs", springs(block.mass * scene.gravity)},
                     {"damped_landings", damped_landings(scene, landing)},
                     {"parts", parts(rows)}},
          .player = {.time = landing.time - 0.01, .speed = 0.01, .gain = 10},
          .measured = {{"bounce", medians[0]}}};
}

}  // namespace rockstack
