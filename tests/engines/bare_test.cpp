// Adapters beside bare programs (bare/), which share no code with them: what each engine makes of a scene by
// its library's own calls is what the adapter says that it makes.
//
// Both are given the same numbers and make the same calls, so that the same bits come out, however the motion
// multiplies rounding. What differs is known. Angles are read from other elements of the rotation: by the
// rounding of those, at most two units in the last place of 1. In ODE each step's rotation is put back into
// the plane by other operations, and the motion may multiply that rounding: 1e-13 rad was measured, 1e-9 rad
// is allowed. With unitMass adapters divide masses by the stack's, which is a power of two here, so that
// nothing is rounded.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engines/worker/registry.hpp"
#include "tests/engines/bare.hpp"
#include "tests/native_engines.hpp"

namespace rockstack {
namespace {

constexpr double step = 1e-3;  // s

/// Blocks of one material that together have 4096 kg.
std::vector<Block> stack_of(const std::vector<std::pair<double, double>>& sizes) {
  constexpr double whole = 4096;
  double area = 0, left = whole;
  for (const auto& [width, height] : sizes) area += width * height;
  std::vector<Block> blocks;
  for (const auto& [width, height] : sizes) {
    Block block = make_block(width, height, whole / area);
    const double mass = blocks.size() + 1 == sizes.size() ? left : block.mass;
    block.inertia *= mass / block.mass;
    block.mass = mass;
    left -= mass;
    blocks.push_back(block);
  }
  return blocks;
}

/// Spanos et al. 2001's two blocks, a slender block, and one that a sine of the ground lifts.
std::vector<Scene> scenes() {
  std::vector<Scene> list(3);
  list[0].duration = 0.9;
  list[0].blocks = stack_of({{1.25, 1.25}, {1, 2.5}});
  list[0].initial = {{0.15, 0.15}, {0, 0}};
  list[1].duration = 1.2;
  list[1].blocks = stack_of({{0.5, 2.5}});
  list[1].initial = {{0.1}, {0}};
  list[2].duration = 0.9;
  list[2].blocks = stack_of({{0.4, 2}});
  list[2].initial = {{0}, {0}};
  list[2].horizontal.pulse = Pulse{PulseShape::sine, 5, 0.8, 0, 1, 0};
  return list;
}

struct Case {
  const WorkerEngine* engine;
  std::string name;
  Parameters parameters;
};

/// Settings that neither set has, each by itself.
std::vector<Parameters> more_settings(const WorkerEngine& engine) {
  if (engine.name == "dart") return {{{"ErrorReductionParameter", 0.2}, {"MaxErrorReductionVelocity", 1}}};
  if (engine.name == "siconos") return {{{"theta", 1}}, {{"gamma", 0}}};
  if (engine.name == "simbody")
    return {{{"integrator", 1}, {"transition_velocity", 0.1}, {"stiffness", 1e5}, {"dissipation", 1}}};
  if (engine.name == "ode") return {{{"contactStiffness", 1e8}, {"contactDamping", 1e5}}, {{"slip1", 1e-6}}};
  if (engine.name == "mujoco") {
    return {{{"cone", 0}},
            {{"gap", 1e-4}, {"margin", 2e-4}},
            {{"ground", 1}},
            {{"impratio", 10}},
            {{"integrator", 1}},
            {{"noslip_iterations", 5}, {"noslip_tolerance", 1e-9}},
            {{"refsafe", 0}, {"solref_dampratio", -3e3}, {"solref_timeconst", -1e6}},
            {{"solimp_midpoint", 0.3}, {"solimp_dwidth", 0.999}, {"solimp_power", 3}, {"solimp_width", 1e-4}},
            {{"iterations", 5}, {"warmstart", 0}}};
  }
  if (engine.name == "box2d")
    return {{{"positionIterations", 10}, {"lengthUnit", 0.5}},
            {{"warmStarting", 0}},
            {{"restitution", 0.2}, {"restitutionThreshold", 0}}};
  if (engine.name == "chipmunk")
    return {{{"collisionPersistence", 1}, {"collisionSlop", 1e-3}}, {{"elasticity", 0.2}}};
  if (engine.name.starts_with("bullet"))
    return {{{"ground", 1}},
            {{"shape", 1}},
            {{"splitImpulse", 0}, {"contactStiffness", 1e8}, {"contactDamping", 1e5}},
            {{"frictionAnchor", 1}, {"frictionERP", 0.5}}};
  return {};
}

std::vector<Case> cases(const std::string& asked) {
  std::vector<Case> list;
  for (const WorkerEngine& engine : engines_called(asked)) {
    const std::string solver = engine.full_name() + ":";
    list.push_back({&engine, solver + "default", engine.default_parameters()});
    list.push_back({&engine, solver + "tuned", engine.tuned_parameters()});
    for (const Parameters& more : more_settings(engine)) {
      Parameters parameters = engine.tuned_parameters();
      for (const auto& [name, value] : more) parameters[name] = value;
      list.push_back({&engine, solver + more.rbegin()->first, parameters});
    }
  }
  return list;
}

double tolerance(const WorkerEngine& engine) {
  if (engine.name == "ode") return 1e-9;
  return 2 * (engine.capabilities.single_precision ? std::numeric_limits<float>::epsilon()
                                                   : std::numeric_limits<double>::epsilon());
}

/// Each engine of this build with all that its cases are.
class Bare : public testing::TestWithParam<std::string> {};

TEST_P(Bare, ProgramGivesTheAdaptersHistory) {
  for (const Case& one : cases(GetParam())) {
    const WorkerEngine& engine = *one.engine;
    for (const Scene& scene : scenes()) {
      const History history = simulate(engine, scene, step, one.parameters).history;
      const std::vector<double> bare =
          bare_angles(engine.name, bare_question(engine, scene, step, one.parameters));
      ASSERT_GE(bare.size(), history.angles.size()) << one.name;
      for (std::size_t i = 0; i < history.angles.size(); ++i) {
        // An angle past a turn is printed without it.
        const double difference = std::remainder(bare[i] - history.angles[i], 2 * std::numbers::pi);
        ASSERT_NEAR(difference, 0, tolerance(engine))
            << one.name << ' ' << history.times[i / scene.blocks.size()] << " s";
      }
    }
  }
}

TEST_P(Bare, SettingsChangeTheMotion) {
  for (const Case& one : cases(GetParam())) {
    const Parameters tuned = one.engine->tuned_parameters();
    if (one.parameters == tuned) continue;
    bool changed = false;
    // The last, of one block, takes the least time.
    const std::vector<Scene> list = scenes();
    for (auto scene = list.rbegin(); !changed && scene != list.rend(); ++scene)
      changed = simulate(*one.engine, *scene, step, one.parameters).history.angles !=
                simulate(*one.engine, *scene, step, tuned).history.angles;
    EXPECT_TRUE(changed) << one.name;
  }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Bare);
INSTANTIATE_TEST_SUITE_P(Engines, Bare, testing::ValuesIn(names_in(ROCKSTACK_BUILT_ENGINES)),
                         engine_test_name);

}  // namespace
}  // namespace rockstack
