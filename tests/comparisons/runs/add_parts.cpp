#include "comparisons/runs/measure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/metrics/difference.hpp"
#include "engines/worker/registry.hpp"

namespace rockstack {
namespace {

constexpr double sample_interval = 1e-3;  ///< s

Scene let_go() {
  Scene scene;
  scene.duration = 0.8;
  scene.blocks = {make_block(0.5, 1, 2500)};
  scene.initial = {{0.1}, {0}};
  return scene;
}

CandidateMotion candidate_of(const History& history, const ContactRecord& contacts) {
  BodyRecord bodies;
  bodies.contacts = contacts;
  return {history, sample_interval, {}, false, bodies, {0.7}};
}

ContactRecord contacts_of(const CornerSpring& spring, double points) {
  ContactRecord contacts;
  contacts.stiffness = spring.stiffness / points;
  contacts.damping = spring.damping / points;
  contacts.points = points;
  return contacts;
}

// An engine without a step: the exact motion on springs, at each corner two points of half the stiffness.
TEST(AddParts, AnExactAnswerOnSpringsHasNoStep) {
  const Scene scene = let_go();
  const auto times = regular_times(sample_interval, scene.duration);
  const CornerSpring spring{2e6, 2e4};
  const History exact = solve(scene, {.sample_times = times});
  const History soft = solve(with_springs(scene, {0.7}, spring), {.sample_times = times});
  RunMetrics row;
  RunFiles files;
  add_parts(scene, exact, candidate_of(soft, contacts_of(spring, 2)), scene.duration, true, row, files);
  EXPECT_EQ(row.split_reason, "");
  EXPECT_EQ(row.spring_factor, 1);
  EXPECT_EQ(row.step_difference, 0);
  EXPECT_EQ(row.step_share, 0);
  EXPECT_GT(*row.softness_difference, 1e-3);
  EXPECT_NEAR(*row.model_share + *row.softness_share, 1, 1e-14);
  EXPECT_TRUE(files.at("parts.csv").starts_with("time,model_1,softness_1,step_1\n"));
}

// Shares add up to one and parts to the whole, whatever the answer.
TEST(AddParts, PartsAreTheWhole) {
  const Scene scene = let_go();
  const auto times = regular_times(sample_interval, scene.duration);
  const History exact = solve(scene, {.sample_times = times});
  History other = exact;
  for (std::size_t i = 0; i < other.angles.size(); ++i) other.angles[i] += 1e-3 * std::sin(20 * times[i]);
  RunMetrics row;
  RunFiles files;
  add_parts(scene, exact, candidate_of(other, contacts_of({1e6, 1e4}, 1)), scene.duration, false, row, files);
  EXPECT_NEAR(*row.model_share + *row.softness_share + *row.step_share, 1, 1e-12);
  EXPECT_TRUE(files.empty());

  const History rigid = solve(with_rigid_contacts(scene, {0.7}), {.sample_times = times});
  const History soft = solve(with_springs(scene, {0.7}, {1e6, 1e4}), {.sample_times = times});
  const Difference sum = whole_of(difference_parts(exact, rigid, soft, other));
  for (std::size_t i = 0; i < sum.values.size(); ++i)
    ASSERT_NEAR(sum.values[i], other.angles[i] - exact.angles[i], 1e-15) << "rounding of angles of 0.1 rad";
}

// A block that lands on its base, so that one corner at a time bears: a stiffer spring of the same damping
// ratio is less off, and rigid contacts have no softness.
TEST(AddParts, StiffContactsComeToRigidOnes) {
  const Scene scene = let_go();
  const auto times = regular_times(sample_interval, scene.duration);
  const History exact = solve(scene, {.sample_times = times});
  const auto softness = [&](const ContactRecord& contacts) {
    RunMetrics row;
    RunFiles files;
    add_parts(scene, exact, candidate_of(exact, contacts), scene.duration, false, row, files);
    EXPECT_EQ(row.split_reason, "");
    return *row.softness_difference;
  };
  const double soft = softness(contacts_of({1e7, 5e5}, 1)), stiff = softness(contacts_of({1e9, 5e6}, 1));
  EXPECT_LT(stiff, soft / 5);
  EXPECT_EQ(softness({}), 0);
}

TEST(AddParts, SpringsAreSoftenedToASteppableRate) {
  const Scene scene = let_go();
  EXPECT_EQ(spring_factor(scene, {1e6, 1e4}, 1e5), 1);
  const CornerSpring stiff{1e12, 1e10};
  const double factor = spring_factor(scene, stiff, 1e5);
  EXPECT_GT(factor, 1);
  EXPECT_NEAR(spring_factor(scene, {stiff.stiffness / factor, stiff.damping / factor}, 1e5), 1, 1e-12);
}

// Springs add some 1e-3 rad to the motion of a stack: linear in the factor, the rest is of second order.
TEST(AddParts, ExtrapolationComesNearerThanSofterSprings) {
  Scene scene = let_go();
  scene.blocks.push_back(make_block(0.4, 1, 2500));
  scene.initial = {{0.1, 0.1}, {0, 0}};
  const auto times = regular_times(sample_interval, scene.duration);
  const std::vector<double> friction{10, 10};
  const CornerSpring spring{1e8, 2e6};
  const History wanted = solve(with_springs(scene, friction, spring), {.sample_times = times});
  const double most = 100 * spring_factor(scene, spring, 100) / 4;  // a quarter of the steps
  const SoftMotion found = soft_motion(scene, friction, spring, times, most);
  ASSERT_GT(found.factor, 2);
  const CornerSpring softer{spring.stiffness / found.factor, spring.damping / found.factor};
  const History soft = solve(with_springs(scene, friction, softer), {.sample_times = times});
  EXPECT_LT(root_mean_square(difference(wanted, found.history)),
            root_mean_square(difference(wanted, soft)) / 2);
}

TEST(AddParts, AFailureIsTheRowsOwn) {
  const Scene scene = let_go();
  RunMetrics row;
  RunFiles files;
  const History none;
  CandidateMotion nobody = candidate_of(none, {});
  nobody.bodies->contacts.reset();
  add_parts(scene, none, nobody, scene.duration, true, row, files);
  EXPECT_EQ(row.split_reason, "the engine tells no contacts");
  EXPECT_FALSE(row.step_difference);
  nobody.bodies->contacts = contacts_of({-1, 0}, 1);
  add_parts(scene, none, nobody, scene.duration, true, row, files);
  EXPECT_NE(row.split_reason, "");
  EXPECT_FALSE(row.step_difference);
}

/// Restitution of a mass on a spring and a dashpot that only push, landing at unit speed, by small steps.
double stepped_restitution(double damping_ratio) {
  constexpr double dt = 1e-5;
  double depth = 0, speed = 1;
  do {
    const double halfway = speed - dt / 2 * (depth + 2 * damping_ratio * speed);
    const double middle = depth + dt / 2 * speed;
    if (middle + 2 * damping_ratio * halfway <= 0) break;
    speed -= dt * (middle + 2 * damping_ratio * halfway);
    depth += dt * halfway;
  } while (depth > 0);
  return -speed;
}

TEST(CornerSprings, RestitutionIsThatOfADampedSpringThatOnlyPushes) {
  for (const double ratio : {0.0, 0.1, 0.5, 0.9, 1.1, 2.0})
    EXPECT_NEAR(restitution_of(ratio), stepped_restitution(ratio), 2e-5) << ratio;
  EXPECT_NEAR(restitution_of(1), std::exp(-2.0), 1e-15);
  EXPECT_NEAR(damping_ratio({100, 20}, make_block(1, 1, 4)), std::sqrt(1.0 / 4 + 0.25 / (4.0 / 6)), 1e-14);
}

// ODE with erp and cfm made of one spring and dashpot at each step is the implicit Euler method for them.
// Without friction nothing else is in the contact, and the motion on springs is where smaller steps lead.
TEST(AddParts, OnFixedSpringsOdesStepIsOfOrderOne) {
  if (engines_called("ode").empty()) GTEST_SKIP() << "this build has no ODE";
  const WorkerEngine& ode = find_engine("ode:step");
  Scene scene = let_go();
  scene.duration = 0.4;
  scene.friction = {0};
  Parameters parameters = ode.default_parameters();
  parameters["contactStiffness"] = 1e5;
  parameters["contactDamping"] = 2e3;
  std::array<double, 3> errors{}, whole{};
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double dt = 1e-3 / std::pow(2, i);
    const EngineRun run = run_in_worker(ode, scene, dt, parameters, 0, {}, true).run;
    const History exact = solve(scene, {.sample_times = run.history.times});
    RunMetrics row;
    RunFiles files;
    add_parts(scene, exact, {run.history, dt, {}, false, run.bodies, {0}}, scene.duration, false, row, files);
    ASSERT_EQ(row.split_reason, "");
    EXPECT_NEAR(run.bodies->contacts->points, 2, 1e-12);
    errors.at(i) = *row.step_difference;
    whole.at(i) = root_mean_square(difference(exact, run.history));
  }
  for (std::size_t i = 1; i < errors.size(); ++i) {
    EXPECT_NEAR(errors.at(i - 1) / errors.at(i), 2, 0.3);
    EXPECT_LT(errors.at(i), whole.at(i) / 10) << "the rest is no matter of the step";
  }
}

}  // namespace
}  // namespace rockstack
