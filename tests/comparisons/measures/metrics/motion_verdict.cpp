#include "comparisons/measures/metrics/motion_verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analytic/solve.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

Scene one_block(double angle, double ground) {
  Scene scene;
  scene.duration = 1;
  scene.blocks = {make_block(0.5, 2.0, 2500)};
  scene.initial = {{angle}, {0}};
  scene.horizontal = {1.0, {ground, ground}};
  return scene;
}

std::string verdict_of(const Scene& scene) {
  return motion_verdict(
      scene, solve(scene, {.sample_times = {0, 0.25, 0.5, 0.75, 1}, .validity = true, .peaks = true}));
}

TEST(MotionVerdict, ABlockThatIsCarriedAlongRests) {
  EXPECT_EQ(verdict_of(one_block(0, 2.0)), "rests throughout; needs friction 0.21");  // 2/9.81, up
}

// Five samples of 0.5 s each, of which the scene has two.
TEST(MotionVerdict, ASceneThatEndsBeforeItsRecordSaysSo) {
  Scene scene = one_block(0, 0);
  scene.horizontal = {0.5, {0, 0.1, -0.1, 0.1, 0}};
  EXPECT_NE(verdict_of(scene).find("rests throughout (the scene ends at 1 s, its ground at 2 s); needs"),
            std::string::npos)
      << verdict_of(scene);
  scene.horizontal.interval = 0.25;
  EXPECT_EQ(verdict_of(scene).find("its ground at"), std::string::npos);
}

// A squat block that leans right on another that leans left: its interface pulls from the start, most later.
TEST(MotionVerdict, APullIsToldWithItsFirstTime) {
  Scene scene;
  scene.law = Law::paper;
  scene.duration = 1;
  scene.blocks = {make_block(1, 0.6, 2500), make_block(0.9, 0.7, 2500)};
  scene.initial = {{0.1, -0.1}, {0, 0}};
  const History history = solve(scene, {.sample_times = {0, 0.5, 1}, .validity = true, .peaks = true});
  EXPECT_GT(history.forces[1].least_normal_time, 0.1);
  const std::string verdict = motion_verdict(scene, history);
  EXPECT_EQ(verdict.find("not valid from 0 s, as interface 2 would have to pull; "), 0U) << verdict;
}

// With friction that is as good as infinite it pulls before anybody could tell a slip.
TEST(MotionVerdict, WhatPullsIsNotSaidToSlip) {
  Scene scene;
  History history;
  scene.blocks = {make_block(1, 1, 2500)};
  history.blocks = 1;
  history.times = {0, 1};
  history.angles = history.velocities = {0, 0};
  history.impulses.resize(1);
  history.forces.resize(1);
  history.forces[0].friction = INFINITY;
  history.forces[0].first_slip_time = 0.5;
  history.forces[0].first_pull_time = 0.6;
  EXPECT_EQ(
      motion_verdict(scene, history).rfind("not valid from 0.6 s, as interface 1 would have to pull; ", 0),
      0U);
  scene.friction.assign(scene.blocks.size(), 0.4);
  EXPECT_EQ(
      motion_verdict(scene, history)
          .rfind(
              "not valid from 0.5 s, as interface 1 would slip: it has friction 0.4 and no friction is enough; ",
              0),
      0U);
}

// Friction 0.2 gives way as the ground comes to 0.2 g, at 1.962/2 of its way to 2 m/s².
TEST(MotionVerdict, AnInterfaceThatWouldSlipIsToldFirst) {
  Scene scene = one_block(0, 2.0);
  scene.horizontal.samples = {0, 2};
  scene.friction.assign(scene.blocks.size(), 0.2);
  EXPECT_EQ(verdict_of(scene),
            "not valid from 0.981 s, as interface 1 would slip: it has friction 0.2 and needs 0.21; "
            "rests throughout");
  scene.friction.assign(scene.blocks.size(), 0.21);
  EXPECT_EQ(verdict_of(scene), "rests throughout; needs friction 0.21");
}

TEST(MotionVerdict, FrictionIsNamedWithItsInterfaceAndImpactsFirst) {
  Scene scene;
  History history;
  scene.duration = 1;
  scene.blocks = {make_block(1, 1, 2500), make_block(1, 1, 2500)};
  history.blocks = 2;
  history.times = {0, 1};
  history.angles = history.velocities = {0, 0, 0, 0};
  history.forces.resize(2);
  history.impulses.resize(2);
  history.forces[1].friction = 0.3;
  EXPECT_EQ(motion_verdict(scene, history), "rests throughout; needs friction 0.3 at interface 2");
  history.impulses[0].friction = 120.2;
  EXPECT_EQ(
      motion_verdict(scene, history),
      "rests throughout; needs friction 130 at interface 1 in impacts, 0.3 at interface 2 between them");
}

TEST(MotionVerdict, ABlockThatIsLetGoNeverLeansFurtherThanAtFirst) {
  // 0.1 rad over atan(1/4) = 0.24498 rad.
  EXPECT_EQ(
      verdict_of(one_block(0.1, 0))
          .find(
              "stands so far, still rocking at the end, 1 s; block 1 peaks at 0.41 of its slenderness angle at 0 s; needs "),
      0U);
}

