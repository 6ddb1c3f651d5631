#include <gtest/gtest.h>

#include "analytic/scene/input/scene_file.hpp"
#include "analytic/scene/input/scene_keys.hpp"
#include "analytic/scene/input/toml_reader.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "tests/analytic/scene/input/key_file.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

/// The ways to say how the ground moves.
const std::vector<const KeyTable*> motions{&record_keys,   &samples_keys,    &steps_keys,    &pulse_keys,
                                           &harmonic_keys, &near_fault_keys, &synthetic_keys};

/// Tables of a scene with a motion of that kind.
std::vector<const KeyTable*> tables_with(const KeyTable* motion) {
  return {&scene_keys, &block_keys, &initial_keys, &ground_keys, &contact_keys,
          motion,      &push_keys,  &tendon_keys,  &damper_keys, &surface_keys};
}

KeyFile scene_file(const KeyTable& motion) {
  return KeyFile({&scene_keys, &block_keys, &initial_keys, &contact_keys, &ground_keys, &motion, &push_keys,
                  &tendon_keys, &damper_keys, &surface_keys});
}

/// Reads a scene beside a record; fills `scene` where it is given.
std::string read_keys(const std::string& text, Scene* scene = nullptr) {
  const TemporaryFolder folder;
  folder.write("motion.csv", "units: m/s2\n0,0\n0.5,1\n1,0\n");
  try {
    Scene result = read_scene(folder.write("scene.toml", text));
    if (scene != nullptr) *scene = std::move(result);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

std::string numbers_of(const GroundMotion& motion) {
  std::string text = number_text(motion.interval);
  for (const double sample : motion.samples) text += " " + number_text(sample);
  if (motion.pulse)
    text += " " + number_text(motion.pulse->start) + " " + number_text(motion.pulse->phase) + " " +
            number_text(motion.pulse->cycles);
  return text;
}

/// The numbers of a scene that keys with a default give.
std::string numbers_of(const Scene& scene) {
  return number_text(scene.gravity) + " " + number_text(scene.inclination) + " " + name(scene.law) + " " +
         std::to_string(static_cast<int>(scene.equations)) + " " + number_text(friction_of(scene).front()) +
         " " + number_text(scene.depth) + " " + numbers_of(scene.horizontal);
}

TEST(SceneKeys, AreThoseThatAreRead) {
  for (const KeyTable* motion : motions) {
    for (const KeyTable* table : tables_with(motion))
      expect_keys_are_those_read(scene_file(*motion), *table,
                                 [](const auto& text) { return read_keys(text); });
  }
  // A wall excludes some of the others.
  expect_keys_are_those_read(KeyFile({&scene_keys, &block_keys, &wall_keys}), wall_keys,
                             [](const auto& text) { return read_keys(text); });
  expect_tables_are_complete(scene_tables);
}

TEST(SceneKeys, MakeAWholeScene) {
  for (const KeyTable* motion : motions) {
    KeyFile file = scene_file(*motion);
    for (const KeyTable* table : tables_with(motion)) {
      for (const InputKey& key : table->keys) {
        const std::string_view default_value = key.default_value;
        // Friction is stated once.
        if (table == &surface_keys && std::string_view(key.name) == "friction") continue;
        if (*key.example != '\0' && !default_value.starts_with("instead of "))
          file.set(*table, key.name, key.example);
      }
    }
    EXPECT_EQ(read_keys(file.text()), "");
  }
}

TEST(SceneKeys, DefaultsAreThoseOfTheReader) {
  int defaults = 0;
  for (const KeyTable* motion : motions) {
    const KeyFile file = scene_file(*motion);
    Scene plain;
    ASSERT_EQ(read_keys(file.text(), &plain), "");
    for (const KeyTable* table : tables_with(motion)) {
      if (table == &block_keys || table == &initial_keys) continue;  // whose defaults are words
      for (const InputKey& key : table->keys) {
        if (!parse_toml_value(key.default_value, Node{})) continue;
        Scene given;
        EXPECT_EQ(read_keys(KeyFile(file).set(*table, key.name, key.default_value).text(), &given), "");
        EXPECT_EQ(numbers_of(given), numbers_of(plain)) << key.name;
        ++defaults;
      }
    }
  }
  EXPECT_GT(defaults, 5 * static_cast<int>(motions.size()));
}

}  // namespace
}  // namespace rockstack
