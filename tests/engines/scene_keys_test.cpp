// Every key of a scene file does something: another value of it changes the exact motion or what an engine is
// told, in a scene where it matters.

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "analytic/scene/input/scene_file.hpp"
#include "analytic/scene/input/scene_keys.hpp"
#include "analytic/solve.hpp"
#include "engines/scene_setup.hpp"
#include "tests/analytic/scene/input/key_file.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

/// What comes of a scene: the exact motion, and what an engine is told.
struct Outcome {
  std::string title;
  std::vector<double> numbers;
  bool operator==(const Outcome&) const = default;
};

void add(const Setup& setup, std::vector<double>& numbers) {
  for (const Placement& block : setup.blocks)
    numbers.insert(numbers.end(), {block.x, block.y, block.angle, block.width, block.height, block.depth,
                                   block.mass, block.inertia});
  numbers.insert(numbers.end(), setup.friction.begin(), setup.friction.end());
  numbers.insert(numbers.end(), {setup.gravity.x, setup.gravity.y, static_cast<double>(setup.steps)});
  for (const BodyAcceleration& step : setup.accelerations) numbers.insert(numbers.end(), {step.x, step.y});
}

Outcome outcome(const Scene& scene) {
  const History history = solve(scene, {.sample_times = regular_times(0.05, scene.duration)});
  Outcome result{scene.title, history.times};
  result.numbers.insert(result.numbers.end(), history.angles.begin(), history.angles.end());
  result.numbers.insert(result.numbers.end(), history.places.begin(), history.places.end());
  // Engines take no others.
  const bool for_engines = scene.restitution.empty() && scene.blocks.front().offset_x == 0;
  if (for_engines) add(set_up(scene, 0.01, {}), result.numbers);
  return result;
}

/// A key, another value for it than its example, and what else a scene has to say for it to matter.
struct Case {
  const KeyTable* table;
  std::string key, other;
  struct Setting {
    const KeyTable* table;
    std::string key, value;
  };
  std::vector<Setting> beside = {};
};

const Case::Setting slippery{&contact_keys, "friction", "0.1"};
const Case::Setting unilateral{&scene_keys, "law", "\"unilateral\""};
const Case::Setting compliant{&scene_keys, "law", "\"compliant\""};
const Case::Setting springs{&contact_keys, "stiffness", "1e7"};
const Case::Setting bed{&contact_keys, "bed_stiffness", "1e7"};

const std::vector<Case> cases{
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
    {&initial_keys, "springs", "\"unloaded\"", {compliant, springs}},
    {&contact_keys, "friction", "0.1", {unilateral}},
    {&contact_keys, "stiffness", "1e7", {compliant}},
    {&contact_keys, "damping", "1e4", {compliant, springs}},
    {&contact_keys, "bed_stiffness", "1e7", {compliant}},
    {&contact_keys, "bed_damping", "1e4", {compliant, bed}},
    {&contact_keys, "tangential", "0.5", {compliant, springs}},
    {&ground_keys, "inclination", "0.05"},
    {&record_keys, "record", "\"other.csv\""},
    {&record_keys, "scale", "2.0"},
    {&record_keys, "peak", "2.0"},
    {&samples_keys, "samples", "[0.0, 3.0, -1.0, 0.0]"},
    {&samples_keys, "interval", "0.2"},
    {&samples_keys, "scale", "2.0"},
    {&samples_keys, "peak", "4.0"},
    {&pulse_keys, "pulse", "\"ricker\""},
    {&pulse_keys, "amplitude", "4.0"},
    {&pulse_keys, "period", "0.4"},
    {&pulse_keys, "start", "0.1"},
    {&harmonic_keys, "pulse", "\"cosine\""},
    {&harmonic_keys, "amplitude", "4.0"},
    {&harmonic_keys, "period", "0.4"},
    {&harmonic_keys, "start", "0.1"},
    {&harmonic_keys, "cycles", "2.5"},
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
    {&surface_keys, "friction", "2.0"},
    {&surface_keys, "depth", "2.0"},
};

bool is_motion(const KeyTable& table) {
  return std::string_view(table.header) == record_keys.header;
}

/// The scene of a case with one value of its key.
Outcome with(const Case& one, const std::string& value) {
  const KeyTable& motion = is_motion(*one.table) ? *one.table : pulse_keys;
  KeyFile file(
      {&scene_keys, &block_keys, &initial_keys, &contact_keys, &ground_keys, &motion, &surface_keys});
  file.set(initial_keys, "angles", "[0.1]");
  for (const auto& [table, key, beside] : one.beside) file.set(*table, key, beside);
  const TemporaryFolder folder;
  folder.write("motion.csv", "units: m/s2\n0,0\n0.1,1\n0.2,0\n");
  folder.write("other.csv", "units: m/s2\n0,0\n0.1,2\n0.2,0\n");
  return outcome(read_scene(folder.write("scene.toml", file.set(*one.table, one.key, value).text())));
}

TEST(SceneKeys, EachChangesWhatComesOfAScene) {
  for (const KeyTable* table : scene_tables)
    for (const InputKey& key : table->keys) {
      const std::string name = std::string(table->meaning) + ": " + key.name;
      if (std::string_view(key.example).empty()) continue;  // a table
      if (table == &near_fault_keys && std::string_view(key.name) == "pulse")
        continue;  // has one value alone
      const auto found = std::find_if(cases.begin(), cases.end(), [&](const Case& one) {
        return one.table == table && one.key == key.name;
      });
      ASSERT_NE(found, cases.end()) << "say in what scene another value matters of " << name;
      try {
        EXPECT_NE(with(*found, key.example), with(*found, found->other)) << name;
      } catch (const std::exception& error) {
        ADD_FAILURE() << name << ": " << error.what();
      }
    }
}

}  // namespace
}  // namespace rockstack
