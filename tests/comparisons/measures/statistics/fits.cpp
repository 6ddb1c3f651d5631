#include "comparisons/measures/statistics/fits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/measures/results/tables.hpp"

namespace rockstack {
namespace {

RunMetrics row_at(double dt, const std::string& settings) {
  RunMetrics row;
  row.scene = "block";
  row.engine = "ode";
  row.solver = "step";
  row.settings = settings;
  row.dt = dt;
  row.rms_angle_difference = 1e-4 + dt;
  row.first_impact_time_difference = -0.5 * dt;
  return row;
}

std::vector<RunMetrics> rows() {
  std::vector<RunMetrics> list(1);  // the exact run has no step
  for (const double dt : {1e-2, 4e-3, 1e-3, 4e-4, 1e-4}) {
    list.push_back(row_at(dt, "tuned"));
    if (dt > 2e-4) list.push_back(row_at(dt, "default"));
  }
  return list;
}

TEST(Fits, AreMadeOfEverySeriesOfFiveStepsOrMore) {
  const auto fits = fit_runs(rows());
  ASSERT_EQ(fits.size(), 2U);  // "default" has four steps
  EXPECT_EQ(fits[0].settings, "tuned");
  EXPECT_EQ(fits[0].quantity, "rms_angle_difference");
  EXPECT_NEAR(fits[0].fit.model_error.value, 1e-4, 1e-6);
  EXPECT_EQ(fits[1].quantity, "first_impact_time_difference");
  EXPECT_NEAR(fits[1].fit.order.value, 1, 1e-3);
  EXPECT_NEAR(fits[1].fit.coefficient, 0.5, 1e-3);
}

TEST(Fits, RunsThatFailedAreLeftOut) {
  auto list = rows();
  list[1].rms_angle_difference.reset();
  EXPECT_EQ(fit_runs(list)[0].fit.reason, "4 steps are fewer than 5");
  const nlohmann::ordered_json json = fit_runs(list);
  EXPECT_TRUE(json[0]["gap"].is_null());
  EXPECT_FALSE(json[0]["holds"].get<bool>());
}

TEST(Fits, FileHasACellForEachName) {
  const std::string text = csv_of(nlohmann::ordered_json(fit_runs(rows())));
  const auto commas = [&](std::size_t from) {
    return std::count(text.begin() + static_cast<long>(from),
                      text.begin() + static_cast<long>(text.find('\n', from)), ',');
  };
  EXPECT_EQ(commas(0), 15);
  EXPECT_EQ(commas(text.find('\n') + 1), 15);
}

}  // namespace
}  // namespace rockstack
