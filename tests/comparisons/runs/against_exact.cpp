#include "comparisons/runs/measure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

std::vector<double> shifted(std::vector<double> centres) {
  for (std::size_t i = 0; i < centres.size(); ++i) centres[i] += i % 2 == 0 ? 0.03 : -0.04;
  return centres;
}

// Let go past its balance at 0.245 rad a block topples in the end, but not within half a second; at 0.2 rad
// it comes back.
TEST(AgainstExact, WhatFallsAsTheSceneEndsHasNotStood) {
  Scene scene;
  scene.duration = 0.5;
  scene.blocks = {make_block(1, 4, 2500)};
  Suite suite;
  suite.wanted.histories = false;
  const auto verdict = [&](double angle, bool topples) {
    scene.initial = {{angle}, {0}};
    RunMetrics row;
    RunFiles files;
    const History engine = solve(scene, {.sample_times = regular_times(1e-3, 0.3)});
    compare_with_exact(scene, suite, {engine, 1e-3, {}, topples}, scene.duration, row, files);
    return row.toppling_verdict;
  };
  EXPECT_EQ(verdict(0.3, true), TopplingVerdict::unknown);
  EXPECT_EQ(verdict(0.2, true), TopplingVerdict::engine_alone);
  EXPECT_EQ(verdict(0.3, false), TopplingVerdict::neither);
}

// The exact motion topples. An engine that holds the block past its balance lets it stand; one in which it
// still turns as the scene ends has decided nothing.
TEST(AgainstExact, WhatStaysPastItsBalanceStands) {
  Scene scene;
  scene.duration = 3;
  scene.blocks = {make_block(1, 4, 2500)};
  scene.initial = {{0.3}, {0}};
  Suite suite;
  suite.wanted.histories = false;
  const auto verdict = [&](double velocity) {
    History engine;
    engine.blocks = 1;
    engine.times = regular_times(0.01, scene.duration);
    engine.angles.assign(engine.times.size(), 0.3);
    engine.velocities.assign(engine.times.size(), velocity);
    RunMetrics row;
    RunFiles files;
    compare_with_exact(scene, suite, {engine, 0.01, {}, false}, scene.duration, row, files);
    return row.toppling_verdict;
  };
  EXPECT_EQ(verdict(1e-3), TopplingVerdict::exact_alone) << "it creeps outward";
  EXPECT_EQ(verdict(0.5), TopplingVerdict::unknown);
}

// Impacts whose times are all shorter by a share have swings that are, whichever of them is missed.
TEST(AgainstExact, SwingsThatAreShorterByAShareAreToldByIt) {
  const Scene scene = free_rocking(2);
  const History exact = solve(scene, {.sample_times = regular_times(1e-3, scene.duration)});
  for (const std::size_t missed : {0U, 1U, 99U}) {
    auto impacts = reported_impacts(scene, exact, chatter_speed(scene));
    for (ImpactTime& impact : impacts) impact.time *= 1 - 2e-4;
    if (missed < impacts.size()) impacts.erase(impacts.begin() + static_cast<std::ptrdiff_t>(missed));
    Suite suite;
    suite.wanted.histories = false;
    RunMetrics row;
    RunFiles files;
    compare_with_exact(scene, suite, {exact, 1e-3, impacts, false}, scene.duration, row, files);
    ASSERT_TRUE(row.swing_time_error) << missed;
    EXPECT_NEAR(*row.swing_time_error, -2e-4, 1e-12) << missed;
  }
}

