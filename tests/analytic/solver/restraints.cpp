#include <gtest/gtest.h>

#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

using testing::block;
using testing::released;

constexpr double earth_pull = 9.81;

/// A tendon along a block's middle, from its top to a depth below the ground.
Restraint tendon(const Block& own, double stiffness, double prestress, double depth = 0.5) {
  return {.from = {1, 0, 2 * own.half_height},
          .to = {0, 0, -depth},
          .stiffness = stiffness,
          .prestress = prestress};
}

double corner_inertia_of(const Block& own) {
  return own.inertia + own.mass * (own.half_width * own.half_width + own.half_height * own.half_height);
}

/// Length of a restraint of one block that turns about a corner, and its rate by the angle.
double length_of(const Block& own, const Restraint& restraint, double angle) {
  const double side = angle < 0 ? -own.half_width : own.half_width, c = std::cos(angle), s = std::sin(angle);
  const double x = restraint.from.x - side, y = restraint.from.y;
  return std::hypot(side + x * c + y * s - restraint.to.x, y * c - x * s - restraint.to.y);
}

/// Energy of a block and its tendon above rest, J.
double energy_of(const Scene& scene, double angle, double rate) {
  const Block& own = scene.blocks[0];
  const double radius = std::hypot(own.half_width, own.half_height),
               slim = std::atan2(own.half_width, own.half_height);
  double sum = corner_inertia_of(own) * rate * rate / 2 +
               own.mass * earth_pull * radius * (std::cos(slim - std::abs(angle)) - std::cos(slim));
  for (const Restraint& given : scene.restraints) {
    if (given.kind == RestraintKind::damper) continue;
    const double force = std::max(
        0.0, given.prestress + given.stiffness * (length_of(own, given, angle) - length_of(own, given, 0)));
    sum += (force * force - given.prestress * given.prestress) / (2 * given.stiffness);
  }
  return sum;
}

// Prestress T along the middle holds a block like weight: it lifts where F y = (m g + T) b.
TEST(Restraints, PrestressRaisesTheForceThatLifts) {
  const Block own = block(0.5, 2);
  for (const Law law : {Law::consistent, Law::unilateral}) {
    for (const double prestress : {0.0, 5e3, 4e4}) {
      Scene scene = released({own}, {0}, 0.2);
      scene.law = law;
      scene.restraints = {tendon(own, 1e6, prestress)};
      const double critical = (own.mass * earth_pull + prestress) * own.half_width;
      Push push{{1, 0, 1.0}, 0, {}};
      push.force.pulse = {
          .shape = PulseShape::rectangle, .amplitude = critical * (1 - 1e-10), .period = 10, .start = 0};
      scene.pushes = {push};
      EXPECT_TRUE(solve(scene).events.empty()) << prestress;
      scene.pushes[0].force.pulse->amplitude = critical * (1 + 1e-10);
      const History history = solve(scene);
      ASSERT_FALSE(history.events.empty()) << prestress;
      EXPECT_EQ(history.events[0].to[0], Contact::right);
    }
  }
}

// Energy of block, weight and tendon stays from impact to impact; an impact leaves the share of a free block.
TEST(Restraints, KeepEnergyBetweenImpacts) {
  for (const Law law : {Law::consistent, Law::unilateral}) {
    for (const double prestress : {0.0, 3e4}) {
      const Block own = block(0.5, 2);
      Scene scene = released({own}, {0.15}, 4);
      scene.law = law;
      scene.restraints = {tendon(own, 2e5, prestress)};
      double last = energy_of(scene, 0.15, 0);
      int impacts = 0;
      for (const Event& event : solve(scene).events) {
        if (event.kind != EventKind::impact) continue;
        if (++impacts > 8) break;
        EXPECT_NEAR(energy_of(scene, 0, event.before[0]) / last, 1, 1e-12);
        const double sine = std::sin(std::atan2(own.half_width, own.half_height));
        EXPECT_NEAR(event.after[0] / event.before[0], 1 - 1.5 * sine * sine, 1e-13);
        last = energy_of(scene, 0, event.after[0]);
      }
      EXPECT_GT(impacts, 3);
    }
  }
}

