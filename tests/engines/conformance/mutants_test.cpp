// Adapters broken on purpose: the checks must see it, or they say nothing about the adapters that pass.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/engines/conformance/check.hpp"
#include "tests/engines/conformance/known_limits.hpp"
#include "tests/engines/linked_engines.hpp"

namespace rockstack {
namespace {

using Mistake = std::function<void(Scene& scene, Parameters& parameters)>;

/// An engine whose adapter makes a mistake on the way.
class Mistaken : public Engine {
 public:
  Mistaken(const Engine& sound, Mistake mistake) : sound_(sound), mistake_(std::move(mistake)) {}
  std::string name() const override { return sound_.name(); }
  std::string solver() const override { return sound_.solver(); }
  std::string version() const override { return sound_.version(); }
  std::vector<Setting> settings() const override { return sound_.settings(); }
  std::unique_ptr<Simulation> start(const Scene& scene, double dt, const Parameters& given) const override {
    Scene wrong = scene;
    Parameters parameters = given;
    mistake_(wrong, parameters);
    return sound_.start(wrong, dt, parameters);
  }

 private:
  const Engine& sound_;
  Mistake mistake_;
};

void slippery(Scene& scene, Parameters&) {
  scene.engine.friction = 0.3;
}

/// As where all interfaces share one coefficient.
void alike(Scene& scene, Parameters&) {
  std::fill(scene.friction.begin(), scene.friction.end(), scene.friction.front());
}

void bouncy(Scene&, Parameters& parameters) {
  for (const char* name : {"restitution", "bounce"}) {
    if (parameters.count(name) != 0) parameters[name] = 0.2;
  }
  if (parameters.count("restitutionVelocityThreshold") != 0) parameters["restitutionVelocityThreshold"] = 0;
}

/// As convex hulls in Bullet are by their collision margin, which comes on top of the given size.
void fat(Scene& scene, Parameters&) {
  for (Block& block : scene.blocks) {
    block.half_width += 0.04;
    block.half_height += 0.04;
  }
}

void heavy(Scene& scene, Parameters&) {
  scene.blocks.back().mass *= 1.01;
  scene.blocks.back().inertia *= 1.01;
}

class Mutants : public testing::TestWithParam<const Engine*> {
 protected:
  void expect_caught(const Mistake& mistake, const std::string& by) const {
    const Engine& sound = *GetParam();
    const std::string limit = known_limit(sound, "tuned", by);
    if (!limit.empty()) GTEST_SKIP() << limit;
    const Check& check = find_check(by);
    const Verdict before = check.judge({&sound, sound.tuned_parameters()});
    EXPECT_TRUE(before.holds()) << before.value << " against " << before.limit << ", " << before.what;
    const Mistaken broken(sound, mistake);
    const Verdict after = check.judge({&broken, sound.tuned_parameters()});
    EXPECT_FALSE(after.holds()) << after.value << " against " << after.limit << ", " << after.what;
  }
};

TEST_P(Mutants, FrictionOfThreeTenthsIsSeenInAPushedBlock) {
  if (GetParam()->solver() == "mlcp-lemke") {
    GTEST_SKIP() << "Bullet's Lemke solver takes the coefficient of friction for a bound on the impulse";
  }
  expect_caught(slippery, "PushedBlockDoesNotSlide");
}

TEST_P(Mutants, OneCoefficientForAllInterfacesIsSeenInTheirSlips) {
  expect_caught(alike, "EachInterfaceHasItsFriction");
}

TEST_P(Mutants, RestitutionOfOneFifthIsSeenInAFlatLanding) {
  expect_caught(bouncy, "FlatLandingDoesNotBounce");
}

TEST_P(Mutants, MarginOfFourCentimetresIsSeenInTheQuarterPeriod) {
  expect_caught(fat, "QuarterPeriodIsHousners");
}

TEST_P(Mutants, MassWrongByOnePercentIsSeenInAPairsMomentum) {
  expect_caught(heavy, "PairKeepsItsMomentum");
}

std::vector<const Engine*> all() {
  std::vector<const Engine*> list;
  for (const auto& engine : linked_engines()) list.push_back(engine.get());
  return list;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Mutants);
INSTANTIATE_TEST_SUITE_P(Engines, Mutants, testing::ValuesIn(all()), [](const auto& engine) {
  std::string name = engine.param->name() + "_" + engine.param->solver();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace rockstack
