#include "comparisons/studies/gate/gate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rockstack {
namespace {

/// Rows of one engine whose errors are as chance has them.
RecordedResults drawn(std::size_t rows) {
  std::mt19937_64 random(4);
  std::lognormal_distribution<double> error(std::log(1e-3), 0.5);
  RecordedResults results{"drawn", {}, {}, {}};
  for (std::size_t i = 0; i < rows; ++i) {
    RecordedRun& run = results.runs.emplace_back();
    for (int j = 0; j < 11; ++j) run.replicates.emplace_back().error = error(random);
    run.row.scene = "scene" + std::to_string(i);
    run.row.engine = run.row.solver = "engine";
    run.row.settings = "default";
    run.row.dt = 1e-3;
    run.row.steps = 1000;
    run.row.run = run.row.scene + ".engine";
  }
  return results;
}

/// Results in which the errors of one row have grown.
RecordedResults grown(RecordedResults results, std::size_t row, double factor) {
  for (RunMetrics& replicate : results.runs[row].replicates) *replicate.error *= factor;
  return results;
}

// The least factor is found to a thousandth.
TEST(Gate, ARowReportsWhatGrowsByItsLeastFactorAndNotWhatGrowsByLess) {
  for (const std::size_t rows : {1U, 6U}) {
    const RecordedResults before = drawn(rows);
    const auto least = sensitivities(hold_against(before, before, {}), before);
    ASSERT_EQ(least.size(), rows);
    for (std::size_t row = 0; row < rows; ++row) {
      const double factor = least[row].factor.value();
      EXPECT_GT(factor, 1.01);
      const auto trend = [&](double times) {
        return hold_against(before, grown(before, row, times), {}).rows[row].worst();
      };
      EXPECT_EQ(trend(1.002 * factor), Trend::worse);
      EXPECT_EQ(trend(0.998 * factor), Trend::none);
    }
  }
}

// The more rows there are, the more of them chance has to be kept from.
TEST(Gate, ManyRowsAreLessSensitiveEach) {
  const RecordedResults few = drawn(1), many = drawn(12);
  EXPECT_LT(*sensitivities(hold_against(few, few, {}), few)[0].factor,
            *sensitivities(hold_against(many, many, {}), many)[0].factor);
}

TEST(Gate, ErrorsOfNothingAreNeverShownToGrow) {
  RecordedResults still = drawn(1);
  for (RunMetrics& replicate : still.runs[0].replicates) replicate.error = 0;
  EXPECT_FALSE(sensitivities(hold_against(still, still, {}), still)[0].factor.has_value());
}

}  // namespace
}  // namespace rockstack
