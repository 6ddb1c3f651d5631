#include <gtest/gtest.h>

#include <limits>

#include "analytic/scene/input/scene_file.hpp"
#include "tests/analytic/scene/input/scene_text.hpp"

namespace rockstack {
namespace {

Scene read_with(const std::vector<std::string>& overrides) {
  const TemporaryFolder folder;
  const std::string ground = "[ground.vertical]\nsamples = [1, 2]\ninterval = 0.5\n";
  return read_scene(folder.write("scene.toml", two_blocks() + ground), overrides);
}

std::string error_with(const std::string& override_text) {
  return error_of(two_blocks(), {override_text});
}

TEST(Overrides, ReplaceValuesOfBlocksCountedFromOne) {
  const Scene scene = read_with({"blocks.1.height=3", "blocks.2.width = 0.5"});
  EXPECT_EQ(scene.blocks[0].half_height, 1.5);
  EXPECT_EQ(scene.blocks[1].half_width, 0.25);
  EXPECT_EQ(scene.blocks[0].mass, 2500 * 1.25 * 3);
}

TEST(Overrides, ReplaceWholeArraysAndSingleEntries) {
  EXPECT_EQ(read_with({"initial.angles=[0.05,0.02]"}).initial.angles, (std::vector<double>{0.05, 0.02}));
  EXPECT_EQ(read_with({"initial.angles.2=0.2"}).initial.angles, (std::vector<double>{0.15, 0.2}));
}

TEST(Overrides, SetOneBlockOfAListThatIsLeftOutBesideItsDefault) {
  EXPECT_EQ(read_with({"initial.velocities.2=0.3"}).initial.velocities, (std::vector<double>{0, 0.3}));
  EXPECT_EQ(read_with({"contact.friction.1=0.4"}).friction, (std::vector<double>{0.4, 1000}));
  EXPECT_EQ(read_with({"contact.friction=0.4", "contact.friction.2=0.5"}).friction,
            (std::vector<double>{0.4, 0.5}));
  const Scene soft = read_with(
      {"law=compliant", "contact.stiffness.2=1e8", "contact.damping.1=1e3", "contact.damping.2=2e3"});
  EXPECT_EQ(soft.springs.stiffness, (std::vector<double>{std::numeric_limits<double>::infinity(), 1e8}));
  EXPECT_EQ(soft.springs.damping, (std::vector<double>{1e3, 2e3}));
}

TEST(Overrides, SetAllBlocksOfAListWithoutADefault) {
  const TemporaryFolder folder;
  const auto one = folder.write("one.toml", "duration = 1\n[[blocks]]\nwidth = 1\nheight = 2\nmass = 1\n");
  EXPECT_EQ(read_scene(one, {"restitution.1=0.9"}).restitution, std::vector<double>{0.9});
  EXPECT_EQ(error_with("restitution.1=0.9"),
            "--set restitution.1=0.9: restitution.2 = missing: must be a number");
  EXPECT_EQ(read_with({"restitution.1=0.9", "restitution.2=0.8"}).restitution,
            (std::vector<double>{0.9, 0.8}));
  EXPECT_EQ(error_with("initial.angles.3=0.1"),
            "--set initial.angles.3=0.1: initial.angles.3: there are 2 entries, must be 1 to 2");
  EXPECT_EQ(error_with("initial.gaps.3=0.1"),
            "--set initial.gaps.3=0.1: initial.gaps.3: there are 2 entries, must be 1 to 2");
}

TEST(Overrides, MakeTablesThatAreMissing) {
  EXPECT_EQ(read_with({"engine.friction=0.7"}).friction.back(), 0.7);
  const Scene scene = read_with({"ground.horizontal.samples=[1, 3]", "ground.horizontal.interval=0.1"});
  EXPECT_EQ(scene.horizontal.samples, (std::vector<double>{1, 3}));
  EXPECT_EQ(read_with({"ground.horizontal={samples=[4], interval=1}"}).horizontal.samples,
            std::vector<double>{4});
}

TEST(Overrides, AddKeysToTablesOfTheFile) {
  EXPECT_EQ(read_with({"ground.vertical.scale=2"}).vertical.samples, (std::vector<double>{2, 4}));
}

TEST(Overrides, TakeTextWithAndWithoutQuotes) {
  EXPECT_EQ(read_with({"law=consistent"}).law, Law::consistent);
  EXPECT_EQ(read_with({"law=\"consistent\""}).law, Law::consistent);
  EXPECT_EQ(read_with({"title=A = B, twice"}).title, "A = B, twice");
}

TEST(Overrides, TheLastOneWins) {
  EXPECT_EQ(read_with({"duration=1", "duration=2"}).duration, 2.0);
}

TEST(Overrides, AreThePlaceOfTheirErrors) {
  EXPECT_EQ(error_with("blocks.1.height=-3"),
            "--set blocks.1.height=-3: blocks.1.height = -3: must be a number from 1e-20 to 1e+20");
  EXPECT_EQ(error_with("initial.angles.2=nan"),
            "--set initial.angles.2=nan: initial.angles.2 = nan: must be a finite number");
  EXPECT_EQ(error_with("initial.angles=[0, 0, inf]"),
            "--set initial.angles=[0, 0, inf]: initial.angles.3 = inf: must be a finite number");
  EXPECT_EQ(error_with("blocks.1.height=3 m"),
            "--set blocks.1.height=3 m: blocks.1.height = \"3 m\": must be a number");
  EXPECT_EQ(error_with("law=papr"),
            "--set law=papr: law = \"papr\": must be \"paper\" or \"consistent\" or \"unilateral\" or "
            "\"compliant\"; did you mean paper?");
  EXPECT_EQ(error_with("engine.grip=1"),
            "--set engine.grip=1: engine.grip: unknown key, must be one of friction, depth");
  EXPECT_EQ(error_with("ground.vertical.scale=2"),
            "--set ground.vertical.scale=2: ground.vertical.record: missing, must be given, or samples and "
            "interval, a pulse, synthetic or velocity_steps in its place");
}

TEST(Overrides, TwoLinesAreNotTwoValues) {
  EXPECT_EQ(error_with("duration=1\ngravity=2"),
            "--set duration=1\\x0agravity=2: duration = \"1\\x0agravity=2\": must be a number");
}

TEST(Overrides, OneFrictionBesideTheOtherIsAnError) {
  EXPECT_EQ(
      error_of(two_blocks() + "[contact]\nfriction = 0.1\n", {"engine.friction=0.3"}),
      "--set engine.friction=0.3: engine.friction = 0.3: must be left out where contact.friction is given "
      "(scene.toml:14), which engines take too");
}

TEST(Overrides, MassBesideTheFilesDensityIsAnError) {
  EXPECT_EQ(
      error_with("blocks.1.mass=10"),
      "--set blocks.1.mass=10: blocks.1.mass = 10: must be left out where density is given (scene.toml:5)");
}

TEST(Overrides, IndicesOutOfRangeNameTheCount) {
  EXPECT_EQ(error_with("blocks.3.width=1"),
            "--set blocks.3.width=1: blocks.3: there are 2 blocks, must be 1 to 2");
  EXPECT_EQ(error_with("blocks.0.width=1"),
            "--set blocks.0.width=1: blocks.0: there are 2 blocks, must be 1 to 2");
  EXPECT_EQ(error_with("blocks.top.width=1"),
            "--set blocks.top.width=1: blocks.top: there are 2 blocks, must be 1 to 2");
  EXPECT_EQ(error_with("initial.angles.3=0"),
            "--set initial.angles.3=0: initial.angles.3: there are 2 entries, must be 1 to 2");
}

TEST(Overrides, NeedAKeyAnEqualsSignAndAWayThrough) {
  const std::string form = ": must be key=value, e.g. blocks.1.height=3 or law=consistent";
  for (const std::string text : {"duration", "=3", "blocks..width=1", "duration.=1", ""}) {
    EXPECT_EQ(error_with(text), std::string("--set ").append(text).append(form));
  }
  EXPECT_EQ(error_with("duration.long=1"),
            "--set duration.long=1: duration = 5: must be a table or an array to hold duration.long");
}

}  // namespace
}  // namespace rockstack
