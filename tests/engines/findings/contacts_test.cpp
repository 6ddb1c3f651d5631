// What contacts do in engines: springs, restitution, overlap at landing.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/metrics/difference.hpp"
#include "tests/engines/findings/draws.hpp"
#include "tests/engines/linked_engines.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

/// Stiffness (N/m) and damping (N s/m) of a contact point that ODE's erp and cfm stand for at a step.
Parameters spring(double erp, double cfm, double dt) {
  return {{"contactStiffness", erp / (dt * cfm)}, {"contactDamping", (1 - erp) / cfm}};
}

/// How far a block's corners are below ground, each with two contact points in depth: ½ k d² summed, J.
double elastic_energy(const Block& block, const BodyState& body, double stiffness) {
  double sum = 0;
  for (const double side : {-1, 1}) {
    const double height =
        body.y - side * block.half_width * std::sin(body.angle) - block.half_height * std::cos(body.angle);
    sum += stiffness * std::pow(std::max(0.0, -height), 2);
  }
  return sum;
}

struct SoftRun {
  std::vector<double> angles;  ///< every 50 ms, rad
  double gain = 0;             ///< of kinetic and potential energy, over that of rest
  double gain_with_springs = 0;
};

/// A slender block on contacts of stiffness k at each point, N/m.
SoftRun soft_run(const Engine& engine, const Draw& draw, const Parameters& parameters, double stiffness) {
  const Block& block = draw.scene.blocks[0];
  const auto simulation = start(engine, draw.scene, draw.dt, parameters);
  SoftRun run;
  std::vector<double> energy, with_springs;
  double angle = draw.scene.initial.angles[0];
  double next = 0.05;
  for (double t = draw.dt; t < draw.scene.duration; t += draw.dt) {
    const double last = angle;
    simulation->step();
    const BodyState body = simulation->body(0);
    angle = body.angle;
    if (t >= next) {
      run.angles.push_back(std::lerp(angle, last, (t - next) / draw.dt));
      next += 0.05;
    }
    const double speed_squared = std::pow(body.velocity_x, 2) + std::pow(body.velocity_y, 2);
    energy.push_back(0.5 * (block.mass * speed_squared + block.inertia * std::pow(body.angular_velocity, 2)) +
                     block.mass * draw.scene.gravity * (body.y - block.half_height));
    with_springs.push_back(energy.back() + elastic_energy(block, body, stiffness));
  }
  run.gain = largest_gain(energy) / energy_scale(draw.scene);
  run.gain_with_springs = largest_gain(with_springs) / energy_scale(draw.scene);
  return run;
}

std::vector<SoftRun> soft_runs(const Engine& engine, double dt, double erp, double cfm, bool fixed_spring) {
  std::vector<SoftRun> runs;
  for (const Draw& draw : replicates(slender_block(1.5), dt)) {
    const Parameters as_spring = spring(erp, cfm, fixed_spring ? 1e-3 : draw.dt);
    const Parameters changes = fixed_spring ? as_spring : Parameters{{"erp", erp}, {"cfm", cfm}};
    runs.push_back(soft_run(engine, draw, with(gentle(engine), changes), as_spring.at("contactStiffness")));
  }
  return runs;
}

/// Largest differences of angles between draws at one step and at another, the median.
double between(const std::vector<SoftRun>& coarse, const std::vector<SoftRun>& fine) {
  std::vector<double> list;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    double largest = 0;
    for (std::size_t k = 0; k < std::min(coarse[i].angles.size(), fine[i].angles.size()); ++k)
      largest = std::max(largest, std::abs(coarse[i].angles[k] - fine[i].angles[k]));
    list.push_back(largest);
  }
  return quartiles(list).median;
}

TEST(Contacts, OdesMotionConvergesOnFixedSpringsAndNotOnFixedErpAndCfm) {
  const Engine* engine = linked("ode:step");
  if (engine == nullptr) GTEST_SKIP() << "built without ODE";
  const auto runs = [&](double dt, bool fixed) { return soft_runs(*engine, dt, 0.2, 1e-4, fixed); };
  const auto spring_coarse = runs(1e-3, true), spring_middle = runs(2.5e-4, true),
             spring_fine = runs(6.25e-5, true);
  // First order: a quarter of the step, a quarter of what is left; half of the first gap allows for its
  // spread.
  EXPECT_LT(between(spring_middle, spring_fine), 0.5 * between(spring_coarse, spring_middle));
  EXPECT_LT(between(spring_middle, spring_fine), 2e-3);
  const auto coarse = runs(1e-3, false), middle = runs(2.5e-4, false), fine = runs(6.25e-5, false);
  EXPECT_GT(between(middle, fine), between(coarse, middle));
}

TEST(Contacts, EnergyThatSoftContactGainsStoodInItsSprings) {
  const Engine* engine = linked("ode:step");
  if (engine == nullptr) GTEST_SKIP() << "built without ODE";
  for (const double dt : {1e-3, 2.5e-4}) {
    for (const SoftRun& run : soft_runs(*engine, dt, 0.2, 1e-4, true)) {
      EXPECT_GT(run.gain, 5e-3);
      EXPECT_LT(run.gain_with_springs, 1e-3 * run.gain);
    }
  }
}

