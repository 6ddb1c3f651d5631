#include <gtest/gtest.h>

#include <cmath>

#include "tests/analytic/reference/random_scenes.hpp"
#include "tests/analytic/solver/stacks.hpp"
#include "tests/analytic/unilateral/springs/random_springs.hpp"

namespace rockstack::testing {
namespace {

/// One block of half-sizes 0.25 m and 0.5 m on two springs of k N/m without dashpots, or on a bed of κ = k/b,
/// which is as stiff in all.
Scene on_springs(double stiffness, bool bed, double angle, double duration) {
  Scene scene = released({block(0.5, 1)}, {angle}, duration);
  scene.law = Law::compliant;
  if (bed) {
    scene.springs.bed_stiffness = {stiffness / 0.25};
  } else {
    scene.springs.stiffness = {stiffness};
  }
  return scene;
}

/// To first order in the angle, with x of the centre of mass and the stiffness against turning, 2kb² of two
/// springs and ⅔κb³ of a bed,
///     m ẍ = −2k_t (x − hθ),  I θ̈ = 2k_t h (x − hθ) − (turning − mgh) θ.
struct TwoModes {
  double slow = 0, fast = 0;  ///< ω², 1/s²
  double share = 0;           ///< of the slow mode in θ, of a block released at x = hθ

  TwoModes(const Scene& scene, double stiffness, bool bed) {
    const Block& one = scene.blocks.front();
    const double h = one.half_height;
    const double along = 2 * stiffness * scene.springs.tangential;
    const double turning =
        2 * stiffness * one.half_width * one.half_width / (bed ? 3 : 1) - one.mass * scene.gravity * h;
    const double a = along / one.mass;
    const double sum = a + (along * h * h + turning) / one.inertia;
    const double product = along / one.mass * turning / one.inertia;
    fast = (sum + std::sqrt(sum * sum - 4 * product)) / 2;
    slow = product / fast;
    // In a mode x = a h θ / (a − ω²).
    const double x_slow = a * h / (a - slow);
    const double x_fast = a * h / (a - fast);
    share = (h - x_fast) / (x_slow - x_fast);
  }
};

class Foundations : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(SpringsOrABed, Foundations, ::testing::Bool());

// In 113 bits, where the square of the angle is no error.
TEST_P(Foundations, RockAtSmallAnglesInTwoModes) {
  for (const double tangential : {0.3, 1.0, 20.0}) {
    constexpr double angle = 1e-13;
    Scene scene = on_springs(1e7, GetParam(), angle, 0.1);
    scene.springs.tangential = tangential;
    const TwoModes modes(scene, 1e7, GetParam());
    const std::vector<double> times{0.01, 0.03, 0.07, 0.1};
    const QuadHistory history = reference(scene, times);
    EXPECT_TRUE(history.events.empty());
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double expected = modes.share * std::cos(std::sqrt(modes.slow) * times[i]) +
                              (1 - modes.share) * std::cos(std::sqrt(modes.fast) * times[i]);
      EXPECT_NEAR(static_cast<double>(history.angles[i]) / angle, expected, 1e-10)
          << tangential << ' ' << times[i];
    }
  }
}

// Held sideways, a base has one mode: ω² = (2kb² − mgh)/I_O, I_O = m(b² + 4h²)/3, about its middle; on a bed
// ⅔κb³ stands in place of 2kb².
TEST_P(Foundations, RockAboutTheirMiddleWhereTheyAreStiffAlongTheFace) {
  Scene scene = on_springs(1e7, GetParam(), 0, 1);
  scene.springs.tangential = 1e12;
  const Block& one = scene.blocks.front();
  const double b = one.half_width;
  const double h = one.half_height;
  const double about_middle = one.mass * (b * b + 4 * h * h) / 3;
  const double turning = GetParam() ? 2.0 / 3 * (1e7 / b) * b * b * b : 2 * 1e7 * b * b;
  const TwoModes modes(scene, 1e7, GetParam());
  EXPECT_NEAR(modes.slow * about_middle / (turning - one.mass * scene.gravity * h), 1, 1e-10);
  EXPECT_NEAR(modes.share, 1, 1e-10);
}

// An end lifts at the angle mg/(2kb), on a bed mg/(2κb²), as it bears the weight all the time. What is of the
// second order in the angle falls with 1/k.
TEST_P(Foundations, LetGoAtTheUpliftAngle) {
  Scene scene = on_springs(1e16, GetParam(), 0, 2e-6);
  scene.horizontal.pulse = Pulse{PulseShape::rectangle, scene.gravity, 1};
  const Block& one = scene.blocks.front();
  const QuadHistory history = reference(scene);
  ASSERT_FALSE(history.events.empty());
  EXPECT_EQ(history.events.front().kind, EventKind::part);
  const double uplift = one.mass * scene.gravity / (2e16 * one.half_width);
  EXPECT_NEAR(static_cast<double>(abs(history.events.front().angles[0])) / uplift, 1, 1e-10);
}

// Blocks on springs have the events of the reference, or part from them where a rounding of the input does so
// too. Many more by the program reference_scenes.
TEST(RandomSprings, HaveTheEventsOfTheReferenceUnlessRoundingsDecide) {
  Tally tally;
  for (const std::uint64_t seed : {0U, 1U, 2U, 6U}) {
    const std::string difference = tally.add(seed, springy_scene(seed));
    EXPECT_EQ(tally.unexplained, 0U) << difference;
  }
  EXPECT_GT(tally.events, 50U);
  RecordProperty("summary", tally.summary());
}

}  // namespace
}  // namespace rockstack::testing
