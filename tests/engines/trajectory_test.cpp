// What engines tell of their contacts obeys the laws of mechanics, and what is made of it those of the
// contact.

#include "engines/trajectory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engines/scene_setup.hpp"
#include "tests/engines/linked_engines.hpp"

namespace rockstack {
namespace {

Scene stack(int blocks, double duration) {
  Scene scene;
  scene.duration = duration;
  for (int k = 0; k < blocks; ++k) {
    scene.blocks.push_back(make_block(1, 1 + k, 2500));
    scene.initial.angles.push_back(0);
    scene.initial.velocities.push_back(0);
  }
  return scene;
}

struct Sum {
  double normal = 0;  ///< impulse over all steps, N·s
  double tilted = 0;  ///< how much the vertical one may differ from it, as faces tilt, N·s
};

/// What each of two interfaces bears over that many steps.
std::vector<Sum> impulses(Simulation& simulation, int steps) {
  std::vector<Sum> sums(2);
  double tilt = 0;
  for (int i = 0; i < steps; ++i) {
    simulation.step();
    tilt = std::max({tilt, std::abs(simulation.body(0).angle), std::abs(simulation.body(1).angle)});
    for (const ContactPoint& point : simulation.contacts()) {
      sums[point.interface].normal += point.normal;
      // N cos θ ± T sin θ is vertical.
      sums[point.interface].tilted += 0.5 * tilt * tilt * point.normal + tilt * point.tangential;
    }
  }
  return sums;
}

// An interface bears what stands on it: impulse = weight × time + gained momentum, in any motion.
TEST(Contacts, TheirImpulsesAreTheMomentumOfWhatTheyBear) {
  constexpr int steps = 200;
  constexpr double dt = 1e-3;
  for (const auto& engine : linked_engines()) {
    for (const Parameters& parameters : {engine->default_parameters(), engine->tuned_parameters()}) {
      const Scene scene = stack(2, 1);
      const auto simulation = start(*engine, scene, dt, parameters);
      ASSERT_TRUE(simulation->watch_contacts()) << engine->solver;
      EXPECT_TRUE(simulation->contacts().empty()) << "none before the first step";
      const auto sums = impulses(*simulation, steps);
      for (std::size_t k = 0; k < 2; ++k) {
        double expected = 0, weight = 0;
        for (std::size_t above = k; above < 2; ++above) {
          weight += scene.blocks[above].mass * scene.gravity;
          expected += scene.blocks[above].mass * simulation->body(above).velocity_y;
        }
        expected += weight * steps * dt;
        // What impulses do to velocities is rounded in each step.
        double share =
            engine->capabilities.single_precision ? steps * std::numeric_limits<float>::epsilon() : 1e-12;
        // Conjugate gradients stop where the cost, a square, falls by 1e-12.
        if (engine->solver == "cg") share = 1e-6;
        EXPECT_NEAR(sums[k].normal, expected, sums[k].tilted + share * expected)
            << engine->solver << " interface " << k;
      }
    }
  }
}

TEST(Contacts, AreNotToldUnlessWatched) {
  for (const auto& engine : linked_engines()) {
    if (engine->name != "ode") continue;
    const auto simulation = start(*engine, stack(1, 1), 1e-3, engine->tuned_parameters());
    simulation->step();
    EXPECT_TRUE(simulation->contacts().empty()) << engine->solver;
  }
}

TEST(Contacts, BulletTellsNoneWithoutAWarmStart) {
  for (const auto& engine : linked_engines()) {
    if (engine->name != "bullet") continue;
    Parameters parameters = engine->tuned_parameters();
    parameters["solverMode"] = 256;
    EXPECT_FALSE(start(*engine, stack(1, 1), 1e-3, parameters)->watch_contacts()) << engine->solver;
    EXPECT_FALSE(simulate(*engine, stack(1, 0.01), 1e-3, parameters, true).bodies->contacts);
  }
}

/// A set in which contacts are springs of erp/(dt·cfm) N/m; nothing where the solver knows none.
std::optional<Parameters> soft(const Engine& engine) {
  Parameters parameters = engine.default_parameters();
  if (engine.name == "ode") {
    parameters["cfm"] = 1e-4;
    return parameters;
  }
  if (engine.name != "bullet" || engine.solver != "sequential-impulse") return {};
  parameters["globalCfm"] = 1e-4;
  parameters["splitImpulse"] = 0;
  parameters["numIterations"] = 200;
  return parameters;
}

// n springs side by side hold W at a depth of W/(nk), with ½W²/(nk) in them.
TEST(Contacts, OfABlockAtRestOnSpringsHoldTheEnergyThatItsWeightPutsIn) {
  constexpr double dt = 1e-3;
  for (const auto& engine : linked_engines()) {
    const auto parameters = soft(*engine);
    if (!parameters) continue;
    const Scene scene = stack(1, 4);
    const auto simulation = start(*engine, scene, dt, *parameters);
    simulation->watch_contacts();
    for (int i = 0; i < 4000; ++i) simulation->step();
    const auto points = simulation->contacts();
    const double stiffness = static_cast<double>(points.size()) * 0.2 / (dt * 1e-4);
    const double weight = scene.blocks[0].mass * scene.gravity;
    ASSERT_EQ(points.size(), 4U) << engine->solver;
    // Swinging on them has died down by exp(−6.4/s · 4 s) by then.
    constexpr double left = 1e-6;
    for (const ContactPoint& point : points)
      EXPECT_NEAR(point.gap, -weight / stiffness, left * weight / stiffness);
    const BodyRecord record = simulate(*engine, scene, dt, *parameters, true).bodies.value();
    const double expected = 0.5 * weight * weight / stiffness;
    EXPECT_NEAR(elastic_energy(record).back(), expected, 2 * left * expected) << engine->solver;
    EXPECT_NEAR(record.penetration.back(), weight / stiffness, left * weight / stiffness) << engine->solver;
  }
}

// Given a stiffness of their own, four points hold W at a depth of W/(4k), and tell k; Bullet's solvers of
// complementarity problems take no point's cfm, and tell that they are rigid. Dantzig's gives four corners in
// a plane up, to sequential impulse.
TEST(Contacts, OfBulletAreAsStiffAsTheyTellWhereTheyAreGivenASpring) {
  constexpr double dt = 1e-3, stiffness = 1e7, damping = 2e5;
  for (const auto& engine : linked_engines()) {
    const std::string solver = engine->solver;
    if (engine->name != "bullet" || (solver != "sequential-impulse" && solver != "mlcp-pgs")) continue;
    Parameters parameters = engine->default_parameters();
    parameters["splitImpulse"] = 0;
    parameters["contactStiffness"] = stiffness;
    parameters["contactDamping"] = damping;
    const Scene scene = stack(1, 1);
    const auto simulation = start(*engine, scene, dt, parameters);
    simulation->watch_contacts();
    for (int i = 0; i < 2000; ++i) simulation->step();
    const auto points = simulation->contacts();
    ASSERT_EQ(points.size(), 4U) << solver;
    const double depth = scene.blocks[0].mass * scene.gravity / (4 * stiffness);
    constexpr double left = 1e-4;  // of the depth: settling takes c/k = 0.02 s, iterations leave more
    for (const ContactPoint& point : points) {
      const bool spring = solver == "sequential-impulse";
      EXPECT_NEAR(-point.gap, spring ? depth : 0, left * depth) << solver;
      EXPECT_EQ(std::isinf(point.stiffness), !spring) << solver;
      if (spring) {
        EXPECT_NEAR(point.stiffness / stiffness, 1, 1e-12);
        EXPECT_NEAR(point.damping / damping, 1, 1e-12);
      }
    }
  }
}

// A block that is pushed along by more than friction bears slides at the cone; where the limit is a force it
// does not, and the excess is what the cone does not bear.
TEST(Contacts, ShowFrictionAboveItsCone) {
  constexpr double push = 0.5, friction = 0.3;
  Scene scene = stack(1, 0.3);
  scene.blocks = {make_block(2, 1, 2500)};
  scene.friction.assign(scene.blocks.size(), friction);
  scene.horizontal.pulse = Pulse{PulseShape::rectangle, push * scene.gravity, 1, 0, 1, 0};
  for (const auto& engine : linked_engines()) {
    Parameters parameters = engine->tuned_parameters();
    if (engine->name == "ode") {
      parameters["contactApprox1"] = 0;
      const BodyRecord held = simulate(*engine, scene, 1e-3, parameters, true).bodies.value();
      EXPECT_GT(held.contacts->friction_excess, (push - friction) * (1 - 1e-3)) << engine->solver;
      EXPECT_LT(held.slip, 1e-4);
      parameters["contactApprox1"] = 1;
    }
    if (engine->solver == "step" || engine->solver.starts_with("mlcp")) continue;
    const BodyRecord slid = simulate(*engine, scene, 1e-3, parameters, true).bodies.value();
    EXPECT_LT(slid.contacts->friction_excess, 1e-3) << engine->solver;
    EXPECT_GT(slid.slip, 1e-3) << engine->solver;
  }
}

// ---- What is made of them, by points made by hand.

ContactPoint point(double along, double normal, double gap = 0) {
  ContactPoint made;
  made.along = along;
  made.normal = normal;
  made.gap_before = made.gap = gap;
  return made;
}

Setup rubbing(Scene scene, const std::vector<double>& friction, double dt) {
  scene.friction = friction;
  return set_up(scene, dt, {});
}

TEST(ContactWatch, SpringsThatOverlapHoldHalfOfStiffnessTimesDepthSquared) {
  const Scene scene = stack(1, 1);
  ContactWatch watch(rubbing(scene, {0.5}, 1e-3), 1000);
  const ContactRecord& record = watch.record();
  const std::vector<double> still{0};
  ContactPoint soft = point(-0.5, 1, -0.01), apart = point(0.5, 0, 0.01);
  soft.stiffness = apart.stiffness = 2e4;
  watch.observe({soft, soft, apart, point(0.5, 1, -0.01)}, still, still);
  EXPECT_DOUBLE_EQ(record.elastic.back(), 2 * 0.5 * 2e4 * 1e-4);
}

// Two springs that bear 3 and 1 N s give way by 3/6e4 + 1/2e4 together, as one of 4e4 N/m does under 4 N s.
TEST(ContactWatch, SpringsHaveOneStiffnessByWhichAllImpulsesOverlapAsMuch) {
  const Scene scene = stack(1, 1);
  ContactWatch watch(rubbing(scene, {0.5}, 1e-3), 1000);
  const ContactRecord& record = watch.record();
  const std::vector<double> still{0};
  watch.observe({}, still, still);
  EXPECT_TRUE(std::isinf(record.stiffness));
  ContactPoint stiff = point(-0.5, 3), soft = point(0.5, 1), apart = point(0.5, 0);
  stiff.stiffness = 6e4, stiff.damping = 10;
  soft.stiffness = 2e4, soft.damping = 50;
  watch.observe({stiff, apart}, still, still);
  watch.observe({soft}, still, still);
  EXPECT_DOUBLE_EQ(record.stiffness, 4e4);
  EXPECT_DOUBLE_EQ(record.damping, (3 * 10 + 1 * 50) / 4.0);
  watch.observe({point(0.5, 1)}, still, still);
  EXPECT_TRUE(std::isinf(record.stiffness));
}

// A solver that gives up may leave an impulse that pulls. No means count it, and no cone has room for its
// friction.
TEST(ContactWatch, PointsThatPullAreInNoMean) {
  ContactWatch watch(rubbing(stack(1, 1), {0.5}, 1e-3), 1000);
  const ContactRecord& record = watch.record();
  const std::vector<double> still{0};
  ContactPoint bears = point(-0.5, 2), pulls = point(0.5, -3, -0.01);
  bears.stiffness = pulls.stiffness = 4e4;
  bears.damping = pulls.damping = 10;
  pulls.tangential = 1;
  watch.observe({bears, pulls}, still, still);
  EXPECT_DOUBLE_EQ(record.stiffness, 4e4);
  EXPECT_DOUBLE_EQ(record.damping, 10);
  EXPECT_DOUBLE_EQ(record.friction_excess, 1.0 / 2);
  EXPECT_EQ(record.complementarity, 0);
}

TEST(ContactWatch, PointsAreCountedAtTheEndThatTheyBear) {
  ContactWatch watch(rubbing(stack(1, 1), {0.5}, 1e-3), 1000);
  const std::vector<double> still{0};
  watch.observe({}, still, still);
  EXPECT_EQ(watch.record().points, 1);
  watch.observe({point(-0.5, 3), point(-0.5, 1), point(0.5, 4), point(0.5, 0)}, still, still);
  EXPECT_DOUBLE_EQ(watch.record().points, (4 * 2 + 4 * 1) / 8.0);
}

// ODE's erp and cfm are the spring and dashpot that implicit Euler makes of them: of h, k and c again.
TEST(ContactWatch, ErpAndCfmAreTheSpringAndDashpotThatGiveThem) {
  constexpr double dt = 1e-3, stiffness = 3e5, damping = 700;
  const double erp = dt * stiffness / (dt * stiffness + damping), cfm = 1 / (dt * stiffness + damping);
  EXPECT_NEAR(contact_stiffness(erp, cfm, dt) / stiffness, 1, 1e-14);
  EXPECT_NEAR(contact_damping(erp, cfm) / damping, 1, 1e-14);
}

TEST(ContactWatch, ResidualsAreForcesAcrossAGapAndOutsideTheCone) {
  const Scene scene = stack(1, 1);
  ContactWatch watch(rubbing(scene, {0.5}, 1e-3), 1000);
  const ContactRecord& record = watch.record();
  const std::vector<double> still{0};
  watch.observe({}, still, still);
  EXPECT_EQ(record.complementarity, 0);
  EXPECT_EQ(record.friction_excess, 0);
  ContactPoint pushed = point(0.5, 2, 0.01), held = point(-0.5, 4);
  held.tangential = 3;
  watch.observe({pushed, held, point(0.5, 0, 1), point(0.5, 1, -1)}, still, still);
  EXPECT_DOUBLE_EQ(record.complementarity, 2 / 1e-3 * 0.01);
  EXPECT_DOUBLE_EQ(record.friction_excess, (3 - 0.5 * 4) / (2 + 4 + 1));
}

TEST(ContactWatch, EachInterfaceHasItsOwnCone) {
  const Scene scene = stack(2, 1);
  ContactWatch watch(rubbing(scene, {0.5, 0.25}, 1e-3), 1000);
  const ContactRecord& record = watch.record();
  const std::vector<double> still{0, 0};
  ContactPoint lower = point(0, 4), upper = point(0, 4);
  upper.interface = 1;
  lower.tangential = upper.tangential = 1.5;
  watch.observe({lower, upper}, still, still);
  EXPECT_DOUBLE_EQ(record.friction_excess, (1.5 - 0.25 * 4) / (4 + 4));
}

// Impulses of 3 N·s along the face and 4 N·s across it in a step of 1 ms, and of a point that pushes alone.
TEST(StepReactions, AreMeansOverTheStepInTheAxesOfTheFace) {
  Scene scene = stack(2, 1);
  const std::vector<double> angles{0.3, 0.1};
  for (const bool overhangs : {false, true}) {
    scene.blocks[1] = make_block(overhangs ? 1.5 : 0.5, 1, 2500);
    const double face = overhangs ? 0.1 : 0.3, c = std::cos(face), s = std::sin(face);
    ContactPoint rubs = point(0.25, 4), pushes = point(-0.25, 2);
    rubs.interface = pushes.interface = 1;
    rubs.impulse_x = 3 * c + 4 * s, rubs.impulse_y = 4 * c - 3 * s;
    pushes.impulse_x = 2 * s, pushes.impulse_y = 2 * c;
    const auto reactions = step_reactions(rubbing(scene, {1, 1}, 1e-3), {rubs, pushes}, angles);
    ASSERT_EQ(reactions.size(), 2U);
    EXPECT_EQ(reactions[0].normal, 0);
    EXPECT_TRUE(std::isnan(reactions[0].centre));
    EXPECT_NEAR(reactions[1].normal, 6e3, 1e-9);
    EXPECT_NEAR(reactions[1].tangential, 3e3, 1e-9);
    EXPECT_NEAR(reactions[1].centre, 0.25 * (4 - 2) / 6, 1e-15);
  }
}

/// A block 1 m wide that turns back from leaning to the right, at −1 rad/s in steps of 0.1 s.
struct Landing {
  void observe(double angle, const std::vector<ContactPoint>& points) {
    watch.observe(points, std::vector<double>{angle}, std::vector<double>{speed});
  }
  ContactWatch watch{rubbing(stack(1, 1), {1}, 0.1), 1000};
  double speed = -1;
};

TEST(ContactWatch, AnEndThatBeginsToBearWhileItsInterfaceClosesIsAnImpact) {
  Landing landing;
  landing.observe(0.15, {});
  landing.observe(0.05, {point(0.5, 1)});
  // The left end is 50 mm up and comes down at 1 m/s: it is met half way through the step.
  landing.observe(-0.05, {point(-0.5, 3, 0.05), point(0.5, 0)});
  landing.observe(-0.15, {point(-0.5, 1)});
  ASSERT_EQ(landing.watch.record().impacts.size(), 1U);
  EXPECT_DOUBLE_EQ(landing.watch.record().impacts[0].time, 0.15);
  EXPECT_EQ(landing.watch.record().impacts[0].interface, 1);
  EXPECT_EQ(landing.watch.record().impacts[0].speed, 1);
}

TEST(ContactWatch, OverlapThatIsAnsweredALateStepCountsFromWhereItBegan) {
  Landing landing;
  landing.observe(0.15, {});
  landing.observe(0.05, {point(0.5, 1)});
  landing.observe(-0.05, {point(0.5, 1)});
  landing.observe(-0.05, {point(-0.5, 3, -0.05)});
  ASSERT_EQ(landing.watch.record().impacts.size(), 1U);
  EXPECT_DOUBLE_EQ(landing.watch.record().impacts[0].time, 0.15);
}

// At a speed that closes the gap in a thousand steps, and across an overlap that only as many would have
// made.
TEST(ContactWatch, ImpactsAreWithinTheRunThatTellsThem) {
  for (const double gap : {0.1, -0.1}) {
    Landing landing;
    landing.speed = -1e-3;
    landing.observe(1e-4, {});
    landing.observe(1e-4, {point(0.5, 1)});
    landing.observe(0, {point(-0.5, 3, gap)});
    ASSERT_EQ(landing.watch.record().impacts.size(), 1U);
    EXPECT_EQ(landing.watch.record().impacts[0].time, gap > 0 ? 0.2 : 0);
  }
}

TEST(ContactWatch, APivotThatIsLostForAStepIsNone) {
  Landing landing;
  landing.observe(-0.15, {});
  landing.observe(-0.25, {point(-0.5, 1)});
  landing.observe(-0.35, {});
  landing.observe(-0.45, {point(-0.5, 1)});
  EXPECT_TRUE(landing.watch.record().impacts.empty());
}

}  // namespace
}  // namespace rockstack
