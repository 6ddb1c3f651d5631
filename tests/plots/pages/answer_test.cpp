#include "plots/pages/answer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockstack::plots {
namespace {

plots::Run made_up(const std::string& solver, double dt, double error) {
  plots::Run one;
  one.name = solver;
  one.scene = "a";
  one.engine = "bullet";
  one.solver = solver;
  one.settings = "tuned";
  one.status = "done";
  one.dt = dt;
  one.rms_angle_difference = error;
  one.rms_angle_difference_lower = one.rms_angle_difference_upper = std::nan("");
  return one;
}

Comparison made_of(std::vector<Run> runs) {
  Comparison comparison;
  comparison.scenes.resize(2);
  comparison.scenes[0].name = "a";
  comparison.scenes[1].name = "b";
  comparison.runs = std::move(runs);
  return comparison;
}

TEST(Answer, MediansAndQuartilesAreTakenAtTheStepThatMostRunsHave) {
  // At 1 ms nncg has 1 to 5 mrad, with quartiles 2 and 4, and lemke 100. A smaller step that one run alone
  // has does not count for the first sentence; with it, quartiles lie in the midst of 1 and 2 and of 4 and 5.
  const std::vector<std::string> sentences =
      answer(made_of({made_up("nncg", 1e-3, 4e-3), made_up("nncg", 1e-3, 1e-3), made_up("nncg", 1e-3, 3e-3),
                      made_up("nncg", 1e-3, 2e-3), made_up("nncg", 1e-3, 5e-3), made_up("lemke", 1e-3, 0.1),
                      made_up("lemke", 1e-4, 1e-6)}));
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_EQ(
      sentences[0],
      "At a step of 1 ms, over 2 scenes, bullet nncg (tuned) is nearest to the exact motion: its median RMS "
      "angle difference is 0.003 rad (quartiles 0.002 to 0.004); bullet lemke (tuned) is furthest from it, "
      "with 0.1 rad.");
  EXPECT_EQ(
      sentences[1],
      "Over all 7 engine runs at all steps the median is 0.003 rad (quartiles 0.0015 to 0.0045), from 1e-06 "
      "to 0.1 rad.");
}

TEST(Answer, SharesThatToppleComeFirst) {
  Comparison comparison = made_of({made_up("nncg", 1e-3, 0.1)});
  comparison.distances = {{"a", "nncg", "impacts", 0.5, 0.2, 50, 100, 60},
                          {"a", "nncg", "toppled", 0.28, 0.26, 50, 0.64, 0.92}};
  EXPECT_EQ(answer(comparison).front(),
            "Of 50 scenes that differ a little 64 % topple exactly, and 92 % with bullet nncg (tuned, 1 ms) "
            "– more than "
            "chance apart.");
}

TEST(Answer, WithoutAnythingToCompareThereIsNone) {
  EXPECT_TRUE(answer(made_of({})).empty());
  plots::Run failed = made_up("nncg", 1e-3, 0.1);
  failed.status = "failed";
  EXPECT_TRUE(answer(made_of({failed})).empty());
}

}  // namespace
}  // namespace rockstack::plots
