// Adapters broken on purpose: the checks must see it, or they say nothing about the adapters that pass.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "engines/conformance/check.hpp"
#include "engines/conformance/known_limits.hpp"
#include "tests/engines/linked_engines.hpp"

namespace rockstack {
namespace {

/// What an adapter makes of a question that it gets wrong, and of an answer.
struct Mistake {
  const char* name;
  const char* seen_by;  ///< the check
  std::function<void(Setup&)> question = [](Setup&) {};
  std::function<void(Trajectory&)> answer = [](Trajectory&) {};
  Parameters settings = {};  ///< of these, those that the engine has
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.name;
}

/// As convex hulls in Bullet are by their collision margin, which comes on top of the given size.
void fat(Setup& setup) {
  for (Placement& block : setup.blocks) {
    block.width += 0.08;
    block.height += 0.08;
  }
}

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> list{
      {.name = "FrictionOfThreeTenths",
       .seen_by = "SlidingBlockStops",
       .question = [](Setup& setup) { setup.friction.assign(setup.friction.size(), 0.3); }},
      {.name = "OneCoefficientForAllInterfaces",
       .seen_by = "EachInterfaceHasItsFriction",
       .question =
           [](Setup& setup) { setup.friction.assign(setup.friction.size(), setup.friction.front()); }},
      {.name = "RestitutionOfOneFifth",
       .seen_by = "FlatLandingDoesNotBounce",
       .settings = {{"restitution", 0.2},
                    {"restitutionVelocityThreshold", 0},
                    {"restitutionThreshold", 0},
                    {"bounce", 0.2},
                    {"elasticity", 0.2},
                    {"en", 0.2},
                    // A velocity of about 1 m/s is lost by a third then.
                    {"dissipation", 1},
                    // DART takes the product of both shapes' coefficients.
                    {"RestitutionCoeff", std::sqrt(0.2)}}},
      {.name = "MarginOfFourCentimetres", .seen_by = "QuarterPeriodIsHousners", .question = fat},
      {.name = "MassWrongByOnePercent",
       .seen_by = "PairKeepsItsMomentum",
       .question =
           [](Setup& setup) {
             setup.blocks.back().mass *= 1.01;
             setup.blocks.back().inertia *= 1.01;
           }},
      {.name = "InertiaOfOneBlockWrongByATenth",
       .seen_by = "QuarterPeriodIsHousners",
       .question = [](Setup& setup) { setup.blocks.back().inertia *= 1.1; }},
      {.name = "GravityWrongByOnePercent",
       .seen_by = "QuarterPeriodIsHousners",
       .question = [](Setup& setup) { setup.gravity.y *= 1.01; }},
      {.name = "GroundMotionAStepLate",
       .seen_by = "FreeFallIsTheSchemes",
       .question =
           [](Setup& setup) {
             setup.accelerations.insert(setup.accelerations.begin(), setup.gravity);
             setup.accelerations.pop_back();
           }},
      {.name = "GroundMotionThePositiveWay",
       .seen_by = "StrongPushRocks",
       .question =
           [](Setup& setup) {
             for (BodyAcceleration& pull : setup.accelerations) pull.x *= -1;
           }},
      {.name = "AnglesCounterClockwise",
       .seen_by = "StrongPushRocks",
       .answer =
           [](Trajectory& trajectory) {
             for (double& angle : trajectory.angles) angle *= -1;
           }},
  };
  return list;
}

/// A run that ends with an error is seen as well.
Judgement judge(const Check& check, const Adapter& adapter) {
  try {
    return check.judge(adapter);
  } catch (const std::exception& error) {
    return {HUGE_VAL, 0, "the run fails"};
  }
}

Adapter mistaken(const Engine& engine, const Mistake& mistake) {
  Adapter adapter = adapter_of(engine, engine.tuned_parameters());
  adapter.run = [&](Setup setup, Parameters parameters) {
    mistake.question(setup);
    for (const auto& [name, value] : mistake.settings) {
      if (parameters.count(name) != 0) parameters[name] = value;
    }
    Trajectory trajectory = run(engine, setup, parameters, true);
    mistake.answer(trajectory);
    return trajectory;
  };
  return adapter;
}

class Mutants : public testing::TestWithParam<std::tuple<const Engine*, Mistake>> {};

TEST_P(Mutants, AreSeen) {
  const auto& [engine, mistake] = GetParam();
  const std::string limit = known_limit(engine->name(), engine->solver(), "tuned", mistake.seen_by);
  if (!limit.empty()) GTEST_SKIP() << limit;
  const Parameters parameters = engine->tuned_parameters();
  const bool has_it = std::any_of(mistake.settings.begin(), mistake.settings.end(),
                                  [&](const auto& setting) { return parameters.count(setting.first) != 0; });
  if (!mistake.settings.empty() && !has_it) GTEST_SKIP() << "the engine has no such setting";
  const Check& check = find_check(mistake.seen_by);
  const Judgement before = check.judge(adapter_of(*engine, engine->tuned_parameters()));
  EXPECT_TRUE(before.holds()) << before.value << " against " << before.limit << ", " << before.what;
  const Judgement after = judge(check, mistaken(*engine, mistake));
  EXPECT_FALSE(after.holds()) << after.value << " against " << after.limit << ", " << after.what;
}

std::vector<const Engine*> all() {
  std::vector<const Engine*> list;
  for (const auto& engine : linked_engines()) list.push_back(engine.get());
  return list;
}

std::string name_of(const testing::TestParamInfo<std::tuple<const Engine*, Mistake>>& info) {
  const auto& [engine, mistake] = info.param;
  std::string name = engine->name() + "_" + engine->solver() + "_" + mistake.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Mutants);
INSTANTIATE_TEST_SUITE_P(Engines, Mutants,
                         testing::Combine(testing::ValuesIn(all()), testing::ValuesIn(mistakes())), name_of);

}  // namespace
}  // namespace rockstack
