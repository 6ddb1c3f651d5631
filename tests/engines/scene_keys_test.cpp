// Every key of a scene file does something: another value of it changes the exact motion or what an engine is
// told, in a scene where it matters.

#include <gtest/gtest.h>

#include <string_view>

#include "analytic/scene/input/scene_file.hpp"
#include "analytic/scene/input/scene_keys.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "analytic/solve.hpp"
#include "engines/scene_setup.hpp"
#include "tests/analytic/scene/input/key_file.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

void add(const Setup& setup, std::vector<double>& numbers) {
  for (const Placement& block : setup.blocks)
    numbers.insert(numbers.end(), {block.x, block.y, block.angle, block.width, block.height, block.depth,
                                   block.mass, block.inertia, block.offset_x, block.offset_y});
  numbers.insert(numbers.end(), setup.friction.begin(), setup.friction.end());
  numbers.insert(numbers.end(), {setup.gravity.x, setup.gravity.y, static_cast<double>(setup.steps)});
  if (setup.wall) numbers.push_back(setup.wall->x);
  for (const BodyAcceleration& step : setup.accelerations) numbers.insert(numbers.end(), {step.x, step.y});
  const auto add_point = [&](const BodyPoint& point) {
    numbers.insert(numbers.end(), {static_cast<double>(point.block), point.x, point.y});
  };
  for (const AppliedPush& push : setup.pushes) {
    add_point(push.point);
    numbers.insert(numbers.end(), {push.direction_x, push.direction_y});
    numbers.insert(numbers.end(), push.forces.begin(), push.forces.end());
  }
  for (const AppliedRestraint& one : setup.restraints) {
    add_point(one.from);
    add_point(one.to);
    numbers.insert(numbers.end(), {one.length, one.stiffness, one.prestress, one.yield, one.damping});
  }
}

/// What comes of a scene: the exact motion, and what an engine is told.
std::string outcome(const Scene& scene) {
  const History history = solve(scene, {.sample_times = regular_times(0.05, scene.duration)});
  std::vector<double> numbers = history.times;
  numbers.insert(numbers.end(), history.angles.begin(), history.angles.end());
  numbers.insert(numbers.end(), history.centres.begin(), history.centres.end());
  add(set_up(scene, 0.01, {}), numbers);
  std::string text = scene.title;
  for (const double number : numbers) text += " " + number_text(number);
  return text;
}

const KeyCase::Setting slippery{&contact_keys, "friction", "0.1"};
const KeyCase::Setting unilateral{&scene_keys, "law", "\"unilateral\""};
const KeyCase::Setting compliant{&scene_keys, "law", "\"compliant\""};
const KeyCase::Setting springs{&contact_keys, "stiffness", "1e7"};
const KeyCase::Setting bed{&contact_keys, "bed_stiffness", "1e7"};

