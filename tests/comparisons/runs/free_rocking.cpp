// The paper's free-rocking example, Spanos et al. 2001, up to the second peak of the top block: tuned engines
// at a step of 1e-5 s do what the exact solution does.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/sampled_patterns.hpp"
#include "engines/worker/registry.hpp"
#include "tests/free_rocking.hpp"
#include "tests/native_engines.hpp"

namespace rockstack {
namespace {

constexpr double dt = 1e-5;  ///< s

/// The sample at which the top block leans most after the first second.
std::size_t second_peak(const History& history) {
  std::size_t best = history.size() - 1;
  for (std::size_t i = 0; i < history.size(); ++i) {
    if (history.times[i] > 1 && std::abs(history.angles_at(i)[1]) > std::abs(history.angles_at(best)[1]))
      best = i;
  }
  return best;
}

class FreeRocking : public OfEngine {};

TEST_P(FreeRocking, FollowsTheExactSolutionToTheSecondPeak) {
  const Scene scene = free_rocking(1.25);
  const History engine = simulate(first_solver(), scene, dt, first_solver().tuned_parameters()).history;
  const History exact = solve(scene, {.sample_times = engine.times});
  const double slowest = chatter_speed(scene);
  const auto expected = reported_impacts(scene, exact, slowest);
  const auto observed = observed_impacts(scene, engine, slowest);
  ASSERT_FALSE(expected.empty());
  ASSERT_FALSE(observed.empty());
  EXPECT_EQ(observed.front().interface, 1);
  EXPECT_NEAR(observed.front().time, expected.front().time, 2 * dt);
  const std::size_t peak = second_peak(exact);
  const double exact_peak = exact.angles_at(peak)[1];
  EXPECT_NEAR(engine.angles_at(second_peak(engine))[1], exact_peak, 0.01 * std::abs(exact_peak));
  EXPECT_GE(sequence_time(exact.times, sampled_patterns(scene, exact), sampled_patterns(scene, engine)),
            exact.times[peak]);
}

/// Engines of double precision.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(FreeRocking);
INSTANTIATE_TEST_SUITE_P(Engines, FreeRocking, ::testing::ValuesIn(native_names({"bullet-single", "box2d"})),
                         engine_test_name);

}  // namespace
}  // namespace rockstack
