#include "comparisons/measures/results/outcome_columns.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "analytic/solve.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

std::set<std::string> field_names(const Json& json) {
  std::set<std::string> names;
  for (const auto& [name, value] : json.items()) names.insert(name);
  return names;
}

TEST(OutcomeColumns, AMotionHasThemAsFieldsAndAnEnginesThoseThatSamplesTell) {
  const Scene scene = free_rocking(2);
  const RunOutcome outcome = run_outcome(scene, solve(scene, run_options()));
  std::set<std::string> whole, sampled;
  for (const OutcomeColumn& column : outcome_columns(scene.blocks.size())) {
    if (column.name == "status" || column.name == "reason") continue;
    whole.insert(column.name);
    if (column.sampled) sampled.insert(column.name);
  }
  const Json exact = outcome_json(outcome), engine = outcome_json(outcome, true);
  EXPECT_EQ(field_names(exact), whole);
  EXPECT_EQ(field_names(engine), sampled);
  EXPECT_EQ(exact.at("peak_1"), outcome.peaks[0]);
  EXPECT_EQ(exact.at("peak_ratio"), outcome.peak_ratio);
  EXPECT_EQ(exact.at("toppled"), 0);
  EXPECT_TRUE(exact.at("topple_time").is_null());
  EXPECT_EQ(exact.at("force_friction"), outcome.force.friction);
  EXPECT_EQ(exact.at("motion"), "rock");
  EXPECT_EQ(engine.at("peak_ratio"), outcome.peak_ratio);
}

TEST(OutcomeColumns, OfEachBlockAddUpToThoseOfAll) {
  Scene scene = free_rocking(2);
  scene.law = Law::unilateral;
  scene.friction = {0.3, 0.25};
  const Json json = outcome_json(run_outcome(scene, solve(scene, run_options())));
  const auto larger = [&](const std::string& name) {
    return std::max(std::abs(json.at(name + "_1").get<double>()),
                    std::abs(json.at(name + "_2").get<double>()));
  };
  for (const char* name : {"peak_ratio", "slip", "lift", "uplift", "largest_slip"})
    EXPECT_EQ(json.at(name), larger(name)) << name;
  EXPECT_GT(json.at("slip"), 0.0);
  for (const char* block : {"_1", "_2"})
    EXPECT_GE(json.at(std::string("largest_slip") + block),
              std::abs(json.at(std::string("slip") + block).get<double>()));
  EXPECT_EQ(json.at("peak_ratio_2").get<double>(), json.at("peak_2").get<double>() / slenderness(scene, 1));
  const Scene held = free_rocking(2);
  const Json pivots = outcome_json(run_outcome(held, solve(held, run_options())));
  EXPECT_EQ(pivots.at("force_friction"), std::max(pivots.at("force_friction_1").get<double>(),
                                                  pivots.at("force_friction_2").get<double>()));
  EXPECT_TRUE(pivots.at("slip_1").is_null());
  EXPECT_TRUE(pivots.at("largest_slip").is_null());
}

// A block that nothing moves rests from the start; one that is let go rests after its last impact, and does
// not while it rocks.
TEST(OutcomeColumns, RestBeginsWithTheLastEventOfAMotionThatEndsSo) {
  const auto rest_time = [](double angle, double duration) {
    Scene scene = free_rocking(duration);
    scene.blocks.resize(1);
    scene.initial = {{angle}, {0}};
    const RunOutcome outcome = run_outcome(scene, solve(scene, run_options()));
    EXPECT_TRUE(angle == 0 || !outcome.rest_time || outcome.rest_time == outcome.last_event_time);
    return outcome.rest_time;
  };
  EXPECT_EQ(rest_time(0, 1), 0.0);
  EXPECT_FALSE(rest_time(0.1, 0.2));
  ASSERT_TRUE(rest_time(0.1, 2));
  EXPECT_GT(*rest_time(0.1, 2), 0.2);
  EXPECT_EQ(rest_time(0.1, 2), rest_time(0.1, 3));
}

}  // namespace
}  // namespace rockstack
