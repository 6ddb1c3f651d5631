#include "comparisons/measures/metrics/alignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

#include "analytic/solve.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

constexpr double window = 0.05;

std::vector<AlignedImpact> aligned(const std::vector<ImpactTime>& exact,
                                   const std::vector<ImpactTime>& engine) {
  return align(exact, engine, std::vector<double>(exact.size(), window));
}

TEST(Alignment, OfASequenceWithItselfMatchesAllWithoutDifference) {
  const std::vector<ImpactTime> impacts{{0.6, 1}, {0.62, 2}, {0.9, 1}};
  for (const AlignedImpact& line : aligned(impacts, impacts)) EXPECT_EQ(line.exact, line.engine);
  EXPECT_EQ(count(aligned(impacts, impacts)).matched, 3);
}

TEST(Alignment, NamesMissedAndExtraImpactsInOrderOfTime) {
  const std::vector<ImpactTime> exact{{0.6, 1}, {0.7, 2}, {0.9, 1}};
  const std::vector<ImpactTime> engine{{0.61, 1}, {0.8, 2}, {0.91, 1}};
  const auto lines = aligned(exact, engine);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].number, 1);
  EXPECT_EQ(lines[0].engine, 0.61);
  EXPECT_EQ(lines[1].exact, 0.7);
  EXPECT_FALSE(lines[1].engine);
  EXPECT_EQ(lines[2].engine, 0.8);
  EXPECT_FALSE(lines[2].number);
  EXPECT_EQ(lines[3].number, 3);
  EXPECT_EQ(count(lines).missed, 1);
  EXPECT_EQ(count(lines).extra, 1);
}

TEST(Alignment, NeverPairsDifferentInterfaces) {
  EXPECT_EQ(count(aligned({{0.6, 1}}, {{0.6, 2}})).matched, 0);
}

TEST(Alignment, AnInterfaceDoesNotMindTheOrderOfAnother) {
  const std::vector<ImpactTime> exact{{0.60, 1}, {0.61, 2}}, engine{{0.60, 2}, {0.61, 1}};
  EXPECT_EQ(count(aligned(exact, engine)).matched, 2);
}

TEST(Alignment, EachExactImpactHasItsOwnWindow) {
  const std::vector<ImpactTime> exact{{0.6, 1}, {0.9, 1}}, engine{{0.61, 1}, {0.91, 1}};
  EXPECT_EQ(count(align(exact, engine, {0.02, 0.02})).matched, 2);
  EXPECT_EQ(count(align(exact, engine, {0.005, 0.02})).matched, 1);
}

TEST(Alignment, PairsNoImpactsThatLeaveToOppositeSides) {
  const auto matched = [](Contact exact, Contact engine) {
    return count(aligned({{0.6, 1, exact}}, {{0.61, 1, engine}})).matched;
  };
  EXPECT_EQ(matched(Contact::left, Contact::left), 1);
  EXPECT_EQ(matched(Contact::left, Contact::right), 0);
  EXPECT_EQ(matched(Contact::left, Contact::closed), 1);
  EXPECT_EQ(matched(Contact::closed, Contact::right), 1);
}

TEST(Alignment, TimeDifferencesAreThoseOfMatchedImpactsAlone) {
  const auto lines = aligned({{0.6, 1}, {0.7, 1}, {0.9, 2}}, {{0.604, 1}, {0.697, 1}, {0.9, 1}});
  const AlignmentCounts counts = count(lines);
  EXPECT_NEAR(counts.largest_apart, 0.004, 1e-15);
  EXPECT_NEAR(counts.rms_apart, std::sqrt((0.004 * 0.004 + 0.003 * 0.003) / 2), 1e-15);
  EXPECT_EQ(count({}).rms_apart, 0);
}

