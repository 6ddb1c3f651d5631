// Points that bounce by Poisson's law, against closed forms and time steps, and beside Newton's.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analytic/solve.hpp"
#include "tests/analytic/unilateral/bouncing.hpp"
#include "tests/analytic/unilateral/time_stepping.hpp"

namespace rockstack {
namespace {

using testing::bouncing;
using testing::dropped;
using testing::gains;
using testing::LowCorner;
using testing::random_bounces;

constexpr double tight = 1e-10;

Scene by_poisson(Scene scene) {
  scene.restitution_law = RestitutionLaw::poisson;
  return scene;
}

void expect_near(const Pose<>& found, const Pose<>& expected, double within) {
  EXPECT_NEAR(found.x, expected.x, within);
  EXPECT_NEAR(found.y, expected.y, within);
  EXPECT_NEAR(found.angle, expected.angle, within);
}

// Two corners that fall alike take half of the momentum each, and give back e of it: falls of t₀, 2 e t₀, …
TEST(Poisson, ADroppedBlockBouncesInAGeometricSeries) {
  const double height = 0.3, fall = std::sqrt(2 * height / 9.81);
  for (const double e : {0.2, 0.5, 0.8, 0.95}) {
    const double end = fall * (1 + e) / (1 - e);
    const History history = solve_unilateral(by_poisson(dropped(e, height, end + 0.1)));
    EXPECT_NEAR(bodies_after(history.events[0]).velocity[0].y, e * 9.81 * fall, tight);
    EXPECT_EQ(history.events.back().kind, EventKind::rest) << e;
    EXPECT_NEAR(history.events.back().time, end, tight) << e;
  }
}

// Each point of one block keeps e of its speed by either law where nothing rubs; on a corner all turns alike.
TEST(Poisson, OfOneCornerWithoutFrictionIsNewtons) {
  for (const double angle : {0.3, -0.6, 1.0}) {
    Scene scene = dropped(0.7, 0.2, 1, 0);
    scene.initial.angles = {angle};
    const History newton = solve_unilateral(scene);
    const History poisson = solve_unilateral(by_poisson(scene));
    ASSERT_EQ(newton.events.size(), poisson.events.size());
    for (std::size_t i = 0; i < std::min<std::size_t>(newton.events.size(), 3); ++i) {
      EXPECT_NEAR(newton.events[i].time, poisson.events[i].time, tight) << angle << ' ' << i;
      expect_near(bodies_after(poisson.events[i]).velocity[0], bodies_after(newton.events[i]).velocity[0],
                  tight);
    }
  }
}

TEST(Poisson, ACornerThatRubsIsThatByHandAndOftenNotNewtons) {
  int differ = 0;
  for (const double angle : {0.2, -0.4, 0.9}) {
    for (const double friction : {0.0, 0.05, 0.3, 10.0}) {
      for (const double along : {0.0, -2.0, 2.0}) {
        Scene scene = by_poisson(dropped(0.7, 0.2, 0.4, friction));
        scene.initial.angles = {angle};
        scene.initial.velocities = {0.5};
        scene.initial.slip_velocities = {along};
        const Event impact = solve_unilateral(scene).events.at(0);
        SCOPED_TRACE(::testing::Message() << angle << ' ' << friction << ' ' << along);
        const LowCorner corner(scene.blocks[0], impact.angles[0]);
        const Pose<> before = bodies_before(impact).velocity[0];
        const Pose<> expected = corner.after(before, corner.poisson(before, 0.7, friction));
        expect_near(bodies_after(impact).velocity[0], expected, tight);
        if (std::abs(corner.up(expected) + 0.7 * corner.up(before)) > 0.01) ++differ;
      }
    }
  }
  EXPECT_GE(differ, 6);
}

// A rod whose corner slides into its impact, and that friction turns back (Kane & Levinson 1985): Newton's
// law asks for e of the speed, whatever friction adds to it, and gains. Poisson's loses.
TEST(Poisson, ARodThatFrictionTurnsBackGainsEnergyByNewtonsLawAlone) {
  for (const double e : {0.9, 1.0}) {
    Scene scene = bouncing(testing::single(0.5, 0.01, 0.21), e, 0.3);
    scene.initial = {{0.9}, {0}};
    scene.initial.gaps = {0.2};
    scene.initial.slip_velocities = {-1.4};
    const Event newton = solve_unilateral(scene).events.at(0);
    const Event poisson = solve_unilateral(by_poisson(scene)).events.at(0);
    const LowCorner corner(scene.blocks[0], newton.angles[0]);
    const Pose<> before = bodies_before(newton).velocity[0];
    const auto gained = [&](const LowCorner::Impulse& impulse) {  // impulses times mean speeds
      const Pose<> after = corner.after(before, impulse);
      return (impulse.normal * (corner.up(before) + corner.up(after)) +
              impulse.along * (corner.along(before) + corner.along(after))) /
             2;
    };
    const auto found = [&](const Event& event) {
      return energy(scene, bodies_after(event)) - energy(scene, bodies_before(event));
    };
    const double by_newton = gained(corner.newton(before, e, 0.3));
    const double by_poisson = gained(corner.poisson(before, e, 0.3));
    EXPECT_NEAR(found(newton), by_newton, tight * energy(scene, bodies_before(newton)));
    EXPECT_NEAR(found(poisson), by_poisson, tight * energy(scene, bodies_before(newton)));
    EXPECT_GT(by_newton, 0) << e;
    EXPECT_LT(by_poisson, 0) << e;
    EXPECT_EQ(newton.consistency, Consistency::gains);
    EXPECT_EQ(poisson.consistency, Consistency::consistent);
  }
}

TEST(Poisson, EnergyNeverGrows) {
  std::size_t impacts = 0;
  for (const bool rubs : {false, true}) {
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
      const Scene scene = by_poisson(random_bounces(seed, rubs));
      for (const Event& event : solve_unilateral(scene).events) {
        if (event.kind == EventKind::impact) ++impacts;
        EXPECT_FALSE(gains(scene, event)) << seed << ' ' << event.time;
        EXPECT_NE(event.consistency, Consistency::gains) << seed << ' ' << event.time;
      }
    }
  }
  EXPECT_GT(impacts, 1000U);
}

// As under Newton's law, for as long as impacts are so few that steps of this size follow them. A contact
// that lasts hops by e g dt² in each step.
TEST(Poisson, StacksMoveAsTimeStepsDo) {
  const double step = 1e-5;
  std::size_t impacts = 0, differ = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    Scene scene = by_poisson(random_bounces(seed, true));
    scene.duration = 0.26;
    scene.initial.slip_velocities.assign(scene.blocks.size(), seed % 2 == 0 ? 1 : -1);
    const History exact = solve_unilateral(scene);
    SCOPED_TRACE(seed);
    impacts += testing::expect_as_stepped(scene, exact, step);
    scene.restitution_law = RestitutionLaw::newton;
    const Pose<> other = bodies_at_end(solve_unilateral(scene)).pose[0];
    if (std::abs(other.angle - bodies_at_end(exact).pose[0].angle) > 1000 * step) ++differ;
  }
  EXPECT_GT(impacts, 30U);
  EXPECT_GT(differ, 5U);
}