/// The median over draws of the largest angle between a run with a coefficient of restitution of one half and
/// one without, rad.
double effect_of_restitution(const Engine& engine, const Scene& scene) {
  const bool ode = engine.name == "ode";
  Parameters without = gentle(engine);
  if (!ode) without["restitutionVelocityThreshold"] = 0;
  const Parameters half = with(without, {{ode ? "bounce" : "restitution", 0.5}});
  std::vector<double> list;
  for (const Draw& draw : replicates(scene, 1e-3)) {
    list.push_back(largest(difference(simulate(engine, draw.scene, draw.dt, without).history,
                                      simulate(engine, draw.scene, draw.dt, half).history)));
  }
  return quartiles(list).median;
}

TEST(Contacts, RestitutionActsOnASquatBlockAndOnStacksAndHardlyOnASlenderBlock) {
  Scene squat;
  squat.duration = 2;
  squat.blocks = {make_block(1.25, 1.25, 2500)};
  squat.initial = {{0.3}, {0}};
  for (const char* name : {"ode:step", "bullet:sequential-impulse"}) {
    const Engine* engine = linked(name);
    if (engine == nullptr) continue;
    EXPECT_LT(effect_of_restitution(*engine, slender_block(2)), 1e-3) << name;
    for (const auto& [width, height, angle] :
         {std::array{1.0, 2.0, 0.23}, {1.0, 3.0, 0.16}, {0.3, 3.0, 0.03}}) {
      Scene slender = slender_block(2);
      slender.blocks = {make_block(width, height, 2500)};
      slender.initial.angles = {angle};
      EXPECT_LT(effect_of_restitution(*engine, slender), 0.01) << name << ' ' << width << ' ' << height;
    }
    EXPECT_GT(effect_of_restitution(*engine, squat), 0.02) << name;
    EXPECT_GT(effect_of_restitution(*engine, free_rocking(2)), 0.04) << name;
  }
}

/// A block that the falling ground leaves behind, and its flat landing.
struct Landing {
  double down = 0, up = 0;  ///< speeds before and after, m/s
  double overlap = 0;       ///< where the contacts of the landing were found, m
};

Landing land(const Engine& engine, const Parameters& parameters, double fall, double dt) {
  Scene scene;
  scene.duration = 1.2;
  scene.blocks = {make_block(1, 0.5, 2500)};
  scene.initial = {{0}, {0}};
  scene.vertical.interval = 0.1;
  scene.vertical.samples = {-scene.gravity - fall, -scene.gravity - fall, 0};
  const auto simulation = start(engine, scene, dt, parameters);
  Landing landing;
  for (double t = dt; t < scene.duration; t += dt) {
    const BodyState before = simulation->body(0);
    simulation->step();
    const double after = simulation->body(0).velocity_y;
    if (landing.down == 0 && before.velocity_y < -0.5 && after > -0.2)
      landing = {-before.velocity_y, after, scene.blocks[0].half_height - before.y};
    if (landing.down != 0) landing.up = std::max(landing.up, after);
  }
  return landing;
}

/// Overlap over the step, times erp, is the speed that pushes it out, and nothing takes that back.
TEST(Contacts, LandingBouncesByErpTimesOverlapOverStep) {
  for (const char* name :
       {"ode:step", "ode:quickstep", "bullet:sequential-impulse", "bullet:nncg", "bullet:mlcp-pgs"}) {
    const Engine* engine = linked(name);
    if (engine == nullptr) continue;
    const std::string key = engine->name == "ode" ? "erp" : "erp2";
    for (const double erp : {0.1, 0.2, 0.4}) {
      std::vector<double> bounces;
      for (int run = 0; run < 21; ++run) {
        const double dt = 1e-3 * (1 + 0.003 * (run - 10));
        const Landing landing =
            land(*engine, with(engine->default_parameters(), {{key, erp}}), 8 + 0.7 * run, dt);
        ASSERT_GT(landing.down, 0.5) << name;
        // Gravity's share of a step is what the contact may be off by.
        EXPECT_NEAR(landing.up, erp * landing.overlap / dt, 0.01) << name;
        bounces.push_back(landing.up / landing.down);
      }
      // Overlaps at landing lie anywhere between none and what a step's fall leaves.
      EXPECT_LT(*std::min_element(bounces.begin(), bounces.end()), 0.15 * erp) << name;
      EXPECT_GT(*std::max_element(bounces.begin(), bounces.end()), 0.85 * erp) << name;
      EXPECT_LE(*std::max_element(bounces.begin(), bounces.end()), erp) << name;
    }
    EXPECT_LT(land(*engine, with(engine->default_parameters(), {{key, 0}}), 10, 1e-3).up, 1e-5) << name;
  }
}

}  // namespace
}  // namespace rockstack
