#include "comparisons/measures/statistics/fits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rockstack {
namespace {

const std::vector<double> steps{1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5};

/// Errors on the curve, each off by a factor of exp(noise · normal).
std::vector<StepError> on_curve(double gap, double coefficient, double order, double noise, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<StepError> errors;
  errors.reserve(steps.size());
  for (const double step : steps) {
    errors.push_back({step, (gap + coefficient * std::pow(step, order)) * std::exp(noise * normal(random))});
  }
  return errors;
}

TEST(StepFit, FindsGapCoefficientAndOrderOfErrorsOnTheCurve) {
  for (const double order : {0.5, 1.0, 2.0}) {
    // The gap is met in the middle of the steps.
    const double coefficient = 2, gap = coefficient * std::pow(5e-4, order);
    const StepFit fit = fit_steps(on_curve(gap, coefficient, order, 0, 1));
    EXPECT_TRUE(fit.holds()) << fit.reason;
    // The search ends at 0.44^16 = 2e-6 of its range.
    EXPECT_NEAR(fit.order.value, order, 1e-4 * order);
    EXPECT_NEAR(fit.model_error.value, gap, 1e-3 * gap);
    EXPECT_NEAR(fit.coefficient, coefficient, 1e-3 * coefficient);
  }
}

TEST(StepFit, OfAPurePowerHasNoGap) {
  const StepFit fit = fit_steps(on_curve(0, 3, 1, 0.02, 2));
  EXPECT_TRUE(fit.holds()) << fit.reason;
  EXPECT_EQ(fit.model_error.low, 0);
  EXPECT_LT(fit.model_error.high, 3 * steps.back());
  EXPECT_NEAR(fit.order.value, 1, 0.1);
}

// Each of 40 bounds of 95 % misses the truth with a chance of 1 in 20; 8 misses or more have one of 1e-3.
// The curve is not a straight one, so that bounds are a little too wide or narrow.
TEST(StepFit, BoundsHoldTheTruthAboutAsOftenAsTheySay) {
  int orders = 0, gaps = 0;
  constexpr double gap = 1e-3, order = 1;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const StepFit fit = fit_steps(on_curve(gap, 2, order, 0.1, seed));
    if (fit.order.low <= order && order <= fit.order.high) ++orders;
    if (fit.model_error.low <= gap && gap <= fit.model_error.high) ++gaps;
  }
  EXPECT_GE(orders, 33);
  EXPECT_GE(gaps, 33);
}

TEST(StepFit, ScalesWithTheErrorsUnit) {
  const auto errors = on_curve(1e-3, 2, 1, 0.1, 3);
  auto scaled = errors;
  for (StepError& one : scaled) one.error *= 1000;
  const StepFit first = fit_steps(errors), second = fit_steps(scaled);
  EXPECT_NEAR(second.model_error.high, 1000 * first.model_error.high, 1e-3 * second.model_error.high);
  EXPECT_NEAR(second.order.low, first.order.low, 1e-4);
  EXPECT_NEAR(second.scatter, first.scatter, 1e-6);
}

TEST(StepFit, SaysThatFewStepsAreTooFew) {
  auto errors = on_curve(1e-3, 2, 1, 0, 1);
  errors.resize(4);
  EXPECT_EQ(fit_steps(errors).reason, "4 steps are fewer than 5");
  errors.push_back({1e-6, 0});
  errors.push_back({1e-7, std::nan("")});
  EXPECT_EQ(fit_steps(errors).reason, "4 steps are fewer than 5");
}

TEST(StepFit, SaysThatErrorsScatter) {
  std::vector<StepError> errors;
  for (std::size_t i = 0; i < steps.size(); ++i) errors.push_back({steps[i], i % 2 == 0 ? 0.1 : 0.01});
  const StepFit fit = fit_steps(errors);
  EXPECT_TRUE(fit.reason.starts_with("the errors scatter about the curve by a factor of")) << fit.reason;
}

TEST(StepFit, SaysThatErrorsDoNotFall) {
  EXPECT_EQ(fit_steps(on_curve(1e-3, 1e-9, 1, 0.1, 4)).reason, "the errors do not fall with the step");
}

}  // namespace
}  // namespace rockstack
