#include "analytic/scene/ground/pulse.hpp"

#include <gtest/gtest.h>

#include "analytic/scene/ground/ground_motion.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "tests/analytic/scene/input/scene_text.hpp"

namespace rockstack {
namespace {

constexpr std::array shapes{PulseShape::sine,      PulseShape::cosine, PulseShape::half_sine,
                            PulseShape::rectangle, PulseShape::ricker, PulseShape::mavroeidis_papageorgiou};

Pulse pulse_of(PulseShape shape) {
  return {shape, 3.0, 0.8, 0.25, 2.5, 0.7};
}

TEST(Pulse, AccelerationIsTheDerivativeOfVelocity) {
  for (const PulseShape shape : shapes) {
    const Pulse pulse = pulse_of(shape);
    const double step = 1e-4;
    for (int i = 1; i < 30; ++i) {
      const double t = length(pulse) * i / 30;
      const double slope = (velocity(pulse, t + step) - velocity(pulse, t - step)) / (2 * step);
      // The central difference errs by step²/6 times the third derivative of the velocity, and that by less
      // than A (8 · 2π/T)², the steepest being Ricker's; the rounding by ε A T / step.
      const double rate = 8 * 2 * std::numbers::pi / pulse.period;
      EXPECT_NEAR(slope, acceleration(pulse, t), step * step / 6 * 3.0 * rate * rate + 1e-11);
    }
  }
}

TEST(Pulse, MeanOverAStepIsTheIntegral) {
  for (const PulseShape shape : shapes) {
    GroundMotion motion;
    motion.pulse = pulse_of(shape);
    // The midpoint rule over pieces of 1e-4 s that meet the pulse's start; it errs by h²/24 of the second
    // derivative.
    const double to = motion.end() - 0.05;
    const int pieces = static_cast<int>(std::lround((to - 0.25) / 1e-4));
    double sum = 0;
    for (int i = 0; i < pieces; ++i) sum += acceleration(motion, 0.25 + (to - 0.25) * (i + 0.5) / pieces);
    EXPECT_NEAR(mean_acceleration(motion, 0.0, to) * to, sum * (to - 0.25) / pieces, 1e-6);
  }
}

TEST(Pulse, IsStillBeforeAndAfter) {
  for (const PulseShape shape : shapes) {
    GroundMotion motion;
    motion.pulse = pulse_of(shape);
    EXPECT_EQ(acceleration(motion, 0.2499), 0);
    EXPECT_EQ(acceleration(motion, motion.end() + 1e-9), 0);
    EXPECT_EQ(mean_acceleration(motion, motion.end() + 1, motion.end() + 2), 0);
  }
}

TEST(Pulse, WhatIsCutOffRickersPulseIsBelowRounding) {
  const Pulse pulse = pulse_of(PulseShape::ricker);
  EXPECT_LT(std::abs(acceleration(pulse, 0.0)), 1e-15 * 3.0);
  EXPECT_DOUBLE_EQ(acceleration(pulse, 2 * pulse.period), pulse.amplitude);
}

TEST(Pulse, IsReadFromASceneWithItsOwnKeysOnly) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& lines) {
    return read_scene(folder.write("scene.toml", two_blocks() + "[ground.horizontal]\n" + lines)).horizontal;
  };
  const GroundMotion motion = read("pulse = \"half-sine\"\namplitude = -2\nperiod = 0.5\nstart = 0.1\n");
  ASSERT_TRUE(motion.pulse);
  EXPECT_EQ(motion.pulse->shape, PulseShape::half_sine);
  EXPECT_DOUBLE_EQ(motion.end(), 0.35);
  EXPECT_DOUBLE_EQ(acceleration(motion, 0.225), -2);
  EXPECT_THROW(read("pulse = \"sine\"\namplitude = 2\nperiod = 0\n"), InputError);
  EXPECT_THROW(read("pulse = \"sine\"\namplitude = 2\nperiod = 1\nstart = -1\n"), InputError);
  EXPECT_THROW(read("pulse = \"sine\"\namplitude = 2\nperiod = 1\npeak = 3\n"), InputError);
  EXPECT_THROW(read("pulse = \"mavroeidis-papageorgiou\"\namplitude = 2\nperiod = 1\ncycles = 1\n"),
               InputError);
  EXPECT_THROW(read("pulse = \"square\"\namplitude = 2\nperiod = 1\n"), InputError);
}

}  // namespace
}  // namespace rockstack
