#include <gtest/gtest.h>

#include <cmath>

#include "analytic/scene/input/scene_file.hpp"
#include "analytic/solve.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/studies/lessons/mechanics.hpp"

namespace rockstack {
namespace {

constexpr double round_off = 1e-11;  // of a solver's times and velocities, and of their differences

Scene shipped_scene(const std::string& name) {
  return read_scene(std::filesystem::path(ROCKSTACK_LESSONS) / "../../scenes" / (name + ".toml"));
}

// At ω² = p² h/b the ground's force points up the block: nothing slips before the impact, whatever the
// friction.
TEST(ContactLessons, ABlockThatLandsKeepsTheShareOfTheClosedForm) {
  for (const double r : {1.8, 2.0, 3.0})
    for (const double friction : {0.15, 0.99 * impact_friction(r), 1.01 * impact_friction(r), 2.0}) {
      Scene scene;
      scene.blocks = {make_block(1, r, 2500)};
      scene.law = Law::unilateral;
      scene.friction = {friction};
      scene.initial = {{1e-3}, {-std::sqrt(scene.gravity * r / 2 / ((1 + r * r) / 3))}};
      scene.duration = 0.01;
      const History history = solve(scene);
      ASSERT_FALSE(history.events.empty());
      const Event& impact = history.events.front();
      ASSERT_EQ(impact.kind, EventKind::impact);
      EXPECT_NEAR(impact.after[0] / impact.before[0], impact_ratio(r, friction), round_off)
          << r << ' ' << friction;
      EXPECT_EQ(impact.to.slides[0] != 0, friction < impact_friction(r)) << r << ' ' << friction;
    }
}

// Pivots tell without a solver of slip what they need at their impacts.
TEST(ContactLessons, AnImpactNeedsTheFrictionOfTheClosedForm) {
  Scene scene = shipped_scene("rubbing-block");
  scene.duration = 0.6;  // the first impact alone
  EXPECT_NEAR(contact_need(scene).impulse.friction, impact_friction(2), round_off);
}

TEST(ContactLessons, AThrownBlockFliesAsTheClosedFormSays) {
  const Scene scene = shipped_scene("thrown-block");
  const Throw thrown =
      thrown_by_sine(scene.vertical.pulse->amplitude, scene.vertical.pulse->period, scene.gravity);
  EXPECT_NEAR(thrown.lift_off, 0.4 * 7 / 12, round_off) << "at twice gravity the sine is −1/2 there";
  const double top = thrown.lift_off + thrown.lift_off_rate / scene.gravity;
  const History history = solve(scene, {.sample_times = {top}});
  EXPECT_NEAR(first_event(history, EventKind::lift_off)->time, thrown.lift_off, round_off);
  EXPECT_NEAR(first_event(history, EventKind::impact)->time, thrown.landing, round_off);
  EXPECT_NEAR(history.gaps[0], thrown.highest, round_off);
  EXPECT_THROW(thrown_by_sine(9, 0.4, 9.81), std::domain_error);
  EXPECT_THROW(thrown_by_sine(10.5, 0.4, 9.81), std::domain_error) << "it lands before the pulse ends";
}

// On either side of the friction that jams, and of the rotation at which the corner leaves: as many forces
// obey by the two signs as the solver finds motions, and the one that holds is its force.
TEST(ContactLessons, ASlidingCornerHasAsManyMotionsAsItsSignsSay) {
  Scene scene = shipped_scene("painleve-several");
  scene.duration = 1e-3;
  const Block& block = scene.blocks.front();
  const double limit = jamming_friction(block, scene.initial.angles.front());
  scene.friction = {1};
  const double leaves = std::sqrt(scene.gravity * std::pow(scene.initial.velocities.front(), 2) /
                                  (sliding_corner(scene).free + scene.gravity));
  for (const double friction : {0.3, 0.99 * limit, 1.01 * limit, 3.0})
    for (const double rate : {0.0, 0.99 * leaves, 1.01 * leaves}) {
      scene.friction = {friction};
      scene.initial.velocities = {rate};
      const std::vector<double> forces = sliding_corner(scene).forces();
      EXPECT_EQ(forces.size(), friction < limit ? 1U : rate < leaves ? 0U : 2U) << friction << ' ' << rate;
      const History history = solve(scene, {.sample_times = {0}});
      const bool at_once = !history.events.empty() && history.events.front().time == 0;
      const Consistency found = at_once ? history.events.front().consistency : Consistency::consistent;
      EXPECT_EQ(found, forces.empty()       ? Consistency::none
                       : forces.size() == 2 ? Consistency::several
                                            : Consistency::consistent)
          << friction << ' ' << rate;
      if (forces.size() == 1) {
        EXPECT_NEAR(history.reactions.front().normal, forces.front(), 1e-9 * block.mass * scene.gravity);
      }
      if (forces.empty()) {
        EXPECT_NEAR(history.events.front().after[0], rate_once_stuck(scene), round_off);
      }
    }
  EXPECT_NEAR(jamming_friction(make_block(1, 3, 1), 0), (4 + 9) / 9.0, 1e-15);
}

TEST(ContactLessons, FlightSavesNoFriction) {
  Scene scene = shipped_scene("thrown-block");
  const Throw thrown =
      thrown_by_sine(scene.vertical.pulse->amplitude, scene.vertical.pulse->period, scene.gravity);
  scene.initial.slip_velocities = {3};
  scene.friction = {0.2};
  scene.duration = 2;
  const Slide form = slide_through(thrown, 3, 0.2, scene.gravity);
  const History history = solve(scene, {.sample_times = {scene.duration}});
  EXPECT_NEAR(history.events.back().time, 3 / (0.2 * scene.gravity), round_off);
  EXPECT_NEAR(history.events.back().time, form.stop, round_off);
  EXPECT_NEAR(history.slips.back(), form.distance, round_off);
}

// Each branch of the flow, and the friction on either side of it.
TEST(ContactLessons, TheLawIsChosenByWhatPivotsNeed) {
  Scene block = shipped_scene("housner-block");
  const ContactNeed need = contact_need(block);
  const double enough = std::max(need.force.friction, need.impulse.friction);
  block.friction = {enough * (1 + 1e-9)};
  EXPECT_EQ(law_for(contact_need(block)), Law::consistent);
  EXPECT_EQ(first_failure(contact_need(block)), "nothing");
  block.friction = {enough * (1 - 1e-9)};
  EXPECT_EQ(law_for(contact_need(block)), Law::unilateral);
  const ContactNeed rubbing = contact_need(shipped_scene("rubbing-block"));
  EXPECT_LT(rubbing.impulse.first_slip_time, rubbing.force.first_slip_time);
  EXPECT_EQ(law_for(rubbing), Law::unilateral);
  const ContactNeed thrown = contact_need(shipped_scene("thrown-block"));
  EXPECT_NEAR(thrown.first_pull(), 0.4 * 7 / 12, 1e-9);
  EXPECT_EQ(first_failure(thrown), "would pull at 0.233 s");
}

}  // namespace
}  // namespace rockstack
