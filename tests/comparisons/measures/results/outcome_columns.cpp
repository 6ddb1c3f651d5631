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

}  // namespace
}  // namespace rockstack
