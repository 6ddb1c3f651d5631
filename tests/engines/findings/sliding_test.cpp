// Which laws blocks slide by in engines, and slide and rock at once.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "analytic/solve.hpp"
#include "comparisons/measures/statistics/fits.hpp"
#include "tests/engines/bare.hpp"
#include "tests/engines/findings/draws.hpp"
#include "tests/engines/linked_engines.hpp"

namespace rockstack {
namespace {

/// As rigid and as exactly solved as each solver can be.
Parameters rigid(const Engine& engine) {
  Parameters parameters = gentle(engine);
  Parameters changes{{"cfm", 1e-8}, {"numIterations", 300}, {"quickStepNumIterations", 300}};
  if (engine.name == "ode") changes["unitMass"] = 1;
  if (engine.solver == "nncg") changes["unitMass"] = 1e6;
  // Without softness its problem is singular, and Bullet takes sequential impulse in its place.
  if (engine.solver == "mlcp-dantzig")
    changes.merge(Parameters{{"splitImpulse", 0}, {"erp2", 0.005}, {"globalCfm", 1e-10}, {"unitMass", 1}});
  for (const auto& [name, value] : changes) {
    if (parameters.count(name) != 0) parameters[name] = value;
  }
  return parameters;
}

/// A block at rest, h/b = r, b = 1 m.
Scene block(double r, double friction, double duration) {
  Scene scene;
  scene.duration = duration;
  scene.law = Law::unilateral;
  scene.blocks = {make_block(2, 2 * r, 2500)};
  scene.initial = {{0}, {0}};
  scene.friction = {friction};
  return scene;
}

/// Engines of Bullet and ODE but Bullet's Lemke solver, whose friction is no coefficient.
std::vector<const Engine*> with_coefficients() {
  std::vector<const Engine*> list;
  for (const auto& engine : linked_engines()) {
    const bool meant = engine->name == "bullet" || engine->name == "ode";
    if (meant && engine->solver != "mlcp-lemke") list.push_back(engine);
  }
  return list;
}

/// The scheme takes μgh off the velocity v before each step's move: h[(K − 1)v − μgh(K − 1)K/2], K =
/// ⌈v/(μgh)⌉.
TEST(Sliding, StopsWhereSemiImplicitEulerDoes) {
  for (const Engine* engine : with_coefficients()) {
    for (int run = 0; run < 21; run += 2) {
      const double friction = 0.1 + 0.04 * run, dt = 1e-3 * (1 + 0.003 * (run - 10));
      Scene scene = block(0.5, friction, 0.6);
      scene.initial.slip_velocities = {0.5};
      const double loss = friction * scene.gravity * dt;
      const double steps = std::ceil(0.5 / loss);
      // What contacts give way by, and what 300 sweeps leave.
      EXPECT_NEAR(simulate(*engine, scene, dt, rigid(*engine)).history.slips.back(),
                  dt * ((steps - 1) * 0.5 - loss * (steps - 1) * steps / 2), 1e-8)
          << engine->solver << ", friction " << friction;
    }
  }
}

/// How a block with b = 1 m starts on ground that accelerates by g, in g/b and g.
struct Onset {
  double rocking = 0, slipping = 0;
};

/// Coulomb's law. It slips for μ below (4 + 3r + r²)/(1 + 3r + 4r²) (Shenton 1996).
Onset onset_by_coulomb(double r, double friction) {
  if (friction * (1 + 3 * r + 4 * r * r) >= 4 + 3 * r + r * r) return {0.75 * (r - 1) / (1 + r * r), 0};
  const double rocking = 3 * (friction * r - 1) / (4 + r * r - 3 * friction * r);
  return {rocking, 1 - friction * (1 + rocking) - r * rocking};
}

/// Friction limited by μ times the normal force that there would be without friction: the weight m g on both
/// corners, m g (1 + r²)/(4 + r²) on one. Where that of one corner cannot tip the block, μr(1 + r²) < 4 + r²,
/// it goes to and fro between both and does not rock; friction is b/h of the weight then.
Onset onset_by_frictionless(double r, double friction) {
  const double limit = friction * (1 + r * r) / (4 + r * r);
  if (limit * r <= 1) return {0, 1 - 1 / r};
  const double sticking = 0.75 * (r - 1) / (1 + r * r);
  const double rocking = std::min(3 * (limit * r - 1) / (4 + r * r), sticking);
  return {rocking, std::max(1 - limit - r * rocking, 0.0)};
}

TEST(Sliding, BlocksRockAndSlideByCoulombsLawOrByNormalsFoundWithoutFriction) {
  const double duration = 0.03, dt = 2e-5;
  for (const Engine* engine : with_coefficients()) {
    const bool direct = engine->solver == "step" || engine->solver == "mlcp-dantzig";
    for (const double r : {1.5, 2.0, 3.0}) {
      for (const double above : {0.1, 0.2, 0.4, 0.7}) {
        Scene scene = block(r, 1 / r + above, duration);
        scene.horizontal.pulse = Pulse{PulseShape::rectangle, scene.gravity, 1, 0, 1, 0};
        const History history = simulate(*engine, scene, dt, rigid(*engine)).history;
        const double unit = 0.5 * scene.gravity * duration * duration;
        const Onset expected = (direct ? onset_by_frictionless : onset_by_coulomb)(r, scene.friction[0]);
        EXPECT_NEAR(-history.angles.back() / unit, expected.rocking, 0.003)
            << engine->solver << ", r = " << r << ", friction " << scene.friction[0];
        EXPECT_NEAR(-history.slips.back() / unit, expected.slipping, 0.01)
            << engine->solver << ", r = " << r << ", friction " << scene.friction[0];
      }
    }
  }
}

/// As above with r = 2 and μ = 0.6, over 0.2 s: the angle's error at its end by law `unilateral`, medians
/// over draws.
struct ErrorsByStep {
  double exact = 0;  ///< the angle itself, rad
  std::vector<StepError> errors;
};

ErrorsByStep errors_by_step(const Engine& engine) {
  Scene scene = block(2, 0.6, 0.2);
  scene.horizontal.pulse = Pulse{PulseShape::rectangle, scene.gravity, 1, 0, 1, 0};
  ErrorsByStep result;
  for (const double step : {4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4}) {
    std::vector<double> list;
    for (const Draw& draw : replicates(scene, step, 7)) {
      const History history = simulate(engine, draw.scene, draw.dt, rigid(engine)).history;
      result.exact = solve(draw.scene, {.sample_times = {history.times.back()}}).angles.back();
      list.push_back(std::abs(history.angles.back() - result.exact));
    }
    result.errors.push_back({step, quartiles(list).median});
  }
  return result;
}

TEST(Sliding, GapsToCoulombsLawCloseInProportionToTheStepOrNotAtAll) {
  for (const Engine* engine : with_coefficients()) {
    const auto [exact, errors] = errors_by_step(*engine);
    if (engine->solver == "step" || engine->solver == "mlcp-dantzig") {
      // It does not rock.
      for (const StepError& at : errors) EXPECT_NEAR(at.error / std::abs(exact), 1, 0.05) << engine->solver;
      continue;
    }
    const StepFit fit = fit_steps(errors);
    EXPECT_TRUE(fit.holds()) << engine->solver << ": " << fit.reason;
    EXPECT_LT(fit.order.low, 1.02) << engine->solver;
    EXPECT_GT(fit.order.high, 0.98) << engine->solver;
    EXPECT_LT(fit.model_error.high, 1e-3 * std::abs(exact)) << engine->solver;
  }
}

/// Speed along the ground that a flat landing and the five steps after it take, over what Coulomb's law
/// gives: μ times the speed down and μg times their time.
double braking(const Engine& engine, const Parameters& parameters, double dt) {
  Scene scene = block(0.5, 0.4, 0.5);
  scene.horizontal.pulse = Pulse{PulseShape::rectangle, -5, 0.2, 0, 1, 0};
  scene.vertical.pulse = Pulse{PulseShape::rectangle, -11.81, 0.2, 0, 1, 0};
  const auto simulation = start(engine, scene, dt, parameters);
  BodyState before, after;
  for (int step = 0; step < 500 && (before.velocity_y > -0.5 || after.velocity_y < before.velocity_y);
       ++step) {
    before = after;
    simulation->step();
    after = simulation->body(0);
  }
  for (int step = 0; step < 5; ++step) simulation->step();
  const double taken = before.velocity_x - simulation->body(0).velocity_x;
  return taken / (scene.friction[0] * (-before.velocity_y + 6 * scene.gravity * dt));
}

/// Bullet passes over the friction of a point that nothing presses, and what a warm start gave it stays.
TEST(Sliding, AWarmStartBrakesABlockOnceMoreAfterItsLanding) {
  for (const Engine* engine : with_coefficients()) {
    const bool sequential = engine->solver == "sequential-impulse" || engine->solver == "nncg";
    for (const double warm : {0.85, 0.0}) {
      Parameters parameters = rigid(*engine);
      if (parameters.count("warmstartingFactor") != 0) parameters["warmstartingFactor"] = warm;
      std::vector<double> list;
      list.reserve(21);
      for (int run = 0; run < 21; ++run)
        list.push_back(braking(*engine, parameters, 1e-3 * (1 + 0.003 * (run - 10))));
      const Quartiles found = quartiles(list);
      if (sequential && warm > 0) {
        EXPECT_GT(found.lower, 1.15) << engine->solver;
      } else {
        // What pushes the overlap out, a hundredth of it a step, presses as well.
        EXPECT_NEAR(found.lower, 1, 0.01) << engine->solver << " " << warm;
        EXPECT_NEAR(found.upper, 1, 0.01) << engine->solver << " " << warm;
      }
    }
  }
}

/// A block that comes down flat at 1 m/s, and slides at 3 m/s.
Scene thrown(double width, double height, double friction) {
  Scene scene;
  scene.duration = 0.0202;
  scene.law = Law::unilateral;
  scene.blocks = {make_block(width, height, 2500)};
  scene.initial = {{0}, {0}, {3}};
  scene.initial.gaps = {0.0073};
  scene.initial.gap_velocities = {-1};
  scene.friction = {friction};
  return scene;
}

/// What the landing takes of the speed along the ground, in Bullet by a bare program, over what it takes
/// exactly; over two steps at the start and two at the end. 50 sweeps, overlaps are pushed out beside the
/// velocities.
double taken_in_bullet(const Scene& scene, const std::string& solver, double warm) {
  constexpr double dt = 1e-4;
  const int steps = static_cast<int>(scene.duration / dt);
  const Block& block = scene.blocks[0];
  std::string question = fmt::format(
      "solver {} gravity {} friction {} reach 50 dt {} steps {} set along 1 set numIterations 50 "
      "set splitImpulsePenetrationThreshold 0 set warmstartingFactor {}\n",
      solver, scene.gravity, scene.friction[0], dt, steps, warm);
  question += fmt::format("block {} {} 1 {} {} {} {} 0 {} 0\n", 2 * block.half_width, 2 * block.half_height,
                          block.mass, block.inertia, block.inertia, block.inertia,
                          block.half_height + scene.initial.gaps[0]);
  // The first step gives the block its speeds.
  question += fmt::format("shake {} {}\nshake 0 0\n", -scene.initial.slip_velocities[0] / dt,
                          -scene.initial.gap_velocities[0] / dt);
  const std::vector<double> places = bare_angles("bullet", question);
  const auto speed = [&](auto step) { return (places.at(step) - places.at(step - 1)) / dt; };
  const auto end = static_cast<std::size_t>(steps);
  const History exact = solve(scene, {.sample_times = {0, (steps - 0.5) * dt}});
  return (speed(2UL) - speed(end)) / (exact.centre_velocities.at(0) - exact.centre_velocities.at(2));
}

/// A squat block is braked in the step after its landing, by what a warm start gives points that nothing
/// presses then; a slender one, which tips as it lands, h μ > b, by what earlier sweeps gave the corner that
/// lifts. Bullet takes Coulomb's friction where such points let go of theirs.
TEST(Sliding, FrictionThatIsLeftOnPointsThatNothingPressesBrakesBlocksInBullet) {
  if (linked("bullet:sequential-impulse") == nullptr) GTEST_SKIP() << "Bullet is not there";
  struct Case {
    double width, height, friction;
    bool by_warm_start, by_sweeps;
  };
  for (const auto& [width, height, friction, by_warm_start, by_sweeps] : {Case{2, 1, 0.4, true, false},
                                                                          {2, 1, 0.25, false, false},
                                                                          {1, 1, 0.4, true, false},
                                                                          {4, 1, 0.4, false, false},
                                                                          {0.5, 1.5, 0.25, false, false},
                                                                          {0.5, 1.5, 0.4, true, true}}) {
    const Scene scene = thrown(width, height, friction);
    SCOPED_TRACE(fmt::format("{} m × {} m, friction {}", width, height, friction));
    const auto expect = [&](const char* solver, double warm, bool brakes) {
      const double taken = taken_in_bullet(scene, solver, warm);
      // A landing is a step late at most, in which friction takes μ g dt: a thousandth of what a landing
      // takes.
      if (brakes)
        EXPECT_GT(taken, 1.05) << solver << ' ' << warm;
      else
        EXPECT_NEAR(taken, 1, 0.01) << solver << ' ' << warm;
    };
    expect("sequential-impulse", 0.85, by_warm_start);
    expect("sequential-impulse", 0, by_sweeps);
    expect("sequential-impulse-lets-go", 0.85, false);
    expect("sequential-impulse-lets-go", 0, false);
  }
}

}  // namespace
}  // namespace rockstack
