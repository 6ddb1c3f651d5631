#include "plots/data/scores.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "plots/pages/sections.hpp"

namespace rockstack::plots {
namespace {

Run made_up(const std::string& solver, const std::string& settings, const std::string& scene, double dt,
            double error, double energy) {
  Run run;
  run.run = scene + solver;
  run.scene = scene;
  run.engine = "ode";
  run.solver = solver;
  run.settings = settings;
  run.dt = dt;
  run.steps = 100;
  run.stepping_time_minimum = 1e-3;
  run.error = run.rms_angle_difference = error;
  run.motion = 0.1;
  run.first_impact_time_difference = -dt / 2;
  run.energy_gain = energy;
  return run;
}

/// Two solvers in three scenes: `step` errs by 2, 4 and 6 mrad at 1 ms, `quickstep` by 1, 2 and 9, twice as
/// much at 2 ms. `quickstep` makes energy in scene b.
Comparison three_scenes() {
  Comparison comparison;
  const std::array errors{std::pair{"step", std::array{2e-3, 4e-3, 6e-3}},
                          std::pair{"quickstep", std::array{1e-3, 2e-3, 9e-3}}};
  const std::array names{"a", "b", "c"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    ComparedScene& scene = comparison.scenes.emplace_back();
    scene.name = names.at(i);
    scene.duration = 3;
    for (const auto& [solver, all] : errors)
      for (const double dt : {1e-3, 2e-3})
        comparison.runs.push_back(made_up(solver, "default", names.at(i), dt, all.at(i) * dt / 1e-3,
                                          solver == std::string("quickstep") && i == 1 ? 0.02 : 0));
  }
  std::vector<ReplicatedRow> rows;
  for (const Run& run : comparison.runs) rows.push_back({run, {*run.error}});
  comparison.verdict.ranking = rank_all(rows);
  return comparison;
}

const SolverQuestion& question(const std::string& name) {
  return *std::find_if(solver_questions().begin(), solver_questions().end(),
                       [&](const SolverQuestion& one) { return one.name == name; });
}

TEST(Scores, AreMediansOverScenesAtTheSmallestStepThatMostHave) {
  const Comparison comparison = three_scenes();
  const std::vector<Score> list = scores(comparison, question("accuracy"));
  ASSERT_EQ(list.size(), 2u);
  for (const Score& score : list)
    for (const plots::Run& run : score.runs) EXPECT_EQ(run.dt, 1e-3);
  EXPECT_EQ(list[0].runs.front().solver, "quickstep");
  EXPECT_EQ(list[0].median, 1);  // of 1, 1 and 3/2 times the least of each scene
  EXPECT_EQ(list[0].worst().scene, "c");
  EXPECT_EQ(list[1].median, 2);  // of 2, 2 and 1
}

TEST(Scores, WhatASmallerStepLeavesIsTheRatioOfErrors) {
  for (const Score& score : scores(three_scenes(), question("convergence"))) EXPECT_EQ(score.median, 0.5);
  for (const Score& score : scores(three_scenes(), question("first-impact"))) EXPECT_EQ(score.median, 0.5);
  for (const Score& score : scores(three_scenes(), question("cost"))) EXPECT_EQ(score.median, 1e-5);
}

TEST(Scores, ASolverWithoutAnAnswerInASceneComesLast) {
  Comparison comparison = three_scenes();
  for (plots::Run& run : comparison.runs)
    if (run.solver == "quickstep" && run.scene == "b") run.status = RunStatus::failed;
  const std::vector<Score> list = scores(comparison, question("accuracy"));
  EXPECT_EQ(list[0].runs.front().solver, "step");
  EXPECT_EQ(list[1].runs.size(), 2u);
  EXPECT_DOUBLE_EQ(list[1].median, 1.25);
}

TEST(Scores, ScenesAtRestAreNotCompared) {
  Comparison comparison = three_scenes();
  for (plots::Run& run : comparison.runs)
    if (run.scene == "a") run.motion = 0;
  for (const Score& score : scores(comparison, question("accuracy"))) EXPECT_EQ(score.runs.size(), 2u);
}

TEST(Scores, NobodyIsCalledNearestThatOneRunEachDoesNotTellApart) {
  EXPECT_EQ(first_of_all(three_scenes()), "none can be told apart");
}

TEST(Scores, TwoScenesOrOneSolverAreTooFew) {
  Comparison comparison = three_scenes();
  EXPECT_TRUE(has_scores(comparison));
  std::erase_if(comparison.runs, [](const plots::Run& run) { return run.scene == "c"; });
  EXPECT_FALSE(has_scores(comparison));
  EXPECT_TRUE(remarks(comparison).empty());
}

TEST(Remarks, TellWhatASolversAuthorCanRunAgain) {
  const std::vector<SolverRemarks> all = remarks(three_scenes());
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].solver, "ode:quickstep");
  EXPECT_EQ(all[0].list.front().sentence,
            "Rank 1 of 2 sets, which 2 share: with its default set its error is 1.1 times the least, in the "
            "geometric mean of 6 pairs of scene and step; at 1 ms most in c (0.009).");
  EXPECT_EQ(all[0].list.front().command,
            "rockstack compare c --engine ode:quickstep --dt 0.001 --set duration=3 --out DIR");
  const auto energy = std::find_if(all[0].list.begin(), all[0].list.end(), [](const Remark& one) {
    return one.sentence == "In b its contacts make energy: 0.02 of the stack's weight times height.";
  });
  ASSERT_NE(energy, all[0].list.end());
  EXPECT_EQ(energy->command,
            "rockstack compare b --engine ode:quickstep --dt 0.001 --set duration=3 --out DIR");
  for (const Remark& one : all[1].list) EXPECT_EQ(one.sentence.find("make energy"), std::string::npos);
}

}  // namespace
}  // namespace rockstack::plots
