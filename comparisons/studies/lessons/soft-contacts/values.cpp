#include <fmt/format.h>

#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {
namespace {

constexpr double contact_step = 1e-3;  // s
constexpr double points = 4;           // of a block's bottom face
constexpr int heights = 15;
constexpr double least_tilt = 0.16, most_tilt = 0.44;  // rad

/// How much of its angular speed a block has again after it has landed flat.
double rebound(const History& history, const Event& landing) {
  double most = 0;
  for (std::size_t i = 0; i < history.size(); ++i)
    if (history.times[i] > landing.time + 3 * contact_step)
      most = std::max(most, std::abs(history.velocities_at(i)[0]));
  return most / std::abs(landing.before[0]);
}

/// Falls from several tilts, each with the landing of its exact motion.
std::vector<std::pair<Scene, Event>> falls(Scene scene) {
  std::vector<std::pair<Scene, Event>> list;
  for (int i = 0; i < heights; ++i) {
    scene.initial.angles = {least_tilt + (most_tilt - least_tilt) * i / (heights - 1)};
    list.emplace_back(scene, *first_event(exact_answer(scene), EventKind::impact));
  }
  return list;
}

struct Choice {
  const char* engine;
  const char* settings;
  const char* label;
  Parameters changes;
};

const std::vector<Choice> contact_choices{
    {"ode", "default", "ODE, default: ERP 0.2", {}},
    {"ode", "default", "ODE, ERP 0.8", {{"erp", 0.8}}},
    {"ode", "default", "ODE, ERP 0.05", {{"erp", 0.05}}},
    {"ode", "tuned", "ODE, tuned: ERP 0.01", {}},
    {"ode", "default", "ODE, ERP 0.2, CFM 1e-5", {{"cfm", 1e-5}}},
    {"bullet", "default", "Bullet, default: ERP 0.2, split impulse deeper than 0.04 m", {}},
    {"bullet", "default", "Bullet, ERP 0.8", {{"erp2", 0.8}}},
    {"bullet", "default", "Bullet, split impulse at any depth", {{"splitImpulsePenetrationThreshold", 0}}},
    {"bullet", "tuned", "Bullet, tuned", {}}};

/// "0.063 (0.006 to 0.17)", two digits of each.
std::string spread(const std::vector<double>& values) {
  return fmt::format("{:.2g} ({:.2g} to {:.2g})", median(values), quantile(values, 0), quantile(values, 1));
}

/// ERP and CFM as the spring and damper that they stand for at a step.
Table springs(double weight) {
  Table table{
      {"ERP", "CFM (s/kg)", "step (s)", "stiffness (N/m)", "damping (N s/m)", "sinks under the weight (m)"}};
  for (const double erp : {0.01, 0.2, 0.8})
    for (const double cfm : {1e-10, 1e-5}) {
      const double stiffness = erp / (contact_step * cfm);
      table.rows.push_back({cell(erp), cell(cfm), cell(contact_step), power(stiffness, 1),
                            power((1 - erp) / cfm, 1), power(weight / points / stiffness, 1)});
    }
  return table;
}

/// One contact parameter of an engine as the spring and the dashpot of a point.
struct Meaning {
  const char *engine, *words;
  Parameters changes;
  double stiffness, damping;  ///< N/m and N·s/m
  double free;                ///< depth at which nothing pushes yet, m
};

Meaning of_erp(const char* words, double erp, double cfm) {
  return {"ode", words, {{"erp", erp}, {"cfm", cfm}}, erp / (contact_step * cfm), (1 - erp) / cfm, 0};
}

/// MuJoCo's, at the depth at which four points bear the block: solimp makes the impedance d of the depth (up
/// to half its width here), d and the time constant of solref the spring. Formulas:
/// engines/mujoco/README.md.
Meaning of_solref(const char* words, double time, const Block& block, double gravity) {
  constexpr double d0 = 0.9, d1 = 0.95, width = 1e-3;  // solimp; m
  Meaning meaning{"mujoco", words, {{"solref_timeconst", time}}, 0, 0, 0};
  double depth = 0;
  for (int i = 0; i < 50; ++i) {  // each time a hundredth of the error or less is left
    const double d = d0 + (d1 - d0) * 2 * depth * depth / (width * width);
    const double softness = (1 - d) / d * 2 / (3 * block.mass);
    meaning.stiffness = d / (d1 * time * d1 * time * softness);
    meaning.damping = 2 / (d1 * time * softness);
    depth = block.mass * gravity / (points * meaning.stiffness);
  }
  return meaning;
}

/// How deep a block at rest is in the ground, by springs that are its parameters, and in the engines
/// themselves.
Table at_rest(Scene scene) {
  Table table{{"engine", "parameters", "stiffness of a point (N/m)", "damping of a point (N·s/m)",
               "sinks, computed (m)", "sinks, in the engine (m)"}};
  scene.law = Law::unilateral;  // by which engines tell gaps
  scene.friction = {1};
  scene.initial.angles = {0};
  scene.duration = 2;
  const Block& block = scene.blocks.front();
  constexpr double slop = 1e-3;  // m
  for (const Meaning& one :
       {of_erp("erp 0.2, cfm 1e-5", 0.2, 1e-5), of_erp("erp 0.8, cfm 1e-5", 0.8, 1e-5),
        of_erp("erp 0.2, cfm 1e-6", 0.2, 1e-6),
        Meaning{"bullet", "linearSlop 1 mm", {{"linearSlop", slop}}, 0, 0, slop},
        of_solref("solref 0.02 s and 1, solimp 0.9 to 0.95", 0.02, block, scene.gravity),
        of_solref("solref 0.005 s and 1, solimp 0.9 to 0.95", 0.005, block, scene.gravity)}) {
    const bool rigid = one.stiffness == 0, there = !engines_called(one.engine).empty();
    const double depth = one.free + (rigid ? 0 : block.mass * scene.gravity / (points * one.stiffness));
    table.rows.push_back(
        {one.engine, one.words, rigid ? "rigid" : power(one.stiffness, 2), rigid ? "" : power(one.damping, 2),
         power(depth, 3),
         there ? power(-answer(one.engine, scene, contact_step, one.changes, "default").gaps.back(), 3)
               : "not in this build"});
  }
  return table;
}

/// Per corner; its contact lasts some twenty steps.
constexpr double lesson_stiffness = 1e7;  // N/m

/// The greatest angular speed from the landing until the block turns round again, as a share of the greatest
/// before it. Such a block falls towards the left.
double speed_back(const History& history) {
  double down = 0, back = 0;
  for (const double velocity : history.velocities) {
    if (back > 0 && velocity < 0) break;
    down = std::max(down, -velocity), back = std::max(back, velocity);
  }
  return back / down;
}

/// Landings on springs of one stiffness, from undamped to more than critically damped. Without friction
/// nothing else is in the contact.
Table damped_landings(Scene scene) {
  Table table{{"damping ratio ζ", "one corner alone", "this block, exact", "ODE, 1 ms", "ODE, 0.1 ms"}};
  scene.friction = {0};
  for (const double ratio : {0.0, 0.1, 0.3, 1.0, 3.0}) {
    const CornerSpring corner{lesson_stiffness,
                              ratio / damping_ratio({lesson_stiffness, 1}, scene.blocks.front())};
    const History exact = exact_answer(with_springs(scene, scene.friction, corner), 1e-4);
    // Two points bear a corner.
    const Parameters spring{{"contactStiffness", corner.stiffness / 2},
                            {"contactDamping", corner.damping / 2}};
    const auto in_ode = [&](double dt) { return speed_back(answer("ode", scene, dt, spring, "default")); };
    table.rows.push_back({cell(ratio), fixed(restitution_of(ratio), 3), fixed(speed_back(exact), 3),
                          fixed(in_ode(1e-3), 3), fixed(in_ode(1e-4), 3)});
  }
  return table;
}

/// The damping, in N·s/m, with which the block leaves with a hundredth of its speed, in powers of ten.
double quiet_damping() {
  return crossing(4, 6, [](double power_of_ten) {
    const Scene scene = read_shipped(
        "flat-landing", {"law=\"compliant\"", fmt::format("contact.stiffness={}", lesson_stiffness),
                         fmt::format("contact.damping={}", std::pow(10, power_of_ten))});
    return speed_back(exact_answer(scene)) - 0.01;
  });
}

/// The parts of every difference of the suite; an empty cell where contacts are rigid.
Table parts(const std::vector<RunMetrics>& rows) {
  Table table{{"run", "step (s)", "ζ", "restitution", "contact model (rad)", "contact softness (rad)",
               "time step (rad)"}};
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
  const auto every = falls(scene);
  Table table{{"engine and parameters", "speed after / before: median", "least", "most"}};
  std::vector<std::vector<double>> bounces;
  for (const auto& [engine, settings, label, changes] : contact_choices) {
    std::vector<double>& list = bounces.emplace_back();
    for (const auto& [fall, its_landing] : every)
      list.push_back(rebound(answer(engine, fall, contact_step, changes, settings), its_landing));
    table.rows.push_back({label, cell(median(list)), cell(quantile(list, 0)), cell(quantile(list, 1))});
  }
  const double quiet = std::pow(10, quiet_damping());
  return {.numbers = {{"alpha", fixed(alpha, 3)},
                      {"quiet_damping", power(quiet, 1)},
                      {"quiet_ratio", fixed(damping_ratio({lesson_stiffness, quiet}, block), 1)},
                      {"ratio", fixed(1 - 1.5 * std::sin(alpha) * std::sin(alpha), 3)},
                      {"time", fixed(landing.time, 4)},
                      {"speed", fixed(std::abs(landing.before[0]), 3)},
                      {"corner_speed", fixed(std::abs(landing.before[0]) * 2 * block.half_width, 3)},
                      {"depth", power(std::abs(landing.before[0]) * 2 * block.half_width * contact_step, 1)},
                      {"step", fixed(contact_step, 3)},
                      {"after", name(landing.to)},
                      {"heights", std::to_string(heights)},
                      {"lowest", fixed(least_tilt, 2)},
                      {"highest", fixed(most_tilt, 2)},
                      {"ode_default", spread(bounces[0])},
                      {"ode_high", spread(bounces[1])},
                      {"ode_tuned", spread(bounces[3])},
                      {"bullet_default", spread(bounces[5])},
                      {"bullet_split", spread(bounces[7])},
                      {"bullet_tuned", spread(bounces[8])},
                      {"stiffness", power(lesson_stiffness, 0)}},
          .tables = {{"rebounds", table},
                     {"springs", springs(block.mass * scene.gravity)},
                     {"at_rest", at_rest(scene)},
                     {"damped_landings", damped_landings(scene)},
                     {"parts", parts(rows)}},
          .player = {.time = landing.time - 0.01, .speed = 0.01, .gain = 10},
          .measured = {{"bounce", median(bounces[0])}}};
}

}  // namespace rockstack