// Angles a tenth too large, impacts 2 ms late, the last one missed and one made up.
TEST(AgainstExact, EachDifferenceIsTheOneThatWasMade) {
  const Scene scene = free_rocking(2);
  const History exact = solve(scene, {.sample_times = regular_times(1e-3, scene.duration)});
  History other = exact;
  for (double& angle : other.angles) angle *= 1.1;
  for (double& velocity : other.velocities) velocity *= 1.1;
  auto impacts = reported_impacts(scene, exact, chatter_speed(scene));
  const auto count = static_cast<int>(impacts.size());
  ASSERT_GT(count, 3);
  for (ImpactTime& impact : impacts) impact.time += 2e-3;
  impacts.back().time += 2 * settling_duration(scene);
  // Contacts tell all but the last, on time.
  std::vector<ContactImpact> told;
  for (const ImpactTime& impact : reported_impacts(scene, exact, chatter_speed(scene)))
    told.push_back({impact.time, impact.interface, 1, static_cast<double>(sign(impact.side))});
  told.pop_back();
  const BodyRecord bodies{
      .energy = {0, 300, 100},
      .input = {0, 50, 50},
      .penetration = {0, 1, 0.5},
      .centres = shifted(centres_of(scene, exact)),
      .unsupported_since = std::vector<double>(scene.blocks.size(), std::numeric_limits<double>::infinity()),
      .contacts = ContactRecord{{0, 0, 100}, 6, 7, 3e5, 40, told},
      .gaps = {0, 2, 1},
      .slip = 3,
      .out_of_plane = 4,
      .out_of_plane_tilt = 5};
  Suite suite;
  suite.wanted.histories = false;
  suite.tolerance = 1e-3;
  RunMetrics row;
  RunFiles files;
  compare_with_exact(scene, suite, {other, 1e-3, impacts, false, bodies}, scene.duration, row, files);

  double largest = 0;
  double squares = 0;
  double normalized = 0;  // rotation, by Spanos et al. 2001's blocks of half sizes b and h
  double agrees = 0;
  std::size_t turned = 0;
  bool agreed = true;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    double worst = 0;
    for (const double angle : exact.angles_at(i)) {
      worst = std::max(worst, 0.1 * std::abs(angle));
      const Block& block = scene.blocks[turned++ % scene.blocks.size()];
      normalized = std::max(normalized, std::abs(angle) / std::atan(block.half_width / block.half_height));
      squares += 0.01 * angle * angle;
    }
    largest = std::max(largest, worst);
    agreed = agreed && worst <= suite.tolerance;
    if (agreed) agrees = exact.times[i];
  }
  const double rounding = 1e-13;
  EXPECT_NEAR(*row.largest_angle_difference, largest, rounding);
  EXPECT_NEAR(*row.rms_angle_difference, std::sqrt(squares / static_cast<double>(exact.angles.size())),
              rounding);
  EXPECT_NEAR(*row.relative_angle_difference, 0.1, rounding);
  // Every centre is 3 cm to the right and 4 cm down; the lower block is 1.25 m high.
  EXPECT_NEAR(*row.rms_position_difference, 0.05, rounding);
  EXPECT_NEAR(*row.largest_position_difference, 0.05, rounding);
  EXPECT_NEAR(*row.relative_position_difference, 0.04, rounding);
  EXPECT_EQ(row.position_agreement_time, 0) << "0.04 is more than the tolerance at once";
  EXPECT_NEAR(*row.error, std::max(0.04, *row.rms_angle_difference), rounding);
  EXPECT_EQ(row.sinking, 0.5) << "at the end";
  EXPECT_NEAR(*row.peak_angle / *row.exact_peak_angle, 1.1, rounding);
  EXPECT_NEAR(*row.exact_peak_over_slenderness, normalized, rounding);
  EXPECT_NEAR(*row.peak_over_slenderness, 1.1 * normalized, rounding);
  EXPECT_NEAR(*row.magnitude_error, 0.1, rounding);
  EXPECT_NEAR(*row.phase_error, 0, 1e-7) << "an arc cosine near one has half the digits";
  EXPECT_NEAR(*row.second_peak_difference, 0.1, rounding);
  EXPECT_NEAR(*row.agreement_time, agrees, 1.001e-3);
  EXPECT_NEAR(*row.first_impact_time_difference, 2e-3, rounding);
  EXPECT_EQ(row.impacts_matched, count - 1);
  EXPECT_EQ(row.impacts_missed, 1);
  EXPECT_EQ(row.impacts_extra, 1);
  EXPECT_NEAR(*row.rms_impact_time_difference, 2e-3, rounding);
  EXPECT_NEAR(*row.largest_impact_time_difference, 2e-3, rounding);
  EXPECT_NEAR(*row.swing_time_error, 0, 1e-12) << "all are late by as much";
  const Block& base = scene.blocks[0];
  const Block& top = scene.blocks[1];
  const double weight_height =
      scene.gravity * (base.mass * base.half_height + top.mass * (2 * base.half_height + top.half_height));
  EXPECT_NEAR(*row.energy_gain, 250 / weight_height, rounding);
  EXPECT_EQ(row.contact_impacts_matched, count - 1);
  EXPECT_EQ(row.contact_impacts_missed, 1);
  EXPECT_EQ(row.contact_impacts_extra, 0);
  EXPECT_EQ(row.impact_readings_differ, 1) << "the one that was moved";
  EXPECT_EQ(row.penetration, 1);
  EXPECT_EQ(row.gap, 2);
  EXPECT_EQ(row.slip, 3);
  EXPECT_EQ(row.out_of_plane, 4);
  EXPECT_EQ(row.out_of_plane_tilt, 5);
  EXPECT_NEAR(*row.complementarity_residual, 6 / weight_height, rounding);
  EXPECT_EQ(row.friction_cone_violation, 7);
  EXPECT_EQ(row.contact_stiffness, 3e5);
  EXPECT_EQ(row.contact_damping, 40);
}

