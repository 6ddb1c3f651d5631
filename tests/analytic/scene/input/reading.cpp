#include <gtest/gtest.h>

#include <cmath>

#include "analytic/scene/input/scene_file.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "tests/analytic/scene/input/scene_text.hpp"

namespace rockstack {
namespace {

Scene read(const std::string& text) {
  const TemporaryFolder folder;
  return read_scene(folder.write("scene.toml", text));
}

TEST(SceneFile, KeysOfTheExactSolverAloneArriveToo) {
  const Scene scene = read(R"(
duration = 1
equations = "small-angle"
restitution = [0.875]
[[blocks]]
width = 1.0
height = 4.0
mass = 100.0
[ground]
inclination = 0.0625
[ground.horizontal]
pulse = "sine"
amplitude = 1
period = 1
cycles = inf
)");
  EXPECT_EQ(scene.equations, Equations::small_angle);
  EXPECT_EQ(scene.restitution, std::vector<double>{0.875});
  EXPECT_EQ(scene.inclination, 0.0625);
  EXPECT_TRUE(std::isinf(scene.horizontal.pulse->cycles));
  const Scene lopsided = read(R"(
duration = 1
[[blocks]]
width = 1.0
height = 4.0
mass = 100.0
inertia = 50.0
center_of_mass = [0.125, -0.5]
)");
  EXPECT_EQ(lopsided.blocks[0].offset_x, 0.125);
  EXPECT_EQ(lopsided.blocks[0].offset_y, -0.5);
}

TEST(SceneFile, ABlockWhoseCentreIsOffTheMiddleSaysItsInertia) {
  EXPECT_THROW(
      read("duration = 1\n[[blocks]]\nwidth = 1\nheight = 4\nmass = 100\ncenter_of_mass = [0.1, 0]\n"),
      InputError);
}

TEST(SceneFile, EveryKeyArrivesInTheScene) {
  const Scene scene = read(R"(
title = "All keys"
duration = 12.5
gravity = 9.8
law = "consistent"
equations = "linear"
[[blocks]]
width = 1.0
height = 4.0
mass = 100.0
inertia = 50.0
[initial]
angles = [0.125]
velocities = [-0.25]
[ground.horizontal]
samples = [0.0, 1.0, -2.0]
interval = 0.5
[ground.vertical]
samples = [3.0]
interval = 0.25
[engine]
friction = 0.5
depth = 2.0
)");
  EXPECT_EQ(scene.title, "All keys");
  EXPECT_EQ(scene.duration, 12.5);
  EXPECT_EQ(scene.gravity, 9.8);
  EXPECT_EQ(scene.law, Law::consistent);
  EXPECT_EQ(scene.equations, Equations::linear);
  ASSERT_EQ(scene.blocks.size(), 1U);
  EXPECT_EQ(scene.blocks[0].half_width, 0.5);
  EXPECT_EQ(scene.blocks[0].half_height, 2.0);
  EXPECT_EQ(scene.blocks[0].mass, 100.0);
  EXPECT_EQ(scene.blocks[0].inertia, 50.0);
  EXPECT_EQ(scene.initial.angles, std::vector<double>{0.125});
  EXPECT_EQ(scene.initial.velocities, std::vector<double>{-0.25});
  EXPECT_EQ(scene.horizontal.samples, (std::vector<double>{0, 1, -2}));
  EXPECT_EQ(scene.horizontal.interval, 0.5);
  EXPECT_EQ(scene.vertical.samples, std::vector<double>{3});
  EXPECT_EQ(scene.vertical.interval, 0.25);
  EXPECT_EQ(friction_of(scene).back(), 0.5);
  EXPECT_EQ(scene.depth, 2.0);
}

TEST(SceneFile, WhatIsLeftOutHasItsDefault) {
  const Scene scene = read("duration = 1.0\n[[blocks]]\nwidth = 2.0\nheight = 4.0\ndensity = 10.0\n");
  EXPECT_EQ(scene.title, "scene");
  EXPECT_EQ(scene.gravity, 9.81);
  EXPECT_EQ(scene.law, Law::consistent);
  EXPECT_EQ(scene.equations, Equations::nonlinear);
  EXPECT_EQ(scene.initial.angles, std::vector<double>{0});
  EXPECT_EQ(scene.initial.velocities, std::vector<double>{0});
  EXPECT_TRUE(scene.horizontal.empty());
  EXPECT_TRUE(scene.vertical.empty());
  EXPECT_EQ(friction_of(scene).back(), 1e3);
  EXPECT_EQ(scene.depth, 1.0);
}

TEST(SceneFile, DensityGivesTheMassOfASliceAndARectanglesInertia) {
  // Small integers: the products are exact.
  const Block block = read("duration = 1\n[[blocks]]\nwidth = 2\nheight = 4\ndensity = 30\n").blocks.front();
  EXPECT_EQ(block.mass, 240.0);
  EXPECT_EQ(block.inertia, 240.0 * (1 + 4) / 3);
}

TEST(SceneFile, IntegersStandForNumbers) {
  const Scene scene = read("duration = 5\ngravity = 10\n[[blocks]]\nwidth = 1\nheight = 2\nmass = 3\n");
  EXPECT_EQ(scene.duration, 5.0);
  EXPECT_EQ(scene.gravity, 10.0);
  EXPECT_EQ(scene.blocks[0].mass, 3.0);
}

TEST(SceneFile, NumbersReadBackToTheSameDouble) {
  for (const double value : {0.1, 1.0 / 3, 1e-20, 1e6 / 3, 123456.0, std::nextafter(1.0, 2.0)}) {
    const std::string text = "[[blocks]]\nwidth = 1.0\nheight = 1.0\nmass = 1.0\n";
    EXPECT_EQ(read("duration = " + number_text(value) + "\n" + text).duration, value);
  }
}

TEST(ShippedScenes, AllCanBeRead) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ROCKSTACK_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().string());
    ++scenes;
    Scene scene;
    ASSERT_NO_THROW(scene = read_scene(entry.path()));
    EXPECT_NE(scene.title, entry.path().stem().string());  // a title is given
  }
  EXPECT_GE(scenes, 3);
}

TEST(ShippedScenes, SpanosFreeRockingIsThePapersExample) {
  const Scene scene = read_scene(std::filesystem::path(ROCKSTACK_SCENES) / "spanos-free-rocking.toml");
  ASSERT_EQ(scene.blocks.size(), 2U);
  EXPECT_EQ(scene.duration, 5.0);
  EXPECT_EQ(scene.blocks[0].half_width, 0.625);
  EXPECT_EQ(scene.blocks[0].half_height, 0.625);
  EXPECT_EQ(scene.blocks[0].mass, 2500 * 1.25 * 1.25);
  EXPECT_EQ(scene.blocks[1].half_width, 0.5);
  EXPECT_EQ(scene.blocks[1].half_height, 1.25);
  EXPECT_EQ(scene.blocks[1].mass, 2500 * 2.5);
  EXPECT_EQ(scene.initial.angles, (std::vector<double>{0.15, 0.15}));
  EXPECT_EQ(scene.initial.velocities, (std::vector<double>{0, 0}));
}

}  // namespace
}  // namespace rockstack
