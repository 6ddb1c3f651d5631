#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "analytic/events/chatter.hpp"
#include "analytic/solve.hpp"
#include "analytic/solver/solver.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

constexpr double window = 1e-3;  // one step, s: chatter that has begun ends in far less

/// The share of its angular velocity that what is above an interface keeps as it falls back: for blocks that
/// move as one, 1 − 2mw²/I about the pivot, Housner 1963. The largest over all numbers of blocks.
double kept_at_most(const Scene& scene, std::size_t interface) {
  const double width = interface_half_width(scene, static_cast<int>(interface));
  double largest = 0;
  double mass = 0;
  double inertia = 0;
  double foot = 0;
  for (std::size_t k = interface; k < scene.blocks.size(); ++k) {
    const Block& block = scene.blocks[k];
    const double height = foot + block.half_height;
    mass += block.mass;
    inertia += block.inertia + block.mass * (width * width + height * height);
    foot += 2 * block.half_height;
    largest = std::max(largest, 1 - 2 * mass * width * width / inertia);
  }
  return largest;
}

double settling_speed(const Scene& scene) {
  double height = 0;
  for (const Block& block : scene.blocks) height += 2 * block.half_height;
  return 500 * std::numeric_limits<double>::epsilon() * std::sqrt(scene.gravity / height);
}

/// Impacts of one interface alone from a relative speed down to the settling speed.
double impacts_alone(const Scene& scene, std::size_t interface, double speed) {
  return std::log(std::max(1.0, speed / settling_speed(scene))) /
         std::log(1 / kept_at_most(scene, interface));
}

double relative_speed(const Event& event, std::size_t interface) {
  const double below = interface > 0 ? event.before[interface - 1] : 0;
  return std::abs(event.before[interface] - below);
}

/// Events that follow the first one within that time, and their bound.
struct Burst {
  std::size_t events = 0;
  double bound = 0;
};

Burst burst_from(const Scene& scene, const std::vector<Event>& events, std::size_t first) {
  std::vector<double> speeds(scene.blocks.size(), 0);
  std::set<std::size_t> interfaces;
  std::size_t last = first;
  for (; last < events.size() && events[last].time - events[first].time < window; ++last) {
    if (events[last].kind != EventKind::topple)
      interfaces.insert(static_cast<std::size_t>(events[last].interface - 1));
    for (std::size_t k = 0; k < speeds.size(); ++k)
      speeds[k] = std::max(speeds[k], relative_speed(events[last], k));
  }
  double bound = 2;
  for (const std::size_t k : interfaces) bound *= 1 + impacts_alone(scene, k, speeds[k]);
  return {last - first, bound};
}

// While several interfaces chatter, each may do so to its end between two impacts of another: at most the
// product of 1 + the impacts of each alone, times two, as an opening may follow an impact. Not proved, as an
// impact may speed up other interfaces; chatter ends
// before the settling speed where flights stay below rounding, so that bursts are shorter still.
TEST(Chatter, ABurstOfEventsStaysBelowTheProductOfWhatEachInterfaceTakesAlone) {
  std::size_t longest = 0;
  for (std::uint64_t seed = 1000; seed < 2000; ++seed) {
    testing::Draw draw(12000 + seed);
    Scene scene = testing::random_scene(draw, 2 + draw.below(3), false);
    if (seed % 2 == 1) testing::shake(draw, scene);
    const History history = solve(scene);
    for (std::size_t i = 0; i < history.events.size();) {
      const Burst burst = burst_from(scene, history.events, i);
      ASSERT_LE(static_cast<double>(burst.events), burst.bound) << seed << " at " << history.events[i].time;
      longest = std::max(longest, burst.events);
      i += burst.events;
    }
  }
  EXPECT_GT(longest, 200U) << "the draws must include nested chatter";
}

// The base of the paper's example chatters to rest by 0.964 s; a second later the angles must feel no more of
// how early the chatter was ended than the resolution.
TEST(Chatter, EndingItEarlyMovesTheMotionByLessThanTheResolution) {
  Scene scene = testing::paper_example();
  scene.duration = 2;
  const auto angles = [&](double resolution) {
    const SolveOptions options{.sample_times = {1.5, 2.0}, .resolution = resolution};
    return Solver<long double, 2>(scene, options).run().angles;
  };
  const auto exact = angles(1e-19);
  for (const double resolution : {1e-6, 1e-8, 1e-10, 1e-12}) {
    const auto ended = angles(resolution);
    for (std::size_t i = 0; i < exact.size(); ++i)
      EXPECT_NEAR(static_cast<double>(ended[i] - exact[i]), 0, resolution) << resolution;
    EXPECT_NE(ended[1], exact[1]) << resolution;
  }
}

// A base chatters under a rocking block. What is left out are terms of the next order, in proportion
// to u: over two decades of u the ratio keeps within u and the rounding of the error.
TEST(Chatter, EndingItAtASpeedMovesTheMotionByTheThirdPowerOfThat) {
  Scene scene = testing::paper_example();
  scene.duration = 1.2;
  const auto ended = [&](double resolution) {
    return Solver<long double, 2>(scene, {.sample_times = {1.2}, .resolution = resolution}).run();
  };
  const auto exact = ended(1e-19);
  std::vector<double> speeds, ratios;
  for (const double resolution : {1e-6, 1e-7, 1e-9}) {
    const auto history = ended(resolution);
    const auto closure = std::find_if(history.events.begin(), history.events.end(),
                                      [](const auto& event) { return event.kind == EventKind::closure; });
    ASSERT_NE(closure, history.events.end());
    speeds.push_back(std::abs(static_cast<double>(closure->before[0])));
    ratios.push_back(static_cast<double>(history.angles[1] - exact.angles[1]) / std::pow(speeds.back(), 3));
  }
  EXPECT_GT(speeds.front(), 30 * speeds.back());
  for (const double ratio : ratios) EXPECT_NEAR(ratio / ratios.back(), 1, 2 * speeds.front());
}

