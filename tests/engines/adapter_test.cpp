// What every adapter promises about how it is called.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/engines/linked_engines.hpp"

namespace rockstack {
namespace {

struct Judged {
  const Engine* engine;
  bool tuned;
};

std::vector<Judged> setups() {
  std::vector<Judged> list;
  for (const auto& engine : linked_engines()) {
    list.push_back({engine, false});
    list.push_back({engine, true});
  }
  return list;
}

void PrintTo(const Judged& setup, std::ostream* out) {
  *out << setup.engine->name << (setup.tuned ? " tuned" : " default");
}

std::string name_of(const testing::TestParamInfo<Judged>& info) {
  std::string name = info.param.engine->name + "_" + info.param.engine->solver;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name + (info.param.tuned ? "_tuned" : "_default");
}

Scene at_rest(std::vector<Block> blocks, double duration) {
  Scene scene;
  scene.duration = duration;
  scene.initial.angles.assign(blocks.size(), 0);
  scene.initial.velocities.assign(blocks.size(), 0);
  scene.blocks = std::move(blocks);
  return scene;
}

/// A block of slenderness atan(0.2), released at half its slenderness.
Scene slender_block(double duration) {
  Scene scene = at_rest({make_block(0.4, 2, 2500)}, duration);
  scene.initial.angles = {0.5 * std::atan(0.2)};
  return scene;
}

class Adapters : public testing::TestWithParam<Judged> {
 protected:
  Parameters parameters() const {
    const auto& [engine, tuned] = GetParam();
    return tuned ? engine->tuned_parameters() : engine->default_parameters();
  }
  History run(const Scene& scene, double dt) const {
    return simulate(*GetParam().engine, scene, dt, parameters()).history;
  }
};

TEST_P(Adapters, StepMustBeAPositiveFiniteNumber) {
  for (const double dt : {0.0, -1e-3, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(run(slender_block(1), dt), std::invalid_argument) << "dt = " << dt;
  }
}

TEST_P(Adapters, UnknownParameterIsNamed) {
  Parameters given = parameters();
  given["wishes"] = 3;
  try {
    start(*GetParam().engine, slender_block(1), 1e-3, given);
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("wishes: no such parameter"), std::string::npos) << error.what();
  }
}

TEST_P(Adapters, EveryParameterIsNeededAndMustBeANumber) {
  for (const auto& [name, value] : parameters()) {
    Parameters without = parameters();
    without.erase(name);
    EXPECT_THROW(start(*GetParam().engine, slender_block(1), 1e-3, without), std::invalid_argument) << name;
    Parameters undefined = parameters();
    undefined[name] = std::nan("");
    EXPECT_THROW(start(*GetParam().engine, slender_block(1), 1e-3, undefined), std::invalid_argument) << name;
  }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Adapters);
INSTANTIATE_TEST_SUITE_P(Engines, Adapters, testing::ValuesIn(setups()), name_of);

}  // namespace
}  // namespace rockstack