// M. F. Vassiliou, N. Makris, Dynamics of the vertically restrained rocking column, Journal of Engineering
// Mechanics 141 (2015) 04015049: about the corner the tendon's force P + k Δℓ acts at the lever of its line.
// The equation of motion in one angle by the classical step of fourth order.
TEST(Restraints, MoveAColumnAsItsEquationInOneAngleSays) {
  const Block own = block(0.6, 3);
  Scene scene = released({own}, {0.12}, 0.4);
  scene.restraints = {tendon(own, 5e5, 2e4, 0), tendon(own, 1e5, 0, 1)};
  scene.restraints[1].to.x = 2;
  scene.restraints.push_back(
      {.kind = RestraintKind::damper, .from = {1, -0.3, 0}, .to = {0, -0.3, -0.2}, .damping = 2e4});
  const auto torque = [&](double angle, double rate) {
    const double radius = std::hypot(own.half_width, own.half_height),
                 slim = std::atan2(own.half_width, own.half_height);
    double sum = -own.mass * earth_pull * radius * std::sin(slim - angle);
    for (const Restraint& given : scene.restraints) {
      const double h = 1e-4;
      const auto at = [&](double by) { return length_of(own, given, angle + by); };
      const double lever = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
      const double stretched = given.prestress + given.stiffness * (at(0) - length_of(own, given, 0));
      const double force =
          given.kind == RestraintKind::damper ? given.damping * lever * rate : std::max(0.0, stretched);
      sum -= force * lever;
    }
    return sum / corner_inertia_of(own);
  };
  const History history = solve(scene, {.sample_times = {0.05, 0.1, 0.15}});
  double angle = 0.12, rate = 0;
  const double h = 1e-4;
  for (int i = 0; i < 1500; ++i) {
    const double a1 = torque(angle, rate), a2 = torque(angle + h / 2 * rate, rate + h / 2 * a1);
    const double a3 = torque(angle + h / 2 * rate + h * h / 4 * a1, rate + h / 2 * a2);
    const double a4 = torque(angle + h * rate + h * h / 2 * a2, rate + h * a3);
    angle += h * rate + h * h / 6 * (a1 + a2 + a3);
    rate += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    if ((i + 1) % 500 == 0) {
      EXPECT_NEAR(history.angles[static_cast<std::size_t>(i / 500)], angle, 1e-10);
      EXPECT_NEAR(history.velocities[static_cast<std::size_t>(i / 500)], rate, 1e-9);
    }
  }
}

// What a damper takes is ∫ c ℓ̇² dt, by Simpson's rule over samples.
TEST(Restraints, DampersTakeTheirWork) {
  const Block own = block(0.5, 2);
  Scene scene = released({own}, {0.15}, 0.2);
  scene.restraints = {
      {.kind = RestraintKind::damper, .from = {1, -0.25, 0}, .to = {0, -0.25, -0.5}, .damping = 3e4}};
  constexpr int intervals = 2000;
  const History history = solve(scene, {.sample_times = regular_times(0.2 / intervals, 0.2)});
  ASSERT_TRUE(history.events.empty());
  double taken = 0;
  for (int i = 0; i <= intervals; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double h = 1e-5, angle = history.angles[at];
    const double lever =
        (length_of(own, scene.restraints[0], angle + h) - length_of(own, scene.restraints[0], angle - h)) /
        (2 * h);
    const double rate = lever * history.velocities[at];
    taken += (i == 0 || i == intervals ? 1 : i % 2 == 1 ? 4 : 2) * 3e4 * rate * rate * 0.2 / intervals / 3;
  }
  const double lost =
      energy_of(scene, 0.15, 0) - energy_of(scene, history.angles.back(), history.velocities.back());
  EXPECT_GT(taken, 5);
  EXPECT_NEAR(lost / taken, 1, 1e-8);
}