// A block that leaves the ground at a speed u ≤ √(2ρa), a = p² sin α, rises to θ with u²/2 = p² ∫₀^θ sin(α −
// s) ds ≥ p² θ sin(α − θ) ≥ p² θ (1 − θ/α) sin α, the sine being concave: to θ = α/2 (1 − √(1 − 4ρ/α)) at
// most.
TEST(Chatter, WhatIsLeftOutStaysBelowTheResolution) {
  for (const double slenderness : {0.1, 0.3, 0.6}) {
    for (const double resolution : {1e-3, 1e-4, 1e-5, 1e-7}) {
      const Scene scene =
          testing::released({testing::block(2 * std::tan(slenderness), 2)}, {0.7 * slenderness}, 60);
      const History ended = solve(scene, {.resolution = resolution});
      ASSERT_FALSE(ended.events.empty()) << slenderness << ' ' << resolution;
      ASSERT_EQ(ended.events.back().kind, EventKind::rest);
      // The rest stands for this impact, and is told where those that follow accumulate.
      const double impact = solve(scene).events[ended.events.size() - 1].time;
      std::vector<double> after = regular_times(1e-3, 1);
      for (double& time : after) time += impact;
      const History followed = solve(scene, {.sample_times = after});
      EXPECT_GT(followed.events.size(), ended.events.size());
      double most = 0;
      for (const double angle : followed.angles) most = std::max(most, std::abs(angle));
      EXPECT_GT(most, 0) << slenderness << ' ' << resolution;
      EXPECT_LE(most, slenderness / 2 * (1 - std::sqrt(1 - 4 * resolution / slenderness)))
          << slenderness << ' ' << resolution;
    }
  }
}

// What is left of chatter from a speed u on is summed up as flights of constant acceleration, which changes
// in them by the angle, a share of u²: the sum, itself in proportion to u, is off by u³. Without it the
// ratios would grow as 1/u².
TEST(Chatter, RestIsWhereItsImpactsAccumulateButForTheThirdPowerOfTheSpeed) {
  const Scene scene = testing::released({testing::block(0.5, 2.5)}, {0.1}, 60);
  const auto rest = [&](double resolution) { return solve(scene, {.resolution = resolution}).events.back(); };
  const Event last = rest(0);
  std::vector<double> ratios;
  for (const double resolution : {1e-5, 1e-7, 1e-9}) {
    const Event ended = rest(resolution);
    ASSERT_EQ(ended.kind, EventKind::rest);
    ratios.push_back((ended.time - last.time) / std::pow(std::abs(ended.before[0]), 3));
  }
  for (const double ratio : ratios) EXPECT_NEAR(ratio / ratios[0], 1, 0.02);
}

// Impulses of a uniform block that falls back on its other corner: T/N = 3bh/(b² + 4h²), from the speeds of
// its centre of mass about either corner. A closure stands for impacts that all ask for this.
TEST(Chatter, ItsEndAsksOfAnInterfaceWhatItsImpactsDo) {
  Scene scene;
  scene.duration = 20;
  scene.blocks = {make_block(0.6, 2.4, 2500)};
  scene.initial = {{0.5 * slenderness(scene, 0)}, {0}};
  constexpr double b = 0.3, h = 1.2;
  for (const double tolerance : {0.0, 1e-9, 1e-6, 1e-3}) {
    for (const EventsKept kept : {EventsKept::all, EventsKept::summed}) {
      const History history =
          solve(scene, {.events = kept, .validity = true, .resolution = tolerance, .tolerance = tolerance});
      EXPECT_EQ(history.events.back().kind, EventKind::rest);
      EXPECT_NEAR(history.impulses[0].friction, 3 * b * h / (b * b + 4 * h * h), 1e-12) << tolerance;
    }
  }
}

// Gauss's principle bounds accelerations of any stack, a pebble on a tower's top among them.
TEST(Chatter, NoRelativeAngleAcceleratesMoreThanTheBound) {
  testing::Draw draw(71);
  double largest_share = 0;
  for (int i = 0; i < 4000; ++i) {
    const int size = 1 + draw.below(5);
    Scene scene = testing::random_stack(draw, size);
    Block& top = scene.blocks.back();
    const double scale = draw.coin() ? 1 : std::pow(10, draw.between(-4, 0));
    top.half_width *= scale;
    top.half_height *= scale;
    top.inertia *= scale * scale;
    const auto model = make_model<double>(scene);
    const auto state = testing::random_state<double>(draw, size);
    const Point<double> ground{draw.between(-20, 20), draw.between(-8, 8)};
    const double bound = EndOfChatter<double, Eigen::Dynamic>(model, 1e-9).fastest_return(state, ground);
    const double found = accelerations(model, state, ground).cwiseAbs().maxCoeff();
    ASSERT_LE(found, bound) << name(state.pattern);
    largest_share = std::max(largest_share, found / bound);
  }
  EXPECT_GT(largest_share, 0.01) << "the draws must come near the bound";
}

}  // namespace
}  // namespace rockstack