TEST(MotionVerdict, AnAccelerationBeyondWidthOverHeightTopples) {
  const Scene scene = one_block(0, 9.0);
  const std::string verdict =
      motion_verdict(scene, solve(scene, {.sample_times = regular_times(0.01, 1), .validity = true}));
  EXPECT_EQ(verdict.find("block 1 topples at 0."), 0U) << verdict;
  EXPECT_NE(verdict.find("; not valid from 0."), std::string::npos) << verdict << ": it falls by then";
}

// A column of two equal blocks whose faces stay together goes over as one block of their height.
TEST(MotionVerdict, BlocksThatTurnAsOneToppleAsOne) {
  Scene scene = one_block(0.3, 0);
  scene.blocks = {make_block(0.5, 1.0, 2500), make_block(0.5, 1.0, 2500)};
  scene.initial = {{0.3, 0.3}, {0, 0}};
  scene.horizontal = {};
  scene.duration = 5;
  for (const Law law : {Law::consistent, Law::unilateral}) {
    scene.law = law;
    const std::string verdict =
        motion_verdict(scene, solve(scene, {.sample_times = regular_times(0.01, scene.duration)}));
    EXPECT_EQ(verdict.find("blocks 1 to 2 topple at "), 0U) << verdict;
  }
}

// Corner on corner the lower face would hold the upper block, T/N = 0.199, and the upper one not, 0.418.
TEST(MotionVerdict, TellsFromWhenOnSeveralMotionsObey) {
  Scene scene;
  scene.duration = 0.02;
  scene.law = Law::unilateral;
  scene.blocks = {make_block(1, 1, 2500), make_block(1, 2, 2500)};
  scene.initial = {{0, -0.2}, {0, 0}};
  const auto verdict = [&](double coefficient) {
    scene.friction = {coefficient, coefficient};
    return motion_verdict(scene, solve(scene, {.sample_times = {0, 0.02}, .peaks = true}));
  };
  EXPECT_NE(verdict(0.3).find("block 2 slips by up to "), std::string::npos);
  EXPECT_EQ(verdict(0.3).find("from 0 s on one of several motions that obey the laws of contact; "), 0U);
  EXPECT_NE(verdict(0.43).find("nothing slips or lifts"), std::string::npos);
  EXPECT_EQ(verdict(0.43).find("several"), std::string::npos);
}

TEST(MotionVerdict, AHistoryWithoutEventsIsJudgedByItsSamples) {
  const Scene scene = free_rocking(1);
  History history;
  history.blocks = 2;
  history.times = {0, 0.5};
  history.angles = {0, 0, 1e-5, 2e-5};
  history.velocities = {0, 0, 0, 0};
  EXPECT_EQ(motion_verdict(scene, history), "rests throughout");
  EXPECT_EQ(motion_verdict(scene, history, {.sinking = 0.086}), "rests, but sinks in by 86 mm");
  EXPECT_EQ(motion_verdict(scene, history, {.sinking = 1e-4}), "rests throughout") << "of 1.25 m";
  EXPECT_EQ(motion_verdict(scene, history, {.fallen = "block 2 at 0.4 s"}),
            "block 2 has fallen off at 0.4 s");
  history.angles[3] = 1.5;
  EXPECT_EQ(motion_verdict(scene, history), "block 2 topples at 0.5 s");
}

// A block that impacts press in for a moment has not sunk; one that stays in has.
TEST(MotionVerdict, SinkingIsWhatLasts) {
  std::vector<double> depths(100, 0.0);
  depths[50] = depths[95] = 0.3;
  EXPECT_EQ(support_of(depths, {INFINITY}).sinking, 0);
  std::fill(depths.begin() + 40, depths.end(), 0.2);
  EXPECT_EQ(support_of(depths, {INFINITY}).sinking, 0.2);
  EXPECT_EQ(support_of(depths, {INFINITY, 0.5, 0.25}).fallen, "block 3 at 0.25 s");
}

// Under its own weight a block goes down by m g over the stiffness of both corners, 9.81 mm.
TEST(MotionVerdict, AnExactMotionOnSpringsThatWereNotLoadedSinks) {
  Scene scene;
  scene.duration = 2;
  scene.law = Law::compliant;
  scene.blocks = {make_block(1, 2, 2500)};
  scene.initial = {{0}, {0}};
  scene.initial.preloaded = false;
  scene.springs.stiffness = {2.5e6};
  scene.springs.damping = {5e4};
  const SolveOptions options{.sample_times = regular_times(0.01, 2)};
  EXPECT_EQ(motion_verdict(scene, solve(scene, options)).substr(0, 27), "rests, but sinks in by 9.8 ");
  scene.initial.preloaded = true;
  EXPECT_EQ(motion_verdict(scene, solve(scene, options)).substr(0, 16), "rests throughout");
}

}  // namespace
}  // namespace rockstack