const std::vector<KeyCase> cases{
    {&scene_keys, "title", "\"Another\""},
    {&scene_keys, "duration", "4.0"},
    {&scene_keys, "gravity", "9.0"},
    {&scene_keys, "law", "\"unilateral\"", {slippery}},
    {&scene_keys, "equations", "\"small-angle\""},
    {&scene_keys, "restitution", "[0.5]"},
    {&block_keys, "width", "1.1"},
    {&block_keys, "height", "2.6"},
    {&block_keys, "density", "2600", {slippery}},
    {&block_keys, "mass", "6000"},
    {&block_keys, "inertia", "4000"},
    {&block_keys, "center_of_mass", "[0.1, 0.0]", {{&block_keys, "inertia", "3776"}}},
    {&initial_keys, "angles", "[0.05]"},
    {&initial_keys, "velocities", "[0.1]"},
    {&initial_keys, "slip_velocities", "[0.5]", {unilateral, slippery}},
    {&initial_keys, "offsets", "[0.1]", {unilateral}},
    {&initial_keys, "gaps", "[0.1]", {unilateral}},
    {&initial_keys, "gap_velocities", "[0.5]", {unilateral, {&initial_keys, "gaps", "[0.1]"}}},
    {&initial_keys, "springs", "\"unloaded\"", {compliant, springs}},
    {&contact_keys, "friction", "0.1", {unilateral}},
    {&contact_keys,
     "kinetic_friction",
     "0.05",
     {unilateral, {&contact_keys, "friction", "0.4"}, {&initial_keys, "slip_velocities", "[0.5]"}}},
    {&wall_keys, "side", "\"right\"", {{&initial_keys, "angles", "[0.0]"}}},
    {&wall_keys, "restitution", "0.2"},
    {&contact_keys, "restitution", "0.5", {unilateral, {&initial_keys, "gaps", "[0.1]"}}},
    {&contact_keys,
     "restitution_law",
     "\"poisson\"",
     {unilateral, {&initial_keys, "gaps", "[0.1]"}, {&contact_keys, "restitution", "0.5"}}},
    {&contact_keys, "stiffness", "1e7", {compliant}},
    {&contact_keys, "damping", "1e4", {compliant, springs}},
    {&contact_keys, "bed_stiffness", "1e7", {compliant}},
    {&contact_keys, "bed_damping", "1e4", {compliant, bed}},
    {&contact_keys, "tangential", "0.5", {compliant, springs}},
    {&ground_keys, "inclination", "0.05"},
    {&record_keys, "record", "\"other.csv\""},
    {&record_keys, "from", "0.1"},
    {&record_keys, "to", "0.1"},
    {&record_keys, "scale", "2.0"},
    {&record_keys, "peak", "2.0"},
    {&record_keys, "time_scale", "2.0"},
    {&record_keys, "limits", ""},
    {&samples_keys, "samples", "[0.0, 3.0, -1.0, 0.0]"},
    {&samples_keys, "interval", "0.2"},
    {&samples_keys, "scale", "2.0"},
    {&samples_keys, "peak", "4.0"},
    {&samples_keys, "time_scale", "2.0"},
    {&steps_keys, "velocity_steps", "[0.4, -0.3]"},
    {&steps_keys, "times", "[0.0, 0.4]"},
    {&steps_keys, "scale", "2.0"},
    {&pulse_keys, "pulse", "\"ricker\""},
    {&pulse_keys, "amplitude", "4.0"},
    {&pulse_keys, "period", "0.4"},
    {&pulse_keys, "start", "0.1"},
    {&harmonic_keys, "pulse", "\"cosine\""},
    {&harmonic_keys, "amplitude", "4.0"},
    {&harmonic_keys, "period", "0.4"},
    {&harmonic_keys, "start", "0.1"},
    {&harmonic_keys, "cycles", "2.5"},
    {&near_fault_keys, "pulse", ""},
    {&near_fault_keys, "amplitude", "4.0"},
    {&near_fault_keys, "period", "0.4"},
    {&near_fault_keys, "start", "0.1"},
    {&near_fault_keys, "cycles", "2.5"},
    {&near_fault_keys, "phase", "0.5"},
    {&synthetic_keys, "synthetic", "2"},
    {&synthetic_keys, "peak", "3.0"},
    {&synthetic_keys, "duration", "10.0"},
    {&synthetic_keys, "interval", "0.02"},
    {&synthetic_keys, "frequency", "3.0"},
    {&synthetic_keys, "damping", "0.5"},
    {&push_keys, "block", ""},
    {&push_keys, "height", "1.5"},
    {&push_keys, "direction", "0.5"},
    {&push_keys, "force", "600.0"},
    {&push_keys, "from", "0.1"},
    {&push_keys, "to", "0.5"},
    {&push_keys, "impulse", "200.0"},
    {&tendon_keys, "kind", ""},
    {&tendon_keys, "block", ""},
    {&tendon_keys, "point", "[0.0, 2.0]"},
    {&tendon_keys, "to_block", ""},
    {&tendon_keys, "to_point", "[1.0, -1.0]"},
    {&tendon_keys, "stiffness", "2e5"},
    {&tendon_keys, "prestress", "2e4"},
    {&tendon_keys, "yield", "1e2"},
    {&damper_keys, "kind", ""},
    {&damper_keys, "block", ""},
    {&damper_keys, "point", "[0.0, 2.0]"},
    {&damper_keys, "to_block", ""},
    {&damper_keys, "to_point", "[1.0, -1.0]"},
    {&damper_keys, "damping", "3e4"},
    {&surface_keys, "friction", "2.0"},
    {&surface_keys, "depth", "2.0"},
};

bool is_motion(const KeyTable& table) {
  return std::string_view(table.header) == record_keys.header;
}

/// The last of the settings is that of the key whose case it is.
std::string outcome_with(const std::vector<KeyCase::Setting>& settings) {
  const KeyTable& motion = is_motion(*settings.back().table) ? *settings.back().table : pulse_keys;
  std::vector<const KeyTable*> tables{&scene_keys,  &block_keys, &initial_keys, &contact_keys,
                                      &ground_keys, &motion,     &surface_keys};
  for (const KeyTable* alone :
       std::initializer_list<const KeyTable*>{&push_keys, &tendon_keys, &damper_keys, &wall_keys})
    if (settings.back().table == alone) tables.push_back(alone);
  KeyFile file(tables);
  file.set(initial_keys, "angles", "[0.1]");
  for (const auto& [table, key, value] : settings) file.set(*table, key, value);
  const TemporaryFolder folder;
  // Up to a second, which keys of a part may name.
  std::string still;
  for (int i = 3; i < 10; ++i) still += "0." + std::to_string(i) + ",0\n";
  still += "1.0,0\n";
  folder.write("motion.csv", "units: m/s2\n0,0\n0.1,1\n0.2,0\n" + still);
  folder.write("other.csv", "units: m/s2\n0,0\n0.1,2\n0.2,0\n" + still);
  return outcome(read_scene(folder.write("scene.toml", file.text())));
}

TEST(SceneKeys, EachChangesWhatComesOfAScene) {
  expect_keys_have_effects(scene_tables, cases, outcome_with);
}

}  // namespace
}  // namespace rockstack
