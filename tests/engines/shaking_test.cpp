// A body force in the ground's frame and a ground that really moves are one motion: engines must come to
// agree on it as the step falls.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "tests/engines/linked_engines.hpp"

namespace rockstack {
namespace {

/// A slender block under one sine that lifts it (5 m/s² against 9.81 · 0.2) in both directions; the scene
/// ends before it comes back to the ground, so that no impact multiplies a difference.
Scene shaken_block() {
  Scene scene;
  scene.duration = 0.4;
  scene.blocks = {make_block(0.4, 2, 2500)};
  scene.initial = {{0}, {0}};
  scene.horizontal.pulse = Pulse{PulseShape::sine, 5, 0.8, 0, 1, 0};
  scene.vertical.pulse = Pulse{PulseShape::sine, 1.5, 0.5, 0, 1, 0};
  return scene;
}

class Shaking : public ::testing::TestWithParam<const Engine*> {
 protected:
  double last_angle(const std::string& way, double dt) const {
    Parameters parameters = GetParam()->tuned_parameters();
    // MuJoCo's contacts are to get stiffer with the step, which keeps their time constant at two.
    if (parameters.count("solref_timeconst") != 0) parameters["solref_timeconst"] = 1e-6;
    parameters["shaking"] = choice_value("", shaking_setting(), way);
    return simulate(*GetParam(), shaken_block(), dt, parameters).history.angles.back();
  }
};

TEST_P(Shaking, BothWaysAgreeAtFirstOrderInTheStep) {
  // Slope of the line through log |difference| over log dt, least squares.
  std::vector<double> x, y;
  for (const double dt : {4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4}) {
    const double force = last_angle("force", dt);
    const double ground = last_angle("ground", dt);
    ASSERT_GT(std::abs(force), 0.05) << "the block does not rock";
    x.push_back(std::log(dt));
    y.push_back(std::log(std::abs(force - ground)));
  }
  double mean_x = 0, mean_y = 0, over = 0, under = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / static_cast<double>(x.size());
    mean_y += y[i] / static_cast<double>(y.size());
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    over += (x[i] - mean_x) * (y[i] - mean_y);
    under += (x[i] - mean_x) * (x[i] - mean_x);
  }
  std::string points;
  for (std::size_t i = 0; i < x.size(); ++i)
    points += " " + std::to_string(std::exp(x[i])) + ": " + std::to_string(std::exp(y[i]));
  RecordProperty("slope", std::to_string(over / under));
  // First order is 1; the step at which the block lifts off moves in whole steps, which scatters it.
  EXPECT_GT(over / under, 0.8) << points;
}

std::vector<const Engine*> all() {
  std::vector<const Engine*> list;
  for (const auto& engine : linked_engines()) list.push_back(engine);
  return list;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Shaking);
INSTANTIATE_TEST_SUITE_P(Engines, Shaking, ::testing::ValuesIn(all()), [](const auto& engine) {
  std::string name = engine.param->name + "_" + engine.param->solver;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace rockstack
