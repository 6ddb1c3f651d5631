#include "comparisons/measures/metrics/matching.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/alignment.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

/// The paper's two blocks: their impacts above the chatter speed, and their motion at steps of 1 ms.
struct Rocking {
  Scene scene = free_rocking(5);
  History history = solve(scene, {.sample_times = regular_times(1e-3, scene.duration)});
  std::vector<ImpactTime> impacts = reported_impacts(history, chatter_speed(scene));
};

/// The motion as it is, some time later: blocks that stand still until then.
History delayed(const History& history, double delay) {
  History later = history;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double time = std::max(history.times[i] - delay, 0.0);
    const auto source = static_cast<std::size_t>(std::lround(time / 1e-3));
    for (std::size_t k = 0; k < history.angles_at(i).size(); ++k)
      later.angles[i * history.angles_at(i).size() + k] = history.angles_at(source)[k];
  }
  return later;
}

std::vector<ImpactTime> shifted(std::vector<ImpactTime> impacts, double shift) {
  for (ImpactTime& impact : impacts) impact.time += shift;
  return impacts;
}

TEST(Matching, WithoutDriftAWindowIsThreeSteps) {
  const Rocking rocking;
  const Difference none = difference(rocking.history, rocking.history);
  for (const double one : matching_windows(rocking.impacts, none, 1e-3)) EXPECT_EQ(one, 3e-3);
  EXPECT_EQ(matching_windows(rocking.impacts, none, 1e-3), still_windows(rocking.impacts, 1e-3));
}

// At steps of 10 ms: shifted impacts of a motion that does not drift are no match, but where they come upon
// other impacts.
TEST(Matching, ImpactsThatNoDriftExplainsDoNotMatch) {
  const Rocking rocking;
  const auto late = shifted(rocking.impacts, 0.06);
  const auto windows = still_windows(rocking.impacts, 0.01);
  const int matched = count(align(rocking.impacts, late, windows)).matched;
  int neighbours = 0;
  for (const ImpactTime& impact : late) {
    neighbours += std::any_of(rocking.impacts.begin(), rocking.impacts.end(), [&](const ImpactTime& other) {
      return other.interface == impact.interface && std::abs(other.time - impact.time) <= 0.03;
    });
  }
  EXPECT_LE(matched, neighbours);
  EXPECT_LT(matched, static_cast<int>(rocking.impacts.size()) / 2);
}

// A delayed motion is off by velocity times delay when it should impact, so its window covers the delay
// unless another impact of the interface is nearer than that.
TEST(Matching, TheDriftOfADelayedMotionIsItsDelay) {
  const Rocking rocking;
  const double delay = 8e-3, step = 1e-3;
  const auto windows =
      matching_windows(rocking.impacts, difference(rocking.history, delayed(rocking.history, delay)), step);
  int covered = 0;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    double nearest = rocking.scene.duration;
    for (std::size_t j = 0; j < windows.size(); ++j) {
      if (i != j && rocking.impacts[i].interface == rocking.impacts[j].interface)
        nearest = std::min(nearest, std::abs(rocking.impacts[i].time - rocking.impacts[j].time));
    }
    EXPECT_LE(windows[i], std::max(3 * step, nearest / 2));
    if (nearest < 4 * delay) continue;
    EXPECT_GE(windows[i], delay) << rocking.impacts[i].time;
    // What the blocks accelerate in between is a small part of it.
    EXPECT_LE(windows[i], 2 * delay + 3 * step) << rocking.impacts[i].time;
    ++covered;
  }
  EXPECT_GT(covered, 5);
}

}  // namespace
}  // namespace rockstack
