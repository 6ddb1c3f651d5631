#include "comparisons/studies/threshold/threshold.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/input/toml_reader.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

constexpr const char* block_at_a_speed = R"(duration = 30.0
equations = "small-angle"
[[blocks]]
width = 0.4
height = 1.6
density = 2500
[initial]
velocities = [0.1]
)";

constexpr const char* block_under_a_sine = R"(duration = 20.0
[[blocks]]
width = 0.4
height = 1.6
density = 2500
[ground.horizontal]
pulse = "sine"
amplitude = 1.0
period = 0.7
)";

class Thresholds : public ::testing::Test {
 protected:
  SceneDocument document(const char* text) {
    folder_.write("scene.toml", text);
    return read_document(folder_.path() / "scene.toml");
  }

  Threshold found(const char* scene, const std::string& range, const char* outcome = "topples",
                  std::size_t values = 50) {
    return threshold(document(scene), {varied_key("--vary", range), outcome_named(outcome, 1), values},
                     library_);
  }

  static constexpr double slenderness_ratio = 0.25, radius = 0.82462112512353211,
                          g = 9.81;  // √(0.2² + 0.8²) m
  const double alpha = std::atan(slenderness_ratio);
  const double p = std::sqrt(3 * g / (4 * radius));  // of Housner 1963

  TemporaryFolder folder_;
  MotionLibrary library_;
};

// The speed at θ = 0 decides by θ'' = p² (θ − α): the block topples where it is above p α. Twelve digits
// are closed in on; by the end of the scene, after e^(p · 30) ≈ 10⁴⁰ times growth, none is undecided.
TEST_F(Thresholds, ASpeedTopplesABlockFromPTimesItsSlenderness) {
  const Threshold at = found(block_at_a_speed, "initial.velocities.1=0:2");
  ASSERT_TRUE(at.first());
  EXPECT_NEAR(*at.first(), p * alpha, 1e-11 * p * alpha);
  EXPECT_EQ(at.ranges.size(), 2u);
}

// What topples at the lower end has no first value above it: it stands from g = 4R/3 (θ̇/α)² on.
TEST_F(Thresholds, WhatTopplesFromTheLowerEndHasNoFirst) {
  SceneDocument faster = document(block_at_a_speed);
  apply_override(faster.root, "initial.velocities=[1]");
  const ThresholdRequest request{varied_key("--vary", "gravity=10:30"), outcome_named("topples", 1), 20};
  const Threshold at = threshold(faster, request, library_);
  const double least = 4 * radius / 3 / (alpha * alpha);
  EXPECT_FALSE(at.first());
  EXPECT_FALSE(
      (Threshold{{}, {{1, 2, true}, {3, 4, false}, {5, 6, true}}}).first());  // nor where it comes back
  ASSERT_EQ(at.ranges.size(), 2u);
  EXPECT_NEAR(at.ranges[1].from, least, 1e-11 * least);
  EXPECT_EQ(threshold_headline(request, at)[0].find(" first "), std::string::npos);
}

// The peak below it: θ = α − √(α² − (θ̇/p)²).
TEST_F(Thresholds, APeakIsReachedAtItsOwnSpeed) {
  const Threshold at = found(block_at_a_speed, "initial.velocities.1=0:0.5", "peak_ratio>0.25");
  ASSERT_TRUE(at.first());
  const double speed = p * alpha * std::sqrt(1 - 0.75 * 0.75);
  EXPECT_NEAR(*at.first(), speed, 1e-11 * speed);
}

// A block lifts from g tan α on, whatever its size: West's condition.
TEST_F(Thresholds, ABlockLiftsFromGTimesItsSlope) {
  const Threshold at = found(block_under_a_sine, "ground.horizontal.amplitude=0:5", "lifts");
  ASSERT_TRUE(at.first());
  EXPECT_NEAR(*at.first(), g * slenderness_ratio, 1e-11 * g);
}

// Under a whole sine a block topples after an impact in one range, and without one in another; between them
// it stands. Each end is one: the outcome differs on both sides of it.
TEST_F(Thresholds, TopplingIsNotMonotone) {
  const Threshold at = found(block_under_a_sine, "ground.horizontal.amplitude=1:20", "topples", 200);
  std::vector<bool> outcomes = mapped(at.ranges, [](const OutcomeRange& range) { return range.happens; });
  EXPECT_EQ(outcomes, (std::vector{false, true, false, true}));
  for (std::size_t i = 1; i < at.ranges.size(); ++i) {
    EXPECT_LT(at.ranges[i - 1].to, at.ranges[i].from);
    EXPECT_LE(at.ranges[i].from - at.ranges[i - 1].to, 1e-12 * at.ranges[i].from);
  }
}

TEST_F(Thresholds, WhatIsWrongIsNamed) {
  const auto message = [](auto&& part) -> std::string {
    try {
      part();
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_EQ(message([] { varied_key("--vary", "gravity=9:8"); }),
            "--vary gravity=9:8: must be KEY=LOW:HIGH with LOW below HIGH");
  EXPECT_NE(message([] { outcome_named("tilts", 1); }).find("must be topples, lifts or COLUMN>NUMBER"),
            std::string::npos);
  EXPECT_NE(message([&] {
              found(block_at_a_speed, "gravity=-2:-1");
            }).find("--vary gravity: no value has a motion"),
            std::string::npos);
}

// g tan α / a block's size: the speed that topples falls with the square root of its size, as p does.
TEST_F(Thresholds, ASpectrumFollowsTheSize) {
  const ThresholdSpectrum spectrum =
      threshold_spectrum(document(block_at_a_speed),
                         {varied_key("--vary", "initial.velocities.1=0:4"), outcome_named("topples", 1), 20},
                         varied_key("--over", "gravity=2.4525:9.81"), 2, library_, [](std::size_t) {});
  EXPECT_NEAR(*spectrum.thresholds[1].first() / *spectrum.thresholds[0].first(), 2, 1e-11);
}

}  // namespace
}  // namespace rockstack