// A tendon that yields at Fy takes Fy times what it is drawn; unloaded by that it is slack before the block
// is back.
TEST(Restraints, YieldingTakesTheForceTimesTheLengthDrawn) {
  const Block own = block(0.5, 2);
  for (const Law law : {Law::consistent, Law::unilateral}) {
    Scene scene = released({own}, {0}, 2);
    scene.law = law;
    scene.initial.velocities = {0.9};
    Restraint given = tendon(own, 1e6, 1e4);
    given.yield = 3e4;
    scene.restraints = {given};
    const History history = solve(scene);
    const auto at = [&](EventKind kind) { return *std::ranges::find(history.events, kind, &Event::kind); };
    const Event yields = at(EventKind::yield), unloads = at(EventKind::unload), slack = at(EventKind::slack);
    const auto stretch = [&](const Event& event) {
      return length_of(own, given, event.angles[0]) - length_of(own, given, 0);
    };
    EXPECT_NEAR(stretch(yields), 0.02, 1e-13);
    EXPECT_NEAR(unloads.after[0], 0, 1e-12);
    const double drawn = stretch(unloads) - 0.02;
    EXPECT_GT(drawn, 0.005);
    EXPECT_NEAR(stretch(slack), drawn - 0.01, 1e-12);
    const Event landing = at(EventKind::impact);
    scene.restraints = {};
    const double start = energy_of(scene, 0, 0.9), end = energy_of(scene, 0, landing.before[0]);
    EXPECT_NEAR(start - end, 3e4 * drawn - 1e4 * 1e4 / 2e6, 1e-9 * start);
  }
}

// Free bodies and chains of pivots share no series: both lead stacks on tendons and dampers to the same
// places.
TEST(Restraints, LeadStacksAlikeByAllLaws) {
  testing::Draw draw(73);
  int moved = 0;
  for (int run = 0; run < 60; ++run) {
    const int size = 1 + run % 3;
    Scene scene = testing::random_stack(draw, size);
    const double unit = std::sqrt(stack_height(scene) / earth_pull);
    scene.duration = 0.5 * unit;
    scene.initial.angles.assign(scene.blocks.size(), 0.1 * slenderness(scene, 0) * draw.between(-1, 1));
    scene.initial.velocities.assign(scene.blocks.size(), 0.0);
    double mass = 0;
    for (const Block& own : scene.blocks) mass += own.mass;
    for (int count = 1 + draw.below(2); count > 0; --count) {
      Restraint& given = scene.restraints.emplace_back();
      given.kind = draw.coin() ? RestraintKind::tendon : RestraintKind::damper;
      given.from = {size, draw.between(-0.5, 0.5) * scene.blocks.back().half_width,
                    draw.between(0, 2) * scene.blocks.back().half_height};
      given.to = {draw.below(size), draw.between(-1, 1), draw.between(-1, 0)};
      if (given.kind == RestraintKind::damper) {
        given.damping = draw.between(0.1, 1) * mass / unit;
        continue;
      }
      given.stiffness = draw.between(1, 50) * mass * earth_pull / stack_height(scene);
      given.prestress = draw.between(0, 0.5) * mass * earth_pull;
      given.yield = given.prestress + draw.between(0.001, 0.1) * mass * earth_pull;
    }
    const auto end = [&](Law law) {
      scene.law = law;
      return solve(scene, {.sample_times = {scene.duration}, .validity = law == Law::consistent});
    };
    const History pivots = end(Law::consistent);
    bool holds = true;
    for (const Demand& demand : pivots.forces)
      holds = holds && demand.least_normal > 0 && demand.friction < 500;
    for (const Event& event : pivots.events)
      holds = holds && event.consistency == Consistency::consistent && !ends_motion(event.kind);
    if (!holds || pivots.times.empty()) continue;
    ++moved;
    const History free = end(Law::unilateral);
    ASSERT_EQ(free.times.size(), pivots.times.size()) << run;
    for (std::size_t k = 0; k < scene.blocks.size(); ++k)
      EXPECT_NEAR(free.angles[k], pivots.angles[k], 1e-9)
          << run << "\n"
          << testing::listing(pivots) << testing::listing(free);
  }
  EXPECT_GT(moved, 25);
}

}  // namespace
}  // namespace rockstack