/// The row of an answer whose angles are a tenth too large up to 1 s, and three times too large later on,
/// with impacts 2 ms late and none later on. The horizon lies in the midst of a flight.
RunMetrics row_up_to_one_second(double duration) {
  const Scene scene = free_rocking(duration);
  const History exact = solve(scene, {.sample_times = regular_times(1e-3, duration)});
  History other = exact;
  for (std::size_t i = 0; i < other.angles.size(); ++i) other.angles[i] *= other.times[i / 2] > 1 ? 3 : 1.1;
  std::vector<ImpactTime> impacts;
  for (ImpactTime impact : reported_impacts(scene, exact, chatter_speed(scene)))
    if ((impact.time += 2e-3) < 1) impacts.push_back(impact);
  Suite suite;
  suite.wanted.histories = false;
  suite.tolerance = 1;
  RunMetrics row;
  RunFiles files;
  compare_with_exact(scene, suite, {other, 1e-3, impacts, false, {}}, 1, row, files);
  return row;
}

// Seconds beyond the horizon say as little as if they had never been.
TEST(AgainstExact, WhatLiesBeyondTheHorizonSaysNothing) {
  const RunMetrics row = row_up_to_one_second(3), cut = row_up_to_one_second(1);
  EXPECT_EQ(row.horizon, 1);
  EXPECT_GT(*cut.impacts_matched, 2);
  EXPECT_EQ(cut.impacts_missed, 0);
  for (const auto field :
       {&RunMetrics::largest_angle_difference, &RunMetrics::rms_angle_difference,
        &RunMetrics::relative_angle_difference, &RunMetrics::magnitude_error, &RunMetrics::phase_error,
        &RunMetrics::agreement_time, &RunMetrics::second_peak_difference,
        &RunMetrics::rms_impact_time_difference, &RunMetrics::pattern_sequence_time}) {
    ASSERT_EQ((row.*field).has_value(), (cut.*field).has_value());
    if (row.*field) {
      EXPECT_NEAR(*(row.*field), *(cut.*field), 1e-15 * std::max(1.0, std::abs(*(cut.*field))));
    }
  }
  for (const auto field :
       {&RunMetrics::impacts_matched, &RunMetrics::impacts_missed, &RunMetrics::impacts_extra,
        &RunMetrics::impacts_missed_null, &RunMetrics::settlings_missed})
    EXPECT_EQ(row.*field, cut.*field);
}

// A smooth block that lands leaning and bounces from corner to corner turns through upright in flight, which
// is no impact.
TEST(AgainstExact, ImpactsOfABlockThatBouncesOnItsCornersAreReadFromItsPlaces) {
  Scene scene;
  scene.law = Law::unilateral;
  scene.duration = 1;
  scene.blocks = {make_block(1, 0.5, 2500)};
  scene.initial = {{1.0}, {0}};
  scene.initial.gaps = {0.5};
  scene.friction = {0};
  scene.point_restitution = 0.8;
  constexpr double interval = 1e-3;
  const History exact = solve(scene, {.sample_times = regular_times(interval, scene.duration)});
  const auto read = observed_impacts(scene, exact, chatter_speed(scene));
  Suite suite;
  RunMetrics row;
  RunFiles files;
  compare_with_exact(scene, suite, {exact, interval, read, false, {}}, scene.duration, row, files);
  EXPECT_GE(row.impacts_matched, 2);
  EXPECT_EQ(row.impacts_missed, 0);
  EXPECT_EQ(row.impacts_extra, 0);
  EXPECT_NEAR(*row.first_impact_time, std::sqrt(2 * 0.5 / scene.gravity), interval);
  EXPECT_LE(*row.largest_impact_time_difference, interval);
}

}  // namespace
}  // namespace rockstack
