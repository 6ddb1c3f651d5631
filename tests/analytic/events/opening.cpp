#include <gtest/gtest.h>

#include "analytic/mechanics/pattern_solution.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

// After an impact that joins blocks, the accelerations may open an interface at once. That is an event too:
// each event starts from the pattern the one before ended with.
TEST(Opening, EveryChangeOfPatternIsAnEvent) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    testing::Draw draw(6000 + seed);
    const Scene scene = testing::random_scene(draw, 2 + draw.below(3), seed % 2 == 1);
    const History history = solve(scene);
    for (std::size_t i = 1; i < history.events.size(); ++i) {
      ASSERT_TRUE(history.events[i - 1].to == history.events[i].from) << "seed " << seed << '\n'
                                                                      << testing::listing(history);
    }
  }
}

TEST(Opening, AnOpeningAtTheStartIsAnEvent) {
  Scene scene = testing::released({testing::block(1, 1), testing::block(0.2, 2)}, {0.2, 0.2}, 0.01);
  const History history = solve(scene, {.sample_times = {0.005}});
  ASSERT_EQ(history.events.size(), 1U);
  EXPECT_EQ(history.events[0].time, 0);
  EXPECT_EQ(history.events[0].kind, EventKind::opening);
  EXPECT_EQ(history.events[0].interface, 2);
  EXPECT_TRUE(history.events[0].to == history.patterns[0]);
}

// A ground acceleration exactly at the threshold opens for no time at all; while that is being settled, an
// opening to the other side within the same straight line must not be lost.
TEST(Opening, TheThresholdItselfHidesNoLaterOpening) {
  for (const double width : {0.3, 0.5, 0.7}) {
    for (const double share : {1 - 1e-16, 1.0, 1 + 1e-15}) {
      Scene scene = testing::released({testing::block(width, 2)}, {0}, 1);
      const double threshold = scene.gravity * width / 2 * share;
      scene.horizontal = {1.0, {threshold, -2 * threshold}, {}, {}};
      const History history = solve(scene);
      ASSERT_FALSE(history.events.empty());
      bool found = false;
      for (const Event& event : history.events) {
        if (event.kind != EventKind::opening || event.to[0] != Contact::right) continue;
        // Falls through −threshold at 2/3 s. An opening to rounding at t = 0 may delay its watch by one step.
        EXPECT_NEAR(event.time, 2.0 / 3, 1e-13) << testing::listing(history);
        found = true;
        break;
      }
      EXPECT_TRUE(found) << testing::listing(history);
    }
  }
}

// Seven touching interfaces have 3⁷ patterns. Of those that push everywhere there is one at most
// (impact.hpp); where the ground falls away faster than blocks do, others that pull may do.
TEST(Opening, APatternIsFoundWhereverThereIsOne) {
  constexpr int size = 7;
  int pushing = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    testing::Draw draw(seed);
    const Scene scene = testing::random_scene(draw, size, false);
    const auto model = make_model<double>(scene);
    const double g = scene.gravity;
    const Point<double> ground{draw.between(-1.5, 1.5) * g, draw.between(-1.3, 0.5) * g};
    const Vector<double> still = Vector<double>::Zero(size);
    const auto evaluate = [&](const Pattern& pattern) {
      return accelerate(model, State<double>{pattern, still, still}, ground);
    };
    Interfaces touching;
    for (std::size_t k = 0; k < size; ++k) touching.set(k);
    const Pattern closed = closed_pattern(size);
    const double slack = 500 * std::numeric_limits<double>::epsilon();
    const auto found = find_admissible(model.stack, closed, touching, slack, evaluate);
    std::optional<PatternSolution<double>> first;
    for (const Pattern& candidate : candidates(closed, touching)) {
      first = evaluate(candidate);
      if (!first_violation(model.stack, *first, touching, slack)) break;
      first.reset();
    }
    ASSERT_EQ(found.has_value(), first.has_value()) << seed;
    if (!found || !pushes(*found) || !pushes(*first)) continue;
    EXPECT_TRUE(found->pattern == first->pattern) << seed;
    ++pushing;
  }
  EXPECT_GT(pushing, 20);
}

}  // namespace
}  // namespace rockstack
