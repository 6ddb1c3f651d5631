#include <algorithm>
#include <cmath>

#include "comparisons/lessons/answers.hpp"
#include "comparisons/lessons/values.hpp"
#include "comparisons/lessons/wording.hpp"

namespace rockstack {
namespace {

constexpr double contact_step = 1e-3;  // s

/// How much of its angular speed a block has again after it has landed flat.
double rebound(const History& history, const Event& landing) {
  double most = 0;
  for (std::size_t i = 0; i < history.size(); ++i)
    if (history.times[i] > landing.time + 3 * contact_step)
      most = std::max(most, std::abs(history.velocities_at(i)[0]));
  return most / std::abs(landing.before[0]);
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

Table rebounds(const Scene& scene, const Event& landing) {
  Table table{{"engine and parameters", "speed after landing / before"}, {}};
  for (const Choice& choice : choices())
    table.rows.push_back({choice.label, cell(rebound(answer(choice.engine, choice.settings, scene,
                                                            contact_step, choice.changes),
                                                     landing))});
  return table;
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

}  // namespace

LessonValues soft_contacts_values(const Suite& suite, const std::vector<RunMetrics>& /*rows*/) {
  const Scene& scene = suite.scenes.front().scene;
  const Event landing = *first_event(exact_answer(scene), EventKind::impact);
  const Block& block = scene.blocks.front();
  const double alpha = std::atan2(block.half_width, block.half_height);
  const auto rebound_of = [&](const Choice& choice) {
    return fixed(
        rebound(answer(choice.engine, choice.settings, scene, contact_step, choice.changes), landing), 3);
  };
  const std::vector<Choice> all = choices();
  LessonValues values;
  values.numbers = {{"alpha", fixed(alpha, 3)},
                    {"ratio", fixed(1 - 1.5 * std::sin(alpha) * std::sin(alpha), 3)},
                    {"time", fixed(landing.time, 4)},
                    {"speed", fixed(std::abs(landing.before[0]), 3)},
                    {"corner_speed", fixed(std::abs(landing.before[0]) * 2 * block.half_width, 3)},
                    {"depth", power(std::abs(landing.before[0]) * 2 * block.half_width * contact_step, 1)},
                    {"step", fixed(contact_step, 3)},
                    {"after", name(landing.to)},
                    {"ode_default", rebound_of(all[0])},
                    {"ode_high", rebound_of(all[1])},
                    {"ode_tuned", rebound_of(all[3])},
                    {"bullet_default", rebound_of(all[5])},
                    {"bullet_split", rebound_of(all[7])},
                    {"bullet_tuned", rebound_of(all[8])}};
  values.tables = {{"rebounds", rebounds(scene, landing)}, {"springs", springs(block.mass * scene.gravity)}};
  return values;
}

}  // namespace rockstack
