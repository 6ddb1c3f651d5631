#include "comparisons/measures/metrics/contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

constexpr double friction = 0.4;
constexpr double speed = 2;

/// A squat block that slides until v₀/(μg) = 0.51 s, over v₀²/(2μg).
Scene sliding() {
  Scene scene;
  scene.law = Law::unilateral;
  scene.duration = 1;
  scene.blocks = {make_block(2, 1, 2500)};
  scene.initial = {{0}, {0}, {-speed}};
  scene.friction = {friction};
  return scene;
}

History sampled(const Scene& scene) {
  return solve(scene, {.sample_times = regular_times(0.01, scene.duration), .validity = true});
}

TEST(ContactSummary, OfABlockThatSlidesToItsHalt) {
  const Scene scene = sliding();
  const History history = sampled(scene);
  const double way = speed * speed / (2 * friction * scene.gravity);
  const auto summary = contact_summary(history);
  ASSERT_EQ(summary.size(), 1U);
  EXPECT_NEAR(summary[0].final_slip, -way, 1e-14);
  EXPECT_NEAR(summary[0].largest_slip, way, 1e-14);
  EXPECT_EQ(summary[0].highest_lift, 0);
  ASSERT_EQ(history.events.size(), 1U);
  EXPECT_EQ(history.events[0].kind, EventKind::stick);
  EXPECT_NEAR(history.events[0].time, speed / (friction * scene.gravity), 1e-14);
  EXPECT_EQ(motion_verdict(scene, history),
            "stands, at rest from 0.5097 s; nothing rocks; block 1 slips by up to 510 mm and is left 510 mm "
            "to the left");
}

TEST(ContactSummary, ReactionsOfASlidingBlockAreItsWeightAndFriction) {
  const Scene scene = sliding();
  const History history = sampled(scene);
  const double weight = scene.blocks[0].mass * scene.gravity;
  const Reaction& first = history.reactions.front();
  EXPECT_NEAR(first.normal, weight, 1e-12 * weight);
  EXPECT_NEAR(first.tangential, friction * weight, 1e-12 * weight);
  // Friction on the face below the centre of mass has the moment of its height.
  EXPECT_NEAR(first.centre, -friction * scene.blocks[0].half_height, 1e-13);
  EXPECT_EQ(history.reactions.back().tangential, 0);
}

TEST(ContactSummary, EnergyOfASlidingBlockIsWhatFrictionLeaves) {
  const Scene scene = sliding();
  const History history = sampled(scene);
  const std::vector<double> all = energies(scene, history);
  const double mass = scene.blocks[0].mass;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double rest = std::max(0.0, speed - friction * scene.gravity * history.times[i]);
    EXPECT_NEAR(all[i], 0.5 * mass * rest * rest, 1e-12 * energy_scale(scene));
  }
}

TEST(ContactSummary, HistoriesTellSlipsGapsAndPlaces) {
  const TemporaryFolder folder;
  const History history = sampled(sliding());
  const auto columns =
      read_columns(folder.write("history.csv", history_csv(history)), {"slip_1", "gap_1", "x_1", "y_1"});
  for (std::size_t i = 0; i < history.size(); ++i) {
    EXPECT_EQ(columns[0][i], columns[2][i]);
    EXPECT_EQ(columns[1][i], 0);
    EXPECT_EQ(columns[3][i], 0.5);
  }
}

/// A block on ground that falls away from under it at twice its weight's acceleration for 0.1 s.
TEST(ContactSummary, OfABlockThatTheGroundLeaves) {
  Scene scene = sliding();
  scene.initial.slip_velocities = {0};
  const double fall = 2 * scene.gravity;
  const double until = 0.1;
  scene.vertical.pulse = Pulse{PulseShape::rectangle, -fall, until, 0};
  const History history = sampled(scene);
  // The ground stops falling faster than the block at 0.1 s, and moves on at its speed: the gap g t²/2 grows
  // by the difference of speeds, against gravity, to its top where they are equal.
  const double gap = (fall - scene.gravity) * until * until / 2;
  const double apart = (fall - scene.gravity) * until;
  const double top = gap + apart * apart / (2 * scene.gravity);
  const auto summary = contact_summary(history);
  EXPECT_EQ(summary[0].lift_offs, 1);
  EXPECT_NEAR(summary[0].highest_lift, top, 1e-3 * top);  // among samples
  EXPECT_EQ(history.events.front().kind, EventKind::lift_off);
  EXPECT_EQ(name(history.events.front().to), "-");
  EXPECT_EQ(motion_verdict(scene, history),
            "stands, at rest from 0.3414 s; nothing rocks; block 1 lifts by up to 98.1 mm");
  EXPECT_TRUE(validity_warnings(scene, history).empty());
}

// What has no event need not rest, and what has not toppled need not stand.
TEST(ContactSummary, SaysWhatStillGoesOnAtTheEnd) {
  Scene scene = sliding();
  scene.initial = {{0}, {0}};
  scene.initial.gaps = {6};
  EXPECT_EQ(motion_verdict(scene, sampled(scene)), "block 1 is in flight at the end, 1 s; nothing rocks");
  scene.initial = {{0}, {0}};
  scene.inclination = 0.5;  // steeper than its friction
  EXPECT_EQ(motion_verdict(scene, sampled(scene))
                .find("block 1 slides at the end, 1 s; nothing rocks; block 1 slips"),
            0U);
  scene = sliding();
  scene.blocks = {make_block(0.4, 1.6, 2500)};
  scene.friction = {5};
  scene.initial = {{0.26}, {0}};  // its slenderness angle is 0.245
  EXPECT_EQ(motion_verdict(scene, sampled(scene)).find("block 1 leans past balance and on at the end, 1 s"),
            0U);
}

