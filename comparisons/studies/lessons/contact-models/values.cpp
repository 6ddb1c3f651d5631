#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/metrics/difference.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/studies/lessons/mechanics.hpp"

namespace rockstack {
namespace {

/// A scene that ends a branch, on surfaces of that friction.
struct Example {
  const char* scene;
  double friction;
};

constexpr Example examples[]{{"housner-block", 0.6},       {"slippery-floor", 0.1},
                             {"rubbing-block", 0.345},     {"spanos-free-rocking", 1.0},
                             {"spanos-free-rocking", 1.5}, {"spanos-synthetic", 2.0},
                             {"thrown-block", 0.25}};

Scene scene_of(const Example& example) {
  Scene scene = read_shipped(example.scene);
  scene.friction.assign(scene.blocks.size(), example.friction);
  return scene;
}

std::string friction_cell(double friction) {
  return std::isfinite(friction) ? cell(friction) : "no friction does";
}

/// What each asks, which law that makes it, and what the other law would have said.
Table needs() {
  Table table{{"scene", "friction", "least normal force (weights)", "forces need", "impacts need",
               "pivots fail first", "law"}};
  for (const Example& example : examples) {
    const Scene scene = scene_of(example);
    const ContactNeed need = contact_need(scene);
    table.rows.push_back({example.scene, cell(example.friction),
                          cell(need.force.least_normal / weight_of(scene)),
                          friction_cell(need.force.friction), friction_cell(need.impulse.friction),
                          first_failure(need), name(law_for(need))});
  }
  return table;
}

Table consequences() {
  Table table{{"scene", "friction", "slips by up to (mm)", "lifts by up to (mm)",
               "angles of the two laws apart, RMS (rad)"}};
  for (const Example& example : examples) {
    const Scene scene = scene_of(example);
    const History free = exact_answer(under(scene, Law::unilateral));
    const History tied = solve(under(scene, Law::consistent), {.sample_times = free.times});
    double slip = 0, lift = 0;
    for (const InterfaceSummary& interface : contact_summary(free)) {
      slip = std::max(slip, interface.largest_slip);
      lift = std::max(lift, interface.highest_lift);
    }
    table.rows.push_back({example.scene, cell(example.friction), cell(1e3 * slip, 1), cell(1e3 * lift, 1),
                          power(root_mean_square(difference(tied, free)), 1)});
  }
  return table;
}

/// Motions of three scenes that no law of rigid contacts without restitution has, and the same scenes
/// without.
struct Beyond {
  Scene soft = read_shipped("flexible-foundation"), bouncing = read_shipped("bouncing-block"),
        measured = read_shipped("housner-block", {"restitution=[0.9]"});
  Scene rigid = with_rigid_contacts(soft, friction_of(soft)), dull = without_restitution(bouncing),
        shaped = read_shipped("housner-block");

  static Scene without_restitution(Scene scene) {
    scene.point_restitution = 0;
    return scene;
  }
};

double apart(const Scene& scene, const Scene& other) {
  const History history = exact_answer(scene);
  return root_mean_square(difference(solve(other, {.sample_times = history.times}), history));
}

Table beyond(const Beyond& scenes) {
  return {
      {"scene", "law", "what is asked for", "angles with and without it apart, RMS (rad)"},
      {{"flexible-foundation", "compliant", "contact.stiffness, contact.damping",
        power(apart(scenes.soft, scenes.rigid), 1)},
       {"bouncing-block", "unilateral", "contact.restitution", power(apart(scenes.bouncing, scenes.dull), 1)},
       {"housner-block", "consistent", "restitution = [0.9]",
        power(apart(scenes.measured, scenes.shaped), 1)}}};
}

}  // namespace

LessonValues contact_models_values(const Suite& /*suite*/, const std::vector<RunMetrics>& /*rows*/) {
  const auto need = [](int place) { return contact_need(scene_of(examples[place])); };
  const ContactNeed rough = need(0), slippery = need(1), rubbing = need(2);
  const ContactNeed shaken = need(5), thrown = need(6);
  const Beyond larger;
  const Block& slender = larger.shaped.blocks.front();
  const Scene squat = read_shipped("squat-top");
  const History paper = solve(under(squat, Law::paper)), consistent = solve(under(squat, Law::consistent));
  const Event* first = first_event(paper, EventKind::impact);
  const Event* other = first_event(consistent, EventKind::impact);
  return {
      .numbers = {{"soft_stiffness", power(larger.soft.springs.stiffness.front(), 0)},
                  {"soft_apart", fixed(apart(larger.soft, larger.rigid), 3)},
                  {"bouncing", fixed(larger.bouncing.point_restitution, 1)},
                  {"bouncing_time", fixed(larger.bouncing.duration, 1)},
                  {"bounces", std::to_string(impacts_of(solve(larger.bouncing)).size())},
                  {"dull_bounces", std::to_string(impacts_of(solve(larger.dull)).size())},
                  {"shape_ratio", fixed(impact_ratio(slender.half_height / slender.half_width), 3)},
                  {"rubbing_enough", fixed(std::max(rubbing.force.friction, rubbing.impulse.friction), 4)},
                  {"paper_pattern", name(first->to)},
                  {"consistent_pattern", name(other->to)},
                  {"squat_time", fixed(first->time, 3)},
                  {"shaken_pull", fixed(-shaken.force.least_normal, 0)},
                  {"shaken_time", fixed(shaken.first_pull(), 3)},
                  {"thrown_time", fixed(thrown.first_pull(), 3)},
                  {"rough_forces", fixed(rough.force.friction, 4)},
                  {"rough_impulses", fixed(rough.impulse.friction, 4)},
                  {"slippery_friction", fixed(slippery.friction, 1)},
                  {"slippery_time", fixed(slippery.force.first_slip_time, 3)},
                  {"rubbing_friction", fixed(rubbing.friction, 3)},
                  {"rubbing_forces_time", fixed(rubbing.force.first_slip_time, 3)},
                  {"rubbing_impulses", fixed(rubbing.impulse.friction, 4)},
                  {"rubbing_short", fixed(rubbing.impulse.friction - rubbing.friction, 3)},
                  {"rubbing_slip",
                   fixed(1e3 * contact_summary(exact_answer(scene_of(examples[2]))).front().largest_slip, 1)},
                  {"rubbing_time", fixed(rubbing.impulse.first_slip_time, 3)}},
      .tables = {{"needs", needs()}, {"beyond", beyond(larger)}, {"consequences", consequences()}},
      .player = {.time = rubbing.impulse.first_slip_time - 0.02, .speed = 0.1, .gain = 1, .overlaid = true}};
}

}  // namespace rockstack
