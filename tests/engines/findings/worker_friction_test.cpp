// Which laws friction follows in the engines that are asked as workers, as friction_test has it of Bullet and
// ODE.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "comparisons/measures/statistics/fits.hpp"
#include "engines/worker/registry.hpp"
#include "tests/engines/findings/draws.hpp"
#include "tests/engines/findings/impact_laws.hpp"
#include "tests/native_engines.hpp"

namespace rockstack {
namespace {

/// A solver as rigid and as exactly solved as it can be.
struct Solver {
  std::string name;
  ImpactLaw law;
  Parameters changes;  ///< of its defaults
  double dt;           ///< s
  int steps;           ///< in which an impact is over
};

/// MuJoCo's rows lose their velocity within 0.1 ms, and what they have sunk by next to never: b = 2/(d τ), k
/// = 1/(d τ ζ)².
Parameters damped() {
  return {{"solref_timeconst", 1e-4}, {"solref_dampratio", 200}, {"solimp_d0", 0.9999},
          {"solimp_dwidth", 0.9999},  {"tolerance", 1e-12},      {"unitMass", 1}};
}

std::vector<Solver> solvers() {
  const Parameters siconos{{"SICONOS_DPARAM_TOL", 1e-8}, {"unitMass", 1}};
  const Parameters box2d{{"polygonRadius", 0}, {"velocityIterations", 100}};
  const Parameters dantzig{{"collisionDetector", 1}, {"ErrorReductionParameter", 0}};
  const Parameters pgs{{"collisionDetector", 1},
                       {"ErrorReductionParameter", 0},
                       {"MaxIteration", 1000},
                       {"RelativeDeltaXTolerance", 1e-6}};
  const Parameters simbody{
      {"unitMass", 1}, {"dissipation", 5e4}, {"transition_velocity", 1e-4}, {"accuracy", 1e-7}};
  return {{"siconos:nsgs", left_by_coulomb, siconos, 1e-5, 60},
          {"chipmunk:sequential-impulse", left_by_coulomb, {{"iterations", 1000}}, 1e-5, 60},
          {"box2d:sequential-impulse", left_by_coulomb, box2d, 1e-4, 60},
          {"dart:pgs", left_by_coulomb, pgs, 1e-5, 60},
          {"dart:dantzig", left_by_frictionless, dantzig, 1e-5, 60},
          {"simbody:compliant", left_by_coulomb, simbody, 1e-3, 40},
          {"mujoco:newton", left_by_convex_cone, damped(), 1e-5, 300},
          {"mujoco:cg", left_by_convex_cone, damped(), 1e-5, 300}};
}

/// Null where this build leaves it out.
const WorkerEngine* built(const std::string& name) {
  for (const WorkerEngine& engine : native_engines()) {
    if (engine.full_name() == name) return &engine;
  }
  return nullptr;
}

/// The angular velocity that one impact leaves of 1 rad/s, where the block also slides at `slip`, m/s.
double impact(const WorkerEngine& engine, const Solver& solver, double r, double friction, double dt,
              double slip = 0) {
  Scene scene;
  scene.duration = solver.steps * dt;
  scene.gravity = 1e-9;
  scene.blocks = {make_block(1, r, 1000)};
  scene.initial = {{1e-9}, {-1}, {slip}};
  scene.friction.assign(scene.blocks.size(), friction);
  const Parameters parameters = with(engine.default_parameters(), solver.changes);
  return -simulate(engine, scene, dt, parameters).history.velocities.back();
}

TEST(WorkerFriction, OneImpactIsCoulombsOrOfNormalsWithoutFrictionOrOfAConvexCone) {
  for (const Solver& solver : solvers()) {
    const WorkerEngine* engine = built(solver.name);
    if (engine == nullptr) continue;
    for (const double r : {1.5, 2.0, 5.0}) {
      for (const double friction : {0.05, 0.15, 0.3, 0.4, 0.6}) {
        // A step turns the block by up to 1e-4 rad, which moves corners and normals by some of that.
        EXPECT_NEAR(impact(*engine, solver, r, friction, solver.dt), solver.law(r, friction), 2e-4)
            << solver.name << ", r = " << r << ", friction " << friction;
      }
    }
  }
}

/// With r = 2 and μ = 0.3, where the three laws leave 0.613, 0.531 and 0.595.
TEST(WorkerFriction, GapOfOneImpactToItsLawClosesInProportionToTheStep) {
  for (const Solver& solver : solvers()) {
    const WorkerEngine* engine = built(solver.name);
    // Box2D is there at any step, and springs are as they are.
    if (engine == nullptr || solver.steps != 60 || solver.dt > 1e-5) continue;
    std::vector<StepError> errors;
    for (const double step : {4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4}) {
      std::vector<double> list;
      for (const double factor : {0.97, 1.0, 1.03})
        list.push_back(std::abs(impact(*engine, solver, 2, 0.3, factor * step) - solver.law(2, 0.3)));
      errors.push_back({step, quartiles(list).median});
    }
    const StepFit fit = fit_steps(errors);
    EXPECT_TRUE(fit.holds()) << solver.name << ": " << fit.reason;
    EXPECT_LT(fit.order.low, 1.02) << solver.name;
    EXPECT_GT(fit.order.high, 0.98) << solver.name;
    EXPECT_LT(fit.model_error.high, 2e-4) << solver.name;
  }
}

/// A corner that slides inwards as it lands is driven outwards by the impact. Simbody's goes on for some
/// time, and its friction turns round within; an impulse has the direction of the end.
TEST(WorkerFriction, FrictionTurnsRoundWithinAnImpactOfSimbody) {
  for (const Solver& solver : solvers()) {
    const WorkerEngine* engine = built(solver.name);
    if (engine == nullptr || (solver.name != "simbody:compliant" && solver.name != "siconos:nsgs")) continue;
    for (const double slip : {0.05, 0.1, 0.2}) {
      const double of_the_end = left_by_coulomb(2, 0.2), within = left_by_routh(2, 0.2, 2 * slip);
      EXPECT_NEAR(impact(*engine, solver, 2, 0.2, solver.dt, slip),
                  solver.name == "siconos:nsgs" ? of_the_end : within, 2e-4)
          << solver.name << ", " << slip << " m/s";
    }
  }
}

/// How high a sliding block flies at first, m; by law `unilateral` it stays. It starts upwards at `up`, m/s.
double hop(const WorkerEngine& engine, double speed, double friction, double up) {
  Scene scene;
  scene.duration = 1.2 * up / scene.gravity;
  scene.law = Law::unilateral;
  scene.blocks = {make_block(4, 0.5, 1000)};
  scene.initial = {{0}, {0}, {speed}};
  scene.friction = {friction};
  const Parameters parameters = with(engine.default_parameters(), damped());
  const std::vector<double> gaps = simulate(engine, scene, 1e-3, parameters).history.gaps;
  return *std::max_element(gaps.begin(), gaps.end());
}

/// Its first impulse N takes μN off the speed v and gives N upwards, where N = μ(v − μN).
TEST(WorkerFriction, ASlidingBlockHopsOffAConvexCone) {
  for (const WorkerEngine& engine : native_engines()) {
    if (engine.name != "mujoco") continue;
    for (const double speed : {1.0, 2.0, 4.0}) {
      for (const double friction : {0.2, 0.4, 0.8}) {
        const double up = friction * speed / (1 + friction * friction);
        // It goes on by a step's way, as it starts within one.
        EXPECT_NEAR(hop(engine, speed, friction, up), up * up / (2 * 9.81), 2e-3 * up)
            << engine.solver << ", " << speed << " m/s, friction " << friction;
      }
    }
  }
}

}  // namespace
}  // namespace rockstack
