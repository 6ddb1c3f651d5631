#include "comparisons/studies/round/study.hpp"

#include <gtest/gtest.h>

#include "analytic/scene/files/file_text.hpp"
#include "analytic/scene/input/json_reader.hpp"
#include "analytic/solve.hpp"
#include "comparisons/suites/shipped.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

class RoundStudy : public ::testing::Test {
 protected:
  static SceneDocument shipped_document(const std::string& name,
                                        const std::vector<std::string>& overrides = {}) {
    return read_document(find_file(name, "cylinders"), overrides);
  }

  std::string refusal(const std::string& name, const std::vector<std::string>& overrides) {
    try {
      make_round(shipped_document(name, overrides), library_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  }

  MotionLibrary library_;
};

TEST_F(RoundStudy, WhatComesWithTheProgramIsSolved) {
  for (const std::string& name : shipped_names("cylinders")) {
    RoundScene scene = make_round(shipped_document(name), library_);
    scene.duration = 0.5;
    EXPECT_EQ(solve_round(scene, {0, 0.5}).samples.size(), 2u) << name;
  }
}

TEST_F(RoundStudy, AWrongValueIsNamed) {
  EXPECT_NE(refusal("turn", {"initial.tilt=1"}).find("initial.tilt = 1: must be below 0.9078874949"),
            std::string::npos);
  EXPECT_NE(refusal("turn", {"radius=0"}).find("radius = 0: must be"), std::string::npos);
  EXPECT_NE(refusal("turn", {"initial.spinn=1"}).find("did you mean spin?"), std::string::npos);
  EXPECT_NE(refusal("pulse", {"initial.spin=1"}).find("initial.spin = 1: must be left out"),
            std::string::npos);
  EXPECT_NE(refusal("wobble", {"initial.spin=1"}).find("left out beside"), std::string::npos);
  EXPECT_NE(refusal("wobble", {"initial.tilt=0.3"}).find("past balance"), std::string::npos);
  EXPECT_NE(refusal("turn", {"ground.x.velocity_steps=[1]"}).find("accelerations alone"), std::string::npos);
}

// A threshold is a number of the exact motion alone: the derivation does not matter, nor does what happens
// below what is tried. In the plane of x it is that of a block with the inertia of the cylinder.
TEST_F(RoundStudy, BothDerivationsToppleFromTheSameScale) {
  const VariedKey vary{"ground.scale", 0.498, 0.506};
  const SceneDocument document = shipped_document("pulse", {"duration=8"});
  const RoundThreshold angles = round_threshold(document, vary, 2, library_);
  const RoundThreshold axis =
      round_threshold(shipped_document("pulse", {"duration=8", "equations=axis"}), vary, 2, library_);
  ASSERT_TRUE(angles.space && axis.space);
  EXPECT_NEAR(*angles.space, *axis.space, 1e-11);
  EXPECT_FALSE(angles.plane);
  const RoundThreshold plane = round_threshold(document, {"ground.scale", 0.6, 0.61}, 2, library_);
  ASSERT_TRUE(plane.plane);
  for (const double factor : {1 - 1e-9, 1 + 1e-9}) {
    Scene block;
    block.duration = 20;
    block.blocks = {{0.25, 1, 1, 0.0625 / 4 + 1.0 / 3}};
    block.initial = {{0}, {0}};
    block.horizontal.pulse =
        Pulse{.shape = PulseShape::sine, .amplitude = *plane.plane * factor * 9.81, .period = 0.5};
    const History history = solve(block);
    EXPECT_EQ(history.events.back().kind == EventKind::topple, factor > 1);
  }
}

TEST_F(RoundStudy, FilesHoldTheMotion) {
  const TemporaryFolder folder;
  const RoundScene scene = make_round(shipped_document("turn", {"duration=2"}), library_);
  const RoundMotion motion = solve_round(scene, regular_times(0.5, 2));
  const Json json = write_round(scene, motion, folder.path(), "");
  EXPECT_EQ(json.at("first_turn"), motion.events[1].second.rolling.azimuth);
  EXPECT_FALSE(json.at("topples").get<bool>());
  EXPECT_TRUE(json.at("plane").is_null());
  const std::string history = file_text(folder.path() / "history.csv"),
                    events = file_text(folder.path() / "events.csv");
  EXPECT_EQ(std::ranges::count(history, '\n'), 6);
  EXPECT_EQ(std::ranges::count(events, '\n'), 1 + std::ssize(motion.events));
  EXPECT_NE(events.find("\npassage,0.419"), std::string::npos);
}

}  // namespace
}  // namespace rockstack
