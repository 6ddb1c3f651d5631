// Which laws blocks slide by in engines, and slide and rock at once.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engines/findings/draws.hpp"
#include "tests/engines/linked_engines.hpp"

namespace rockstack {
namespace {

/// As rigid and as exactly solved as each solver can be.
Parameters rigid(const Engine& engine) {
  Parameters parameters = gentle(engine);
  Parameters changes{{"cfm", 1e-8}, {"numIterations", 300}, {"quickStepNumIterations", 300}};
  if (engine.name() == "ode") changes["unitMass"] = 1;
  if (engine.solver() == "nncg") changes["unitMass"] = 1e6;
  // Without softness its problem is singular, and Bullet takes sequential impulse in its place.
  if (engine.solver() == "mlcp-dantzig")
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

/// Of engines but Bullet's Lemke solver, whose friction is no coefficient.
std::vector<const Engine*> with_coefficients() {
  std::vector<const Engine*> list;
  for (const auto& engine : linked_engines()) {
    if (engine->solver() != "mlcp-lemke") list.push_back(engine.get());
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
          << engine->solver() << ", friction " << friction;
    }
  }
}

/// How a block with b = 1 m starts on ground that accelerates by g, in g/b and g.
struct Onset {
  double rocking = 0, slipping = 0;
};

/// Coulomb's law. It slips for μ below (4 + 3r + r²)/(1 + 3r + 4r²) (Shenton 1996).
Onset coulomb(double r, double friction) {
  if (friction * (1 + 3 * r + 4 * r * r) >= 4 + 3 * r + r * r) return {0.75 * (r - 1) / (1 + r * r), 0};
  const double rocking = 3 * (friction * r - 1) / (4 + r * r - 3 * friction * r);
  return {rocking, 1 - friction * (1 + rocking) - r * rocking};
}

/// Friction limited by μ times the normal force that there would be without friction: the weight m g on both
/// corners, m g (1 + r²)/(4 + r²) on one. Where that of one corner cannot tip the block, μr(1 + r²) < 4 + r²,
/// it goes to and fro between both and does not rock; friction is b/h of the weight then.
Onset limited_by_frictionless(double r, double friction) {
  const double limit = friction * (1 + r * r) / (4 + r * r);
  if (limit * r <= 1) return {0, 1 - 1 / r};
  const double sticking = 0.75 * (r - 1) / (1 + r * r);
  const double rocking = std::min(3 * (limit * r - 1) / (4 + r * r), sticking);
  return {rocking, std::max(1 - limit - r * rocking, 0.0)};
}

TEST(Sliding, BlocksRockAndSlideByCoulombsLawOrByNormalsFoundWithoutFriction) {
  const double duration = 0.03, dt = 2e-5;
  for (const Engine* engine : with_coefficients()) {
    const bool direct = engine->solver() == "step" || engine->solver() == "mlcp-dantzig";
    for (const double r : {1.5, 2.0, 3.0}) {
      for (const double above : {0.1, 0.2, 0.4, 0.7}) {
        Scene scene = block(r, 1 / r + above, duration);
        scene.horizontal.pulse = Pulse{PulseShape::rectangle, scene.gravity, 1, 0, 1, 0};
        const History history = simulate(*engine, scene, dt, rigid(*engine)).history;
        const double unit = 0.5 * scene.gravity * duration * duration;
        const Onset expected = (direct ? limited_by_frictionless : coulomb)(r, scene.friction[0]);
        EXPECT_NEAR(-history.angles.back() / unit, expected.rocking, 0.003)
            << engine->solver() << ", r = " << r << ", friction " << scene.friction[0];
        EXPECT_NEAR(-history.slips.back() / unit, expected.slipping, 0.01)
            << engine->solver() << ", r = " << r << ", friction " << scene.friction[0];
      }
    }
  }
}

}  // namespace
}  // namespace rockstack
