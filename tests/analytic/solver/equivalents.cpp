#include <gtest/gtest.h>

#include <algorithm>

#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

// Pairs of scenes that must move alike. Their numbers are rounded differently, and an impact may multiply
// what differs: 1e-9 rad holds six digits in reserve over the rounding of 1e-16.
constexpr double alike = 1e-9;

/// The time up to which both histories have only the events that `counts` leaves out.
template <class Counts>
double first_event(const Scene& scene, const History& history, const Counts& counts) {
  for (const Event& event : history.events) {
    if (counts(event)) return event.time;
  }
  return scene.duration;
}

GroundMotion constant(double acceleration, double duration) {
  return {duration, {acceleration, acceleration}, {}, {}};
}

/// Chatter whose end is near: an interface parts at less than 1e-9 rad/s, a thousand settling speeds.
bool ends_chatter(const Event& event) {
  double below = 0;
  for (const double velocity : event.after) {
    if (velocity != below && std::abs(velocity - below) < 1e-9) return true;
    below = velocity;
  }
  return event.kind == EventKind::closure || event.kind == EventKind::rest;
}

// Up to the end of chatter, which is measured by gravity without the ground's share.
TEST(Equivalents, ConstantVerticalGroundAccelerationIsMoreGravity) {
  int events = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    testing::Draw draw(10000 + seed);
    Scene lifted = testing::random_scene(draw, 1 + draw.below(4), false);
    Scene heavy = lifted;
    const double more = draw.between(-5, 10);
    lifted.vertical = constant(more, lifted.duration);
    heavy.gravity += more;
    const History one = solve(lifted);
    const History other = solve(heavy);
    for (std::size_t i = 0; i < one.events.size() && !ends_chatter(one.events[i]); ++i) {
      ASSERT_LT(i, other.events.size()) << seed;
      ASSERT_NEAR(one.events[i].time, other.events[i].time, alike) << seed;
      ASSERT_EQ(one.events[i].to, other.events[i].to) << seed;
      for (std::size_t k = 0; k < one.events[i].after.size(); ++k)
        ASSERT_NEAR(one.events[i].after[k], other.events[i].after[k], alike) << seed;
      ++events;
    }
  }
  EXPECT_GT(events, 1000);
}

bool is_of_ground(const Event& event) {
  return event.interface == 1 || event.kind == EventKind::topple || event.kind == EventKind::closure;
}

// Seen from the ground, the pull (−ẍg, −g − ÿg) is straight down after a turn by β. While the base turns
// about one pivot, the whole stack may be turned with it.
TEST(Equivalents, ConstantGroundAccelerationIsGravityTurned) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    testing::Draw draw(10500 + seed);
    Scene inclined = testing::random_scene(draw, 1 + draw.below(4), false);
    const double base = inclined.initial.angles[0];
    if (base == 0) continue;
    Scene upright = inclined;
    // Turned away from the ground, so that the base keeps its pivot.
    const double turn = (base > 0 ? -1 : 1) * draw.between(0.01, 0.1);
    upright.gravity = draw.between(5, 15);
    inclined.horizontal = constant(upright.gravity * std::sin(turn), inclined.duration);
    inclined.vertical = constant(upright.gravity * std::cos(turn) - inclined.gravity, inclined.duration);
    for (double& angle : upright.initial.angles) angle -= turn;
    const SolveOptions options{.sample_times = regular_times(0.01, inclined.duration)};
    const History one = solve(inclined, options);
    const History other = solve(upright, options);
    const double end =
        std::min(first_event(inclined, one, is_of_ground), first_event(upright, other, is_of_ground));
    for (std::size_t i = 0; i < std::min(one.size(), other.size()) && one.times[i] < end; ++i) {
      for (std::size_t k = 0; k < one.angles_at(i).size(); ++k)
        ASSERT_NEAR(one.angles_at(i)[k] - turn, other.angles_at(i)[k], alike)
            << seed << " at " << one.times[i];
      ++compared;
    }
  }
  EXPECT_GT(compared, 3000);
}

