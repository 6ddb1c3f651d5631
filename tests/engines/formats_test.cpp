// Scenes that were written for other simulators, read back by their libraries: to the same numbers, and in
// MuJoCo to the adapter's motion.

#include "engines/formats/formats.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

#include "analytic/scene/input/scene_file.hpp"
#include "comparisons/suites/trajectory_file.hpp"
#include "engines/formats/model_text.hpp"
#include "engines/worker/registry.hpp"
#include "tests/free_rocking.hpp"
#include "tests/native_engines.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

/// Two blocks with centres of mass off their middles that start turning and sliding on a slope, with a
/// coefficient of friction for each interface.
constexpr const char* moving_text = R"(title = "Two -- blocks & a slope"
duration = 0.3
law = "unilateral"
[[blocks]]
width = 1.3
height = 0.7
density = 2500
inertia = 500
center_of_mass = [-0.2, 0.05]
[[blocks]]
width = 0.9
height = 1.7
density = 1300
inertia = 700
center_of_mass = [0.1, -0.3]
[contact]
friction = [0.3, 0.7]
[initial]
angles = [0.05, 0.11]
velocities = [0.2, -0.3]
[ground]
inclination = 0.1
)";

constexpr const char* shaken_text = R"(duration = 0.4
[[blocks]]
width = 0.5
height = 2
density = 2500
[ground.horizontal]
pulse = "sine"
amplitude = 6
period = 0.3
[ground.vertical]
pulse = "sine"
amplitude = 2
period = 0.2
)";

Scene scene_of(const TemporaryFolder& folder, const std::string& text) {
  return read_scene(folder.write("scene.toml", text));
}

/// What a program that reads a file by another library prints; no text where it is not there.
std::optional<std::string> read_back(const std::string& program, const std::string& arguments,
                                     const TemporaryFolder& folder) {
  const auto readers = names_in(FORMAT_READERS);
  if (std::ranges::find(readers, program) == readers.end()) return {};
  const std::string out = (folder.path() / "read-back").string();
  const std::string command = BARE_PROGRAMS "/bare_" + program + " " + arguments + " >" + out;
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::ostringstream text;
  text << std::ifstream(out).rdbuf();
  return text.str();
}

std::vector<double> numbers_in_line(const std::string& line) {
  std::istringstream words(line);
  std::vector<double> list;
  for (std::string word; words >> word;) list.push_back(std::stod(word));
  return list;
}

std::vector<std::vector<double>> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::vector<double>> list;
  for (std::string line; std::getline(in, line);) list.push_back(numbers_in_line(line));
  return list;
}

/// Middle of the box, mass, moments of inertia, size, place and turn, in the axes of the files.
std::vector<double> numbers_of(const Placement& block) {
  return {-block.offset_x,
          0,
          -block.offset_y,
          block.mass,
          block.inertia_about_x,
          block.inertia,
          block.inertia_about_y,
          block.width,
          block.depth,
          block.height,
          block.x,
          0,
          block.y,
          0,
          block.angle,
          0};
}

TEST(Formats, SdfformatReadsTheSameNumbers) {
  const TemporaryFolder folder;
  const ModelScene model = model_scene(scene_of(folder, moving_text), "moving", 1e-3, "moving.sdf");
  const std::string file = folder.write("moving.sdf", sdf_of(model).text).string();
  const auto text = read_back("sdf", file, folder);
  if (!text) GTEST_SKIP() << "libsdformat is not there";
  const auto lines = lines_of(*text);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], (std::vector<double>{model.setup.gravity.x, 0, model.setup.gravity.y, 1e-3}));
  for (std::size_t k = 0; k < 2; ++k) {
    const Placement& block = model.setup.blocks[k];
    std::vector<double> expected = numbers_of(block);
    // Surfaces whose lesser coefficients are 0.3 on the ground and 0.7 above.
    expected.insert(expected.end(),
                    {0.7, block.velocity_x, 0, block.velocity_y, 0, block.angular_velocity, 0});
    EXPECT_EQ(lines[k + 1], expected) << "block " << k + 1;
  }
}

// The library keeps a turn as a quaternion: angles come back to rounding.
TEST(Formats, UrdfdomReadsTheSameNumbers) {
  const TemporaryFolder folder;
  const ModelScene model = model_scene(scene_of(folder, moving_text), "moving", 1e-3, "moving.urdf");
  const auto text = read_back("urdf", folder.write("moving.urdf", urdf_of(model).text).string(), folder);
  if (!text) GTEST_SKIP() << "liburdfdom is not there";
  const auto lines = lines_of(*text);
  ASSERT_EQ(lines.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<double> expected = numbers_of(model.setup.blocks[k]);
    ASSERT_EQ(lines[k].size(), expected.size());
    for (std::size_t i = 0; i + 3 < expected.size(); ++i)
      EXPECT_EQ(lines[k][i], expected[i]) << k << ' ' << i;
    for (std::size_t i = expected.size() - 3; i < expected.size(); ++i)
      EXPECT_NEAR(lines[k][i], expected[i], 1e-15) << k << ' ' << i;
  }
}

