#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/analytic/reference/agreement.hpp"
#include "tests/analytic/reference/example_scenes.hpp"
#include "tests/analytic/reference/integrated.hpp"

namespace rockstack::testing {
namespace {

/// The largest deviations of the first events by Runge–Kutta from those of the reference.
Deviation of_runge_kutta(const Scene& scene, double step, std::size_t events) {
  const Agreement agreement = compare(integrate(scene, step, events), reference(scene));
  EXPECT_EQ(agreement.events.size(), events);
  Deviation worst;
  for (const Deviation& deviation : agreement.events) {
    worst.time = std::max(worst.time, std::abs(deviation.time));
    worst.state = std::max(worst.state, deviation.state);
  }
  return worst;
}

/// Were it the reference that is wrong, a smaller step would not bring them together, and not by 2⁸ = 256
/// either.
void expect_eighth_order(const Deviation& coarse, const Deviation& fine) {
  EXPECT_GT(coarse.time / fine.time, 150);
  EXPECT_LT(coarse.time / fine.time, 400);
  EXPECT_GT(coarse.state / fine.state, 150);
  EXPECT_LT(coarse.state / fine.state, 400);
}

TEST(ReferenceConfirmed, ByEighthOrderRungeKuttaOfTwoFreeBlocks) {
  Scene scene = two_blocks_free();
  scene.duration = 1;
  const Deviation fine = of_runge_kutta(scene, 0x1p-9, 12);
  expect_eighth_order(of_runge_kutta(scene, 0x1p-8, 12), fine);
  EXPECT_LT(fine.time, 1e-21);
}

TEST(ReferenceConfirmed, ByEighthOrderRungeKuttaOfOneFreeBlock) {
  Scene scene = one_block_free();
  scene.duration = 4;
  const Deviation fine = of_runge_kutta(scene, 0x1p-8, 3);
  expect_eighth_order(of_runge_kutta(scene, 0x1p-7, 3), fine);
  EXPECT_LT(fine.time, 1e-21);
}

TEST(ReferenceConfirmed, ByEighthOrderRungeKuttaOfTwoBlocksUnderARecord) {
  Scene scene = two_blocks_recorded();
  scene.duration = 2.8;
  const double interval = scene.horizontal.interval;
  const Deviation fine = of_runge_kutta(scene, interval / 8, 8);
  expect_eighth_order(of_runge_kutta(scene, interval / 4, 8), fine);
  EXPECT_LT(fine.time, 1e-21);
}

}  // namespace
}  // namespace rockstack::testing