/// A block, and the same cut into layers of one density: their common centre is at its mid-height.
struct Cut {
  Scene whole, layers;
};

Cut random_cut(testing::Draw& draw) {
  Cut cut{testing::random_scene(draw, 1, false), {}};
  testing::shake(draw, cut.whole);
  cut.layers = cut.whole;
  Block& whole = cut.whole.blocks[0];
  const double moved = cut.whole.initial.angles[0];
  std::vector<double> ends{0, 1};
  for (int cuts = 1 + draw.below(3); cuts > 0; --cuts) ends.push_back(draw.between(0.05, 0.95));
  std::sort(ends.begin(), ends.end());
  cut.layers.blocks.clear();
  whole.inertia = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double share = ends[i] - ends[i - 1];
    const double inertia = share * whole.mass * draw.between(0.05, 0.5);
    cut.layers.blocks.push_back({whole.half_width, share * whole.half_height, share * whole.mass, inertia});
    const double height = (ends[i] + ends[i - 1] - 1) * whole.half_height;  // above the common centre
    whole.inertia += inertia + share * whole.mass * height * height;
  }
  cut.layers.initial.angles.assign(cut.layers.blocks.size(), moved);
  cut.layers.initial.velocities.assign(cut.layers.blocks.size(), cut.whole.initial.velocities[0]);
  return cut;
}

TEST(Equivalents, LayersThatStayTogetherRockAsOneBlock) {
  int events = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    testing::Draw draw(11000 + seed);
    const Cut cut = random_cut(draw);
    const SolveOptions options{.sample_times = regular_times(0.01, cut.whole.duration)};
    const History one = solve(cut.whole, options);
    const History layers = solve(cut.layers, options);
    const double end = first_event(cut.layers, layers, [](const Event& event) {
      return !std::all_of(event.to.contacts.begin() + 1, event.to.contacts.end(),
                          [](Contact contact) { return contact == Contact::closed; });
    });
    for (std::size_t i = 0; i < std::min(one.size(), layers.size()) && one.times[i] < end; ++i) {
      for (const double angle : layers.angles_at(i))
        ASSERT_NEAR(angle, one.angles_at(i)[0], alike) << seed << " at " << one.times[i];
    }
    for (std::size_t i = 0; i < layers.events.size() && layers.events[i].time < end; ++i) {
      ASSERT_NEAR(layers.events[i].time, one.events.at(i).time, alike) << seed;
      ASSERT_EQ(layers.events[i].kind, one.events[i].kind) << seed;
      ++events;
    }
  }
  EXPECT_GT(events, 100);
}

// A mass ratio of 1e-12, times the square of a ratio of sizes of up to 7, times a growth of e^(pt) with p up
// to 7/s: 1e-8, and tenfold for what impacts multiply.
TEST(Equivalents, AFeatherweightTopLeavesTheBaseAHousnerBlock) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    testing::Draw draw(11500 + seed);
    Scene stack = testing::random_scene(draw, 2, false);
    if (seed % 4 != 0) testing::shake(draw, stack);
    stack.blocks[1].mass = 1e-12 * stack.blocks[0].mass;
    const Block& top = stack.blocks[1];
    stack.blocks[1].inertia = rectangle_inertia(top.mass, top.half_width, top.half_height);
    Scene alone = stack;
    alone.blocks.pop_back();
    alone.initial.angles.pop_back();
    alone.initial.velocities.pop_back();
    const SolveOptions options{.sample_times = regular_times(0.01, stack.duration)};
    const History one = solve(alone, options);
    const History other = solve(stack, options);
    for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
      ASSERT_NEAR(other.angles_at(i)[0], one.angles_at(i)[0], 1e-7) << seed << " at " << one.times[i];
      ++compared;
    }
  }
  EXPECT_GT(compared, 10000);
}

}  // namespace
}  // namespace rockstack
