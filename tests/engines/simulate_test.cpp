// Running an engine in this process.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engines/scene_setup.hpp"
#include "tests/engines/linked_engines.hpp"

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
  BodyState body(std::size_t) const override {
    return {.angle = own_steps_ == counts_.lost_at ? std::nan("") : 0.1 * own_steps_};
  }

 private:
  Counts& counts_;
  int own_steps_ = 0;
};

Engine counting_engine(Counts& counts) {
  return {{.name = "counting", .solver = "none"}, [&counts](const Setup&, const Parameters&) {
            ++counts.started;
            return std::make_unique<CountingSimulation>(counts);
          }};
}

Scene one_block(double duration) {
  Scene scene;
  scene.duration = duration;
  scene.blocks = {make_block(1, 1, 2500)};
  scene.initial = {{0}, {0}};
  return scene;
}

TEST(Engines, StepsThatOdeCouldNotSolveAreCounted) {
  for (const auto& engine : linked_engines()) {
    if (engine->name != "ode" || engine->solver != "step") continue;
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
  const History history = simulate(counting_engine(counts), one_block(0.3), dt, {}).history;
  ASSERT_EQ(history.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(history.times[i], static_cast<double>(i) * dt);
}

TEST(Simulate, LostAngleIsReportedWithBlockAndTime) {
  Counts counts;
  counts.lost_at = 2;
  try {
    simulate(counting_engine(counts), one_block(1), 0.25, {});
    FAIL() << "no error";
  } catch (const NotFinite& error) {
    EXPECT_STREQ(error.what(), "angle of block 1 is not finite at t = 0.5 s");
  }
}

TEST(TimeStepping, EveryRunStartsAnewAndTakesTheStepsAskedFor) {
  Counts counts;
  const auto seconds = time_stepping(counting_engine(counts), set_up(one_block(0.5), 0.1, {}), {}, 5, 3);
  EXPECT_EQ(counts.started, 3);
  EXPECT_EQ(counts.steps, 3 * 5);
  ASSERT_EQ(seconds.size(), 3U);
  for (const double time : seconds) EXPECT_GE(time, 0);
}

}  // namespace
}  // namespace rockstack