/// A model whose z axis is turned to y, the adapter's: MuJoCo then rounds as it does there.
std::string with_y_up(std::string text) {
  for (const auto& [pattern, turned] :
       {std::pair(R"re((diaginertia|box" size| pos|gravity)="(\S+) (\S+) (\S+)")re", R"($1="$2 $4 $3")"),
        std::pair(R"re(axis="0 1 0")re", R"(axis="0 0 -1")"),
        std::pair(R"re(axis="0 0 1")re", R"(axis="0 1 0")"),
        std::pair(R"re(size="0 0 1")re", R"(size="0 0 1" zaxis="0 1 0")")})
    text = std::regex_replace(text, std::regex(pattern), turned);
  return text;
}

/// Largest difference of angles (rad) and centres (m) between what MuJoCo makes of a model, up to `end` s,
/// and what the adapter's worker does; nothing where this build has no MuJoCo.
std::optional<double> distance_from_worker(const Scene& scene, double end,
                                           std::string (*change)(std::string)) {
  const TemporaryFolder folder;
  constexpr double dt = 1e-3;
  const std::string file = (folder.path() / "model.xml").string();
  const ModelScene model = model_scene(scene, "model", dt, file);
  folder.write("model.xml", change(mjcf_of(model).text));
  std::string arguments = fmt::format("{} {}", file, model.setup.steps);
  if (!model.table.empty()) arguments += " " + folder.write(model.table, ground_table(model)).string();
  const auto text = read_back("mujoco_model", arguments, folder);
  if (!text) return {};
  const Trajectory found = read_trajectory(folder.write("run.csv", *text), scene).trajectory;
  const WorkerEngine& engine = engines_called("mujoco").front();
  const Trajectory expected = run(engine, model.setup, engine.default_parameters(), true);
  EXPECT_EQ(found.angles.size(), expected.angles.size());
  double largest = 0;
  for (std::size_t i = 0; i < std::min(found.angles.size(), expected.angles.size()); ++i) {
    if (found.times[i / scene.blocks.size()] > end) break;
    largest = std::max({largest, std::abs(found.angles[i] - expected.angles[i]),
                        std::abs(found.bodies[i].x - expected.bodies[i].x),
                        std::abs(found.bodies[i].y - expected.bodies[i].y)});
  }
  return largest;
}

std::string as_it_is(std::string text) {
  return text;
}

// Lengths and angles of order one over some hundred steps, whose contacts let no difference grow: ten times
// the rounding of each step.
constexpr double rounding = 1e-12;

TEST(Formats, MujocoHasTheWorkersMotionFromTheFile) {
  const TemporaryFolder folder;
  for (const char* text : {moving_text, shaken_text}) {
    const auto distance = distance_from_worker(scene_of(folder, text), 1, with_y_up);
    if (!distance) GTEST_SKIP() << "MuJoCo is not there";
    EXPECT_LT(*distance, rounding) << text;
  }
}

// As the file stands, z is up. Until a contact changes MuJoCo's solver ends at the same iteration; later it
// stops at its tolerance, which leaves other digits in axes that are turned.
TEST(Formats, MujocoHasTheWorkersMotionWithZUpUntilAContactChanges) {
  const TemporaryFolder folder;
  const auto distance = distance_from_worker(free_rocking(0.3), 0.3, as_it_is);
  if (!distance) GTEST_SKIP() << "MuJoCo is not there";
  EXPECT_LT(*distance, rounding);
}

// The lesser coefficient of two bodies that meet counts.
TEST(Formats, SurfacesGiveInterfacesTheirFrictionButInAValley) {
  const auto least = [](const std::vector<double>& interfaces) {
    const std::vector<double> surfaces = surface_friction(interfaces);
    std::vector<double> list;
    for (std::size_t k = 0; k < interfaces.size(); ++k)
      list.push_back(std::min(surfaces[k], surfaces[k + 1]));
    return list;
  };
  for (const std::vector<double>& one : {std::vector{0.3}, {0.3, 0.7}, {0.7, 0.3}, {0.2, 0.5, 0.4}}) {
    EXPECT_EQ(least(one), one);
    EXPECT_TRUE(wrong_interfaces(one).empty());
  }
  EXPECT_EQ(least({0.5, 0.2, 0.4}), (std::vector{0.5, 0.4, 0.4}));
  EXPECT_EQ(wrong_interfaces({0.5, 0.2, 0.4}), (std::vector<std::size_t>{2}));
}

TEST(Formats, WhatAFileCannotHoldItSays) {
  const TemporaryFolder folder;
  const auto said = [&](const char* text, ModelFile (*write)(const ModelScene&)) {
    const ModelFile file = write(model_scene(scene_of(folder, text), "one", 1e-3, "one.xml"));
    for (const std::string& one : file.left_out) EXPECT_NE(file.text.find(one), std::string::npos) << one;
    return fmt::format("{}", fmt::join(file.left_out, "; "));
  };
  EXPECT_EQ(said(moving_text, mjcf_of), "");
  EXPECT_EQ(said(shaken_text, mjcf_of), "the ground's motion");
  EXPECT_EQ(said(moving_text, sdf_of),
            "velocities at the start where a simulator passes over the state below");
  for (const char* word : {"gravity", "friction 0.3 0.7", "velocities"})
    EXPECT_NE(said(moving_text, urdf_of).find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace rockstack
