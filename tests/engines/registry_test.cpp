// What holds for the list of engines and for running any one of them.

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "analytic/scene/input_error.hpp"
#include "engines/engine.hpp"

namespace rockstack {
namespace {

/// Counts what is asked of it; its one block's angle grows by 0.1 rad a step and is lost at the step
/// `lost_at`.
struct Counts {
  int started = 0;
  int steps = 0;
  int lost_at = -1;
};

class CountingSimulation : public Simulation {
 public:
  explicit CountingSimulation(Counts& counts) : counts_(counts) {}
  void step() override {
    ++counts_.steps;
    ++own_steps_;
  }
  void read(std::span<double> angles, std::span<double> velocities) const override {
    angles[0] = own_steps_ == counts_.lost_at ? std::nan("") : 0.1 * own_steps_;
    velocities[0] = 0;
  }

 private:
  Counts& counts_;
  int own_steps_ = 0;
};

class CountingEngine : public Engine {
 public:
  explicit CountingEngine(Counts& counts) : counts_(counts) {}
  std::string name() const override { return "counting"; }
  std::string solver() const override { return "none"; }
  std::string version() const override { return "0"; }
  std::vector<Setting> settings() const override { return {}; }
  std::unique_ptr<Simulation> start(const Scene&, double, const Parameters&) const override {
    ++counts_.started;
    return std::make_unique<CountingSimulation>(counts_);
  }

 private:
  Counts& counts_;
};

Scene one_block(double duration) {
  Scene scene;
  scene.duration = duration;
  scene.blocks = {make_block(1, 1, 2500)};
  scene.initial = {{0}, {0}};
  return scene;
}

std::string message_of_finding(const std::string& name) {
  try {
    find_engine(name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Registry, EveryEngineIsThereOrNamedAsLeftOut) {
  std::set<std::string> names;
  for (const std::string& name : engines_left_out()) names.insert(name);
  for (const auto& engine : engines()) names.insert(engine->name());
  EXPECT_EQ(names, (std::set<std::string>{"bullet", "ode"}));
}

TEST(Registry, EngineIsFoundByNameAndBySolver) {
  for (const auto& engine : engines()) {
    EXPECT_EQ(&find_engine(engine->name() + ":" + engine->solver()), engine.get());
    EXPECT_EQ(find_engine(engine->name()).name(), engine->name());
  }
}

TEST(Registry, UnknownEngineIsNamedBesideThoseThatAreThere) {
  const std::string message = message_of_finding("newton");
  EXPECT_TRUE(contains(message, "newton")) << message;
  for (const auto& engine : engines()) {
    EXPECT_TRUE(contains(message, engine->name() + ":" + engine->solver())) << message;
  }
  for (const std::string& name : engines_left_out()) EXPECT_TRUE(contains(message, name)) << message;
}

TEST(Registry, BothParameterSetsHaveTheSameNames) {
  for (const auto& engine : engines()) {
    const Parameters standard = engine->default_parameters();
    const Parameters tuned = engine->tuned_parameters();
    ASSERT_EQ(standard.size(), tuned.size());
    for (const auto& [name, value] : standard) EXPECT_EQ(tuned.count(name), 1U) << name;
  }
}

TEST(Registry, FrictionIsNeverMoreThanAskedFor) {
  for (const auto& engine : engines()) {
    EXPECT_EQ(engine->friction(0.5), 0.5);
    EXPECT_LE(engine->friction(1e3), 1e3);
  }
}

TEST(Registry, StepsThatOdeCouldNotSolveAreCounted) {
  for (const auto& engine : engines()) {
    if (engine->name() != "ode" || engine->solver() != "step") continue;
    Scene scene = one_block(0.1);
    scene.blocks.push_back(scene.blocks[0]);
    scene.initial = {{0.15, 0.15}, {0, 0}};
    EXPECT_EQ(simulate(*engine, scene, 1e-3, engine->default_parameters()).warnings, 0U);
    Parameters singular = engine->default_parameters();
    // Four contacts hold the upper block twice over: without softness the solver has no unique answer.
    singular["cfm"] = 0;
    EXPECT_GT(simulate(*engine, scene, 1e-3, singular).warnings, 0U);
  }
}

TEST(Simulate, SampleTimesAreWholeMultiplesOfTheStep) {
  Counts counts;
  const double dt = 0.1;
  // 0.3 / 0.1 is a little less than 3 in binary and still three steps.
  const History history = simulate(CountingEngine(counts), one_block(0.3), dt, {}).history;
  ASSERT_EQ(history.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(history.times[i], static_cast<double>(i) * dt);
}

TEST(Simulate, LostAngleIsReportedWithBlockAndTime) {
  Counts counts;
  counts.lost_at = 2;
  try {
    simulate(CountingEngine(counts), one_block(1), 0.25, {});
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "angle of block 1 is not finite at t = 0.5 s");
  }
}

TEST(TimeStepping, EveryRunStartsAnewAndTakesTheSimulationsSteps) {
  Counts counts;
  const SteppingTime time = time_stepping(CountingEngine(counts), one_block(0.5), 0.1, {}, 3);
  EXPECT_EQ(counts.started, 4);
  EXPECT_EQ(counts.steps, 4 * 5);
  EXPECT_EQ(time.repeats, 3);
  EXPECT_LE(time.minimum, time.median);
}

TEST(TimeStepping, NoRepeatsIsAnError) {
  Counts counts;
  EXPECT_THROW(time_stepping(CountingEngine(counts), one_block(0.5), 0.1, {}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace rockstack
