#include <gtest/gtest.h>

#include "analytic/scene/ground/synthetic.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "tests/analytic/scene/input/scene_text.hpp"

namespace rockstack {
namespace {

/// The horizontal motion of a scene with these lines under [ground.horizontal].
GroundMotion read_ground(const std::string& lines) {
  const TemporaryFolder folder;
  return read_scene(folder.write("scene.toml", two_blocks() + "[ground.horizontal]\n" + lines)).horizontal;
}

/// The error for such lines; the first of them is line 14.
std::string error_in(const std::string& lines) {
  return error_of(two_blocks() + "[ground.horizontal]\n" + lines);
}

TEST(GroundReading, ScaleMultipliesEverySample) {
  EXPECT_EQ(read_ground("samples = [1, -2]\ninterval = 0.5\nscale = -0.5\n").samples,
            (std::vector<double>{-0.5, 1}));
}

TEST(GroundReading, PeakIsReachedToTheLastBit) {
  // With these two numbers, multiplying by the rounded factor peak / largest would miss the last bit.
  const GroundMotion motion = read_ground("samples = [0.1, -0.2, 0.2]\ninterval = 0.5\npeak = 6.97\n");
  EXPECT_EQ(peak(motion), 6.97);
  EXPECT_EQ(motion.samples[1], -6.97);
}

TEST(GroundReading, TimeScaleMultipliesTheIntervalAlone) {
  const GroundMotion motion =
      read_ground("samples = [1, -2]\ninterval = 0.5\nscale = -0.5\ntime_scale = 0.5\n");
  EXPECT_EQ(motion.interval, 0.25);
  EXPECT_EQ(motion.samples, (std::vector<double>{-0.5, 1}));
  EXPECT_EQ(error_in("samples = [1]\ninterval = 1\ntime_scale = 0\n"),
            "scene.toml:16: ground.horizontal.time_scale = 0: must be a number from 1e-20 to 1e+20");
}

TEST(GroundReading, ARecordIsFoundBesideTheSceneFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "records");
  folder.write(
      "records/motion.at2",
      "PEER NGA STRONG MOTION DATABASE RECORD\nMade for a test\nACCELERATION TIME SERIES IN UNITS OF G\n"
      "NPTS=   4, DT=   .5000 SEC\n  .1000000E+00  -.2000000E+00   .0500000E+00   .0000000E+00\n");
  const auto file = folder.write(
      "scene.toml", two_blocks() + "[ground.vertical]\nrecord = \"records/motion.at2\"\npeak = 2.0\n");
  const Scene scene = read_scene(file);
  EXPECT_EQ(scene.vertical.interval, 0.5);
  ASSERT_EQ(scene.vertical.samples.size(), 4U);
  EXPECT_EQ(scene.vertical.samples[1], -2.0);
  EXPECT_EQ(scene.vertical.source.substr(0, 18), "records/motion.at2");
  EXPECT_TRUE(scene.horizontal.empty());
}

TEST(GroundReading, APartOfARecordIsFromOneOfItsTimesToAnother) {
  const TemporaryFolder folder;
  folder.write("motion.csv", "# units: m/s2\n# dt = 0.5\n0\n1\n-2\n3\n0\n");
  const auto motion = [&](const std::string& part) {
    const std::string lines = "[ground.horizontal]\nrecord = \"motion.csv\"\n" + part;
    return read_scene(folder.write("scene.toml", two_blocks() + lines)).horizontal;
  };
  EXPECT_EQ(motion("from = 0.4\nto = 1.6\n").samples, (std::vector<double>{1, -2, 3}));
  EXPECT_EQ(motion("from = 1\npeak = 6\n").samples, (std::vector<double>{-4, 6, 0}));
  EXPECT_EQ(motion("to = 0.5\ntime_scale = 2\n").samples, (std::vector<double>{0, 1}));
  EXPECT_NE(motion("to = 0.5\n").source.find(", from 0 s to 0.5 s"), std::string::npos);
  const auto refused = [&](const std::string& part) {
    try {
      motion(part);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(std::string(error.what()).find("ground"));
    }
    return std::string();
  };
  EXPECT_EQ(refused("from = 2.5\n"),
            "ground.horizontal.from = 2.5: must be a time of the record, from 0 to 2 s");
  EXPECT_EQ(refused("from = 1\nto = 1\n"),
            "ground.horizontal.to = 1: must be later than where the motion begins");
  EXPECT_EQ(refused("from = 2\n"), "ground.horizontal.from = 2: must be before the record's end");
}

TEST(GroundReading, AStepBeyondTheUsualLimitsIsReadWhereTheyAreNone) {
  const TemporaryFolder folder;
  folder.write("slow.csv", "# units: m/s2\n# dt = 1\n0\n1\n");
  const std::string lines = two_blocks() + "[ground.horizontal]\nrecord = \"slow.csv\"\n";
  EXPECT_THROW(read_scene(folder.write("scene.toml", lines)), InputError);
  EXPECT_EQ(read_scene(folder.write("scene.toml", lines + "limits = \"none\"\n")).horizontal.interval, 1);
}

TEST(GroundReading, AChannelAfterTheRecordsNameIsNoPartOfItsPath) {
  EXPECT_EQ(
      error_in("record = \"none.v2:2\"\n"),
      "scene.toml:14: ground.horizontal.record = \"none.v2:2\": must be a record's file, none is at none.v2");
}

TEST(GroundReading, AMissingRecordIsNamedWithItsPath) {
  EXPECT_EQ(
      error_in("record = \"none.at2\"\n"),
      "scene.toml:14: ground.horizontal.record = \"none.at2\": must be a record's file, none is at none.at2");
  EXPECT_EQ(error_in("record = \"..\"\n"),
            "scene.toml:14: ground.horizontal.record = \"..\": must be a record's file, none is at ..");
}

TEST(GroundReading, ScaleAndPeakExcludeEachOther) {
  EXPECT_EQ(
      error_in("samples = [1]\ninterval = 1\nscale = 2\npeak = 3\n"),
      "scene.toml:17: ground.horizontal.peak = 3: must be left out where scale is given (scene.toml:16)");
}

TEST(GroundReading, RecordAndSamplesExcludeEachOther) {
  EXPECT_EQ(
      error_in("record = \"a\"\nsamples = [1, 2]\ninterval = 1\n"),
      "scene.toml:16: ground.horizontal.interval: unknown key, must be one of record, from, to, scale, peak, time_scale, limits");
  EXPECT_EQ(
      error_in("record = \"a\"\ninterval = 1\n"),
      "scene.toml:15: ground.horizontal.interval: unknown key, must be one of record, from, to, scale, peak, time_scale, limits");
}

TEST(GroundReading, OneSourceIsNeeded) {
  EXPECT_EQ(
      error_in(""),
      "scene.toml:13: ground.horizontal.record: missing, must be given, or samples and interval, a pulse, "
      "synthetic or velocity_steps in its place");
  EXPECT_EQ(error_in("samples = [1]\n"),
            "scene.toml:13: ground.horizontal.interval: missing, must be a number");
  EXPECT_EQ(error_in("samples = []\ninterval = 1\n"),
            "scene.toml:14: ground.horizontal.samples = an array of 0: must be at least one number");
}

TEST(GroundReading, ASyntheticMotionIsMadeFromItsSeed) {
  const GroundMotion motion =
      read_ground("synthetic = 3\npeak = 2\nduration = 10\ninterval = 0.02\nfrequency = 2\ndamping = 0.4\n");
  EXPECT_EQ(motion.samples, make_synthetic({3, 2, 10, 0.02, 2, 0.4}).samples);
  EXPECT_EQ(read_ground("synthetic = 3\npeak = 2\n").samples, make_synthetic({.seed = 3, .peak = 2}).samples);
}

TEST(GroundReading, ASyntheticMotionHasItsOwnKeysAndRanges) {
  EXPECT_EQ(error_in("synthetic = 3\n"), "scene.toml:13: ground.horizontal.peak: missing, must be a number");
  EXPECT_EQ(
      error_in("synthetic = -1\npeak = 1\n"),
      "scene.toml:14: ground.horizontal.synthetic = -1: must be a whole number from 0 to 9007199254740992");
  EXPECT_EQ(
      error_in("synthetic = 1.5\npeak = 1\n"),
      "scene.toml:14: ground.horizontal.synthetic = 1.5: must be a whole number from 0 to 9007199254740992");
  // A whole number that no double is.
  EXPECT_EQ(error_in("synthetic = 9007199254740993\npeak = 1\n"),
            "scene.toml:14: ground.horizontal.synthetic = 9007199254740994: must be a whole number from 0 to "
            "9007199254740992");
  EXPECT_EQ(error_in("synthetic = 1\npeak = 1\nscale = 2\n"),
            "scene.toml:16: ground.horizontal.scale: unknown key, must be one of synthetic, peak, duration, "
            "interval, frequency, damping");
  EXPECT_EQ(
      error_in("synthetic = 1\npeak = 1\ninterval = 2\n"),
      "scene.toml:16: ground.horizontal.interval = 2: must be from 0.001 to 1.25, the duration in 20000 "
      "to 16 parts");
  EXPECT_EQ(
      error_in("synthetic = 1\npeak = 1\nfrequency = 30\n"),
      "scene.toml:16: ground.horizontal.frequency = 30: must be from 0.05, one cycle in the duration, to "
      "25 Hz");
  EXPECT_EQ(error_in("synthetic = 1\npeak = -1\n"),
            "scene.toml:15: ground.horizontal.peak = -1: must be a number from 1e-20 to 1e+20");
}

TEST(GroundReading, NumbersOutOfRangeAreRefused) {
  EXPECT_EQ(error_in("samples = [1]\ninterval = 0\n"),
            "scene.toml:15: ground.horizontal.interval = 0: must be a number from 1e-20 to 1e+20");
  EXPECT_EQ(error_in("samples = [\n  1,\n  nan]\ninterval = 1\n"),
            "scene.toml:16: ground.horizontal.samples.2 = nan: must be a finite number");
  EXPECT_EQ(error_in("samples = [1]\ninterval = 1\nscale = inf\n"),
            "scene.toml:16: ground.horizontal.scale = inf: must be a number from -1e+20 to 1e+20");
  EXPECT_EQ(error_in("samples = [1]\ninterval = 1\npeak = -3\n"),
            "scene.toml:16: ground.horizontal.peak = -3: must be a number from 1e-20 to 1e+20");
  EXPECT_EQ(error_in("samples = [0, 0]\ninterval = 1\npeak = 3\n"),
            "scene.toml:16: ground.horizontal.peak = 3: must be left out where every sample is zero");
  EXPECT_EQ(error_in("samples = [1e10]\ninterval = 1\nscale = 1e20\n"),
            "scene.toml:14: ground.horizontal.samples.1 = 1e+30: must be a number from -1e+20 to 1e+20");
}

}  // namespace
}  // namespace rockstack