TEST(ContactSummary, OfABlockThatSwingsOnBothSpringsDoesNotCallItRest) {
  Scene scene;
  scene.law = Law::compliant;
  scene.duration = 0.25;
  scene.blocks = {make_block(1, 1, 2500)};
  scene.springs.stiffness = {1e7};
  scene.initial = {{0.01}, {0}};
  const History history = sampled(scene);
  ASSERT_FALSE(history.events.empty());
  ASSERT_EQ(name(history.events.back().to), name(closed_pattern(1)));
  EXPECT_EQ(motion_verdict(scene, history).rfind("stands; block 1 peaks", 0), 0U)
      << motion_verdict(scene, history);
}

TEST(ContactSummary, IsEmptyUnderLawsOfPivots) {
  Scene scene = sliding();
  scene.law = Law::consistent;
  scene.initial.slip_velocities = {};
  EXPECT_TRUE(contact_summary(sampled(scene)).empty());
}

Scene block_at_rest(double horizontal, double vertical) {
  Scene scene;
  scene.duration = 1;
  scene.blocks = {make_block(1.0, 2.0, 2500)};
  scene.initial = {{0}, {0}};
  scene.horizontal = {1.0, {0, horizontal}};
  scene.vertical = {1.0, {0, vertical}};
  return scene;
}

History solved(const Scene& scene) {
  return solve(scene, {.validity = true});
}

TEST(Validity, ABlockCarriedAlongNeedsFrictionOfItsAccelerationOverItsWeight) {
  // Demands are taken at the starts of steps; at rest the step is the piece between samples, so the last is
  // at 1 s.
  Scene scene = block_at_rest(3.0, -2.0);
  scene.duration = 2;
  scene.horizontal.samples.push_back(3.0);
  scene.vertical.samples.push_back(-2.0);
  const History history = solved(scene);
  ASSERT_TRUE(history.events.empty());  // b/h = 0.5 is more than 3/(9.81 − 2)
  EXPECT_NEAR(history.forces[0].friction, 3.0 / (9.81 - 2.0), 1e-14);
  EXPECT_EQ(history.forces[0].friction_time, 1.0);
  EXPECT_NEAR(history.forces[0].least_normal, scene.blocks[0].mass * (9.81 - 2.0), 1e-9);
}

TEST(Validity, FrictionThatAnImpactOfOneBlockNeeds) {
  Scene scene;
  scene.duration = 3;
  scene.blocks = {make_block(0.5, 2.0, 2500)};
  scene.initial = {{0.1}, {0}};
  // With velocity ratio η = 1 − 1.5 sin²α, the centre's change of velocity is h (1 − η) along the ground and
  // b (1 + η) upwards, per unit of angular velocity before.
  const double sine = 0.5 / std::hypot(0.5, 2.0);
  const double cosine = 2.0 / std::hypot(0.5, 2.0);
  const double expected = 1.5 * sine * cosine / (2 - 1.5 * sine * sine);
  EXPECT_NEAR(solved(scene).impulses[0].friction, expected, 1e-11);
}

TEST(Validity, NothingIsKeptUnlessAskedFor) {
  EXPECT_TRUE(solve(block_at_rest(1, 0)).forces.empty());
}

TEST(Validity, WarnsOfTooLittleFrictionAndOfLiftingOff) {
  Scene slippery = block_at_rest(3.0, 0);
  slippery.duration = 2;
  slippery.horizontal.samples.push_back(3.0);
  slippery.friction.assign(slippery.blocks.size(), 0.25);
  const auto slip = validity_warnings(slippery, solved(slippery));
  ASSERT_EQ(slip.size(), 1u);
  EXPECT_EQ(slip[0],
            "interface 1 needs friction 0.3058 for the force at t = 1 s, the scene has 0.25: blocks would "
            "slip, first "
            "at t = 0.8175 s");
  slippery.friction.assign(slippery.blocks.size(), 0.31);
  EXPECT_TRUE(validity_warnings(slippery, solved(slippery)).empty());

  // A ground that falls faster than the block: the model turns it about a corner, a real block would fly.
  Scene falling = block_at_rest(0.5, -12.0);
  falling.duration = 1.1;
  falling.horizontal.samples.push_back(0.5);
  falling.vertical.samples.push_back(-12.0);
  const auto lift = validity_warnings(falling, solved(falling));
  ASSERT_FALSE(lift.empty());
  EXPECT_NE(lift[0].find("interface 1 would have to pull, normal force -"), std::string::npos) << lift[0];
}

TEST(Validity, InfiniteRatiosAreNullInJson) {
  History history;
  history.forces = {{-1.0, 0.5, std::numeric_limits<double>::infinity(), 0.5}};
  history.impulses.resize(1);
  const auto json = validity_json(history);
  EXPECT_TRUE(json[0]["forces"]["friction"].is_null());
  EXPECT_EQ(json[0]["forces"]["least_normal"], -1.0);
  EXPECT_TRUE(json[0]["impulses"]["least_normal"].is_null());
}

}  // namespace
}  // namespace rockstack