TEST(Alignment, OneImpactTooManyDoesNotShiftTheOthers) {
  const std::vector<ImpactTime> exact{{0.10, 1}, {0.14, 1}, {0.18, 1}};
  const std::vector<ImpactTime> engine{{0.10, 1}, {0.12, 1}, {0.14, 1}, {0.18, 1}};
  const auto lines = aligned(exact, engine);
  EXPECT_EQ(count(lines).matched, 3);
  for (const AlignedImpact& line : lines) {
    EXPECT_EQ(line.exact.value_or(line.engine.value_or(0)), line.engine.value_or(0));
  }
}

/// The most pairs that any order-keeping choice of pairs has, by trying all subsets of the shorter problem;
/// of impacts of one interface.
int most_pairs(const std::vector<ImpactTime>& exact, const std::vector<ImpactTime>& engine, std::size_t i,
               std::size_t j) {
  if (i == exact.size() || j == engine.size()) return 0;
  int best = std::max(most_pairs(exact, engine, i + 1, j), most_pairs(exact, engine, i, j + 1));
  if (std::abs(exact[i].time - engine[j].time) <= window) {
    best = std::max(best, 1 + most_pairs(exact, engine, i + 1, j + 1));
  }
  return best;
}

std::vector<ImpactTime> of_interface(const std::vector<ImpactTime>& impacts, int interface) {
  std::vector<ImpactTime> list;
  std::copy_if(impacts.begin(), impacts.end(), std::back_inserter(list),
               [&](const ImpactTime& impact) { return impact.interface == interface; });
  return list;
}

TEST(Alignment, HasAsManyPairsAsAnyOrderKeepingChoiceAndLosesNoImpact) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> time(0, 0.3);
  const auto sequence = [&] {
    std::vector<ImpactTime> impacts(random() % 7);
    for (ImpactTime& impact : impacts) impact = {time(random), static_cast<int>(random() % 2) + 1};
    std::sort(impacts.begin(), impacts.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    return impacts;
  };
  for (int round = 0; round < 500; ++round) {
    const auto exact = sequence();
    const auto engine = sequence();
    const AlignmentCounts counts = count(aligned(exact, engine));
    int most = 0;
    for (const int interface : {1, 2})
      most += most_pairs(of_interface(exact, interface), of_interface(engine, interface), 0, 0);
    EXPECT_EQ(counts.matched, most);
    EXPECT_EQ(counts.matched + counts.missed, static_cast<int>(exact.size()));
    EXPECT_EQ(counts.matched + counts.extra, static_cast<int>(engine.size()));
  }
}

/// The paper's two blocks: their impacts above the chatter speed, and their motion at steps of 1 ms.
struct Rocking {
  Scene scene = free_rocking(5);
  History history = solve(scene, {.sample_times = regular_times(1e-3, scene.duration)});
  std::vector<ImpactTime> impacts = reported_impacts(scene, history, chatter_speed(scene));
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

// Bullet's impacts of Housner's block: one of them falls beside an exact one after several that do not.
TEST(Alignment, TheThreadIsLostWhereBothHaveTwoInARowThatDoNotMatch) {
  const std::vector<ImpactTime> exact{{1, 1}, {2, 1}, {3, 1}, {4, 1}, {5, 2}};
  const auto lost = [&](const std::vector<ImpactTime>& engine) {
    return thread_lost(aligned(exact, engine), 1);
  };
  EXPECT_EQ(lost({{1.01, 1}, {2.2, 1}, {2.7, 1}, {4, 1}}), 3);
  EXPECT_TRUE(std::isinf(lost({{1.01, 1}, {2.2, 1}, {3, 1}, {4, 1}}))) << "one alone is a miss";
  EXPECT_TRUE(std::isinf(lost({{1.01, 1}, {4, 1}}))) << "nothing may be taken for another";
  EXPECT_TRUE(std::isinf(thread_lost(aligned(exact, {{1.5, 1}, {1.7, 1}, {5, 2}}), 2)));
}

TEST(Matching, WithoutDriftAWindowIsThreeSteps) {
  const Rocking rocking;
  const Difference none = gap_difference(rocking.scene, rocking.history, rocking.history);
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
  const auto windows = matching_windows(
      rocking.impacts, gap_difference(rocking.scene, rocking.history, delayed(rocking.history, delay)), step);
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