/// The events up to a time of two scenes of which one is the other in a mirror, or of another size.
template <class Compare>
void expect_alike(const Scene& first, const Scene& second, double until, const Compare& compare) {
  const History a = solve_unilateral(first), b = solve_unilateral(second);
  std::size_t events = 0;
  while (events < std::min(a.events.size(), b.events.size()) && a.events[events].time < until) {
    compare(a.events[events], b.events[events]);
    ++events;
  }
  EXPECT_GT(events, 1U);
}

/// Rates after an event are those of another one by some factors.
void expect_after(const Event& found, const Event& expected, const Pose<>& factors) {
  const Poses<> rates = bodies_after(found).velocity, others = bodies_after(expected).velocity;
  for (std::size_t k = 0; k < rates.size(); ++k)
    expect_near(rates[k], {factors.x * others[k].x, factors.y * others[k].y, factors.angle * others[k].angle},
                1e-8);
}

// Two blocks chatter at both interfaces: what is held at the lower one gives the upper one its speed back, so
// that bounces of some 10⁻⁷ m/s, thousands within a thousandth of √(H/g), would not end by themselves.
TEST(Poisson, BouncesThatFeedEachOtherEnd) {
  Scene scene = bouncing(
      testing::released({make_block(1.35, 0.81, 2500), make_block(0.92, 1.1, 2500)}, {-0.029, 0.005}, 0.4),
      0.73, 0);
  scene.restitution_law = RestitutionLaw::poisson;
  scene.friction = {0.84, 1};
  scene.initial.offsets = {0, 0.08};
  const History history = solve_unilateral(scene);
  EXPECT_FALSE(ends_early(history));
  EXPECT_LT(history.events.size(), 50'000U);
}

TEST(Poisson, MirrorsAndSizesChangeNothing) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = by_poisson(random_bounces(seed, true));
    Scene mirrored = scene, grown = scene;
    for (std::vector<double>* values : {&mirrored.initial.angles, &mirrored.initial.velocities})
      for (double& value : *values) value = -value;
    expect_alike(scene, mirrored, 0.3, [](const auto& one, const auto& other) {
      EXPECT_NEAR(one.time, other.time, tight);
      expect_after(other, one, {-1, 1, -1});
    });
    // Four times as long takes twice as long.
    grown.duration *= 2;
    for (Block& block : grown.blocks) {
      block.half_width *= 4;
      block.half_height *= 4;
      block.inertia *= 16;
    }
    for (double& gap : grown.initial.gaps) gap *= 4;
    for (double& velocity : grown.initial.velocities) velocity /= 2;
    expect_alike(scene, grown, 0.3, [](const auto& one, const auto& other) {
      EXPECT_NEAR(2 * one.time, other.time, tight);
      expect_after(other, one, {2, 2, 0.5});
    });
  }
}

}  // namespace
}  // namespace rockstack
