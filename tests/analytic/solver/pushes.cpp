#include <gtest/gtest.h>

#include <numbers>

#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

using testing::block;
using testing::released;

constexpr double half_turn = std::numbers::pi;

Push steady_push(double force, double height, double direction = 0, double from = 0, double to = 100) {
  Push push{{1, 0, height}, direction, {}};
  push.force.pulse = {.shape = PulseShape::rectangle, .amplitude = force, .period = to - from, .start = from};
  return push;
}

Push impulse_of(double impulse, double height, double time, int on = 1) {
  Push push{{on, 0, height}, 0, {}};
  push.force.steps = {{time, impulse}};
  return push;
}

/// Moment of inertia of a block about a lower corner, kg·m².
double corner_inertia(const Block& own) {
  return own.inertia + own.mass * (own.half_width * own.half_width + own.half_height * own.half_height);
}

double slim_ratio(const Block& own) {
  const double sine = own.half_width / std::hypot(own.half_width, own.half_height);
  return 1 - 1.5 * sine * sine;
}

// A block lifts where the push's moment about a corner exceeds that of its weight: F y = m g b.
TEST(Pushes, LiftABlockThatTheyOutweigh) {
  const Block own = block(0.5, 2);
  const double critical = own.mass * 9.81 * own.half_width / 1.5;
  for (const double side : {1.0, -1.0}) {
    Scene scene = released({own}, {0}, 0.5);
    scene.pushes = {steady_push(side * critical * (1 - 1e-12), 1.5)};
    EXPECT_TRUE(solve(scene).events.empty());
    scene.pushes = {steady_push(side * critical * (1 + 1e-12), 1.5)};
    EXPECT_EQ(solve(scene).events.at(0).to[0], contact_of(static_cast<int>(side)));
  }
}

// With geometry frozen upright I₀θ̈ = F y − m g b: a parabola, and after the push has ended another one.
TEST(Pushes, AccelerateABlockOfFrozenGeometryEvenly) {
  const Block own = block(0.5, 2);
  const double weight = own.mass * 9.81 * own.half_width, inertia = corner_inertia(own), end = 0.3;
  Scene scene = released({own}, {0}, 1);
  scene.equations = Equations::linear;
  scene.pushes = {steady_push(1.5 * weight / 1.2, 1.2, 0, 0, end)};
  const History history = solve(scene, {.sample_times = {0.2, end, 0.4}});
  const double up = 0.5 * weight / inertia, down = weight / inertia;
  EXPECT_NEAR(history.angles[0], up * 0.02, 1e-15);
  EXPECT_NEAR(history.angles[2], up * end * end / 2 + up * end * 0.1 - down * 0.005, 1e-15);
  const double landing = end + (up + std::sqrt(up * up + down * up)) / down * end;
  EXPECT_NEAR(history.events.at(1).time, landing, 1e-13);
}

// A push that does not change is a conservative force: with the work that it does, energy stays.
TEST(Pushes, PutInWhatTheyDo) {
  testing::Draw draw(70);
  for (int run = 0; run < 40; ++run) {
    Scene scene = testing::random_stack(draw, 1 + run % 3);
    const Model<double> model = make_model<double>(scene);
    scene.duration = 0.5;
    scene.initial.angles.assign(scene.blocks.size(), 0.0);
    scene.initial.velocities.assign(scene.blocks.size(), 0.0);
    scene.initial.angles.back() = 0.05;
    const int on = 1 + draw.below(static_cast<int>(scene.blocks.size()));
    const Block& pushed = scene.blocks[static_cast<std::size_t>(on) - 1];
    Push push = steady_push(draw.between(-0.5, 0.5) * pushed.mass * 9.81,
                            draw.between(0, 2) * pushed.half_height, draw.between(-half_turn, half_turn));
    push.point.block = on;
    scene.pushes = {push};
    const auto excess = [&](const Pattern& pattern, const std::vector<double>& angles,
                            const std::vector<double>& rates) {
      const Chain<double> chain = make_chain(model.stack, pattern, vector_of<double>(angles));
      Point<double> place = chain.foot;
      for (int k = 0; k + 1 < on; ++k) place += chain.links.col(k);
      const PushPoint<double> point = push_points<double>(scene)[0];
      const double angle = angles[static_cast<std::size_t>(on) - 1];
      place += chain.arms.col(on - 1) +
               turned<double>(point.arm.x(), point.arm.y(), std::cos(angle), std::sin(angle));
      return testing::energy_above_rest<double>(scene, pattern, angles, rates) -
             push.force.pulse->amplitude * point.direction.dot(place);
    };
    double last = std::numeric_limits<double>::quiet_NaN();
    for (const Event& event : solve(scene).events) {
      const double size = event.angles.empty() ? 0 : model.stack.mass.sum() * 9.81 * stack_height(scene);
      const double before = excess(event.from, event.angles, event.before);
      const double after = excess(event.to, event.angles, event.after);
      if (!std::isnan(last)) {
        EXPECT_NEAR(before, last, 1e-13 * size) << run << " " << name(event.kind);
      }
      EXPECT_LE(after, before + 1e-13 * size) << run;
      last = after;
    }
  }
}

// An impulse gives a block the angular momentum that it has about the corner: I₀ω = P y.
TEST(Impulses, TurnABlockAboutTheCornerAhead) {
  const Block own = block(0.5, 2);
  for (const Law law : {Law::paper, Law::consistent, Law::unilateral}) {
    for (const double impulse : {300.0, -300.0}) {
      Scene scene = released({own}, {0}, 0.1);
      scene.law = law;
      scene.pushes = {impulse_of(impulse, 1.5, 0.05)};
      const Event event = solve(scene).events.at(0);
      EXPECT_EQ(event.kind, EventKind::impulse);
      EXPECT_EQ(event.time, 0.05);
      EXPECT_EQ(event.to[0], contact_of(impulse > 0 ? 1 : -1));
      EXPECT_NEAR(event.after[0], impulse * 1.5 / corner_inertia(own), 1e-15);
    }
  }
}

// An impulse at 0 against a force that has opened the block to the other side: the motion is that of a block
// let go with the rate which the impulse gives, and the force bends it from the first instant on.
TEST(Impulses, AgainstAnOpeningLeaveTheMotionOfABlockLetGoWithTheirRates) {
  const Block own = block(0.5, 2);
  for (const Integrator integrator : {Integrator::taylor, Integrator::rk4}) {
    Scene scene = released({own}, {0}, 0.05);
    const double lifts = own.mass * scene.gravity * own.half_width;  // force at 1 m, N
    const double impulse = 0.3 * own.mass;
    scene.pushes = {steady_push(-1.2 * lifts, 1)};
    scene.pushes[0].force.steps = {{0, impulse}};
    const SolveOptions options{.integrator = integrator, .sample_times = {0.05}, .step = 1e-4};
    const History kicked = solve(scene, options);
    ASSERT_EQ(kicked.events.front().kind, EventKind::opening);
    scene.pushes[0].force.steps.clear();
    scene.initial.velocities = {impulse / corner_inertia(own)};
    const History let_go = solve(scene, options);
    EXPECT_NEAR(kicked.angles[0], let_go.angles[0], 1e-15);
    EXPECT_NEAR(kicked.velocities[0], let_go.velocities[0], 1e-14);
  }
}

// A step of the ground's velocity is an impulse on all masses, the other way: I₀ω = −m h V, whatever the
// equations.
TEST(Impulses, OfTheGroundActOnAllMasses) {
  const Block own = block(0.5, 2);
  for (const Equations equations : {Equations::nonlinear, Equations::linear, Equations::small_angle}) {
    Scene scene = released({own}, {0}, 0.1);
    scene.equations = equations;
    scene.horizontal.steps = {{0, 0.2}};
    const Event event = solve(scene).events.at(0);
    EXPECT_NEAR(event.after[0], -own.mass * own.half_height * 0.2 / corner_inertia(own), 1e-15);
  }
}

// Laws of pivots and free bodies, which share no code for it, find the same after impulses at rest and in
// motion, where friction holds.
TEST(Impulses, LeadToOnePatternByAllLaws) {
  testing::Draw draw(71);
  int opened = 0;
  for (int run = 0; run < 60; ++run) {
    Scene scene = testing::random_stack(draw, 1 + run % 3);
    scene.duration = 0.2;
    scene.initial.angles.assign(scene.blocks.size(), run % 2 == 0 ? 0.0 : 0.03);
    scene.initial.velocities.assign(scene.blocks.size(), 0.0);
    const int on = 1 + draw.below(static_cast<int>(scene.blocks.size()));
    const Block& pushed = scene.blocks[static_cast<std::size_t>(on) - 1];
    scene.pushes = {
        impulse_of(draw.between(-0.1, 0.1) * pushed.mass, draw.between(0, 2) * pushed.half_height, 0.01, on)};
    scene.pushes[0].direction = draw.between(-1.2, 0.1);
    const auto kick = [&](Law law) {
      scene.law = law;
      const History history = solve(scene);
      return *std::ranges::find(history.events, EventKind::impulse, &Event::kind);
    };
    const Event pivots = kick(Law::consistent), free = kick(Law::unilateral);
    if (pivots.consistency != Consistency::consistent) continue;  // it would lift
    opened += pivots.from == pivots.to ? 0 : 1;
    ASSERT_EQ(name(pivots.to), name(free.to)) << run;
    for (std::size_t k = 0; k < scene.blocks.size(); ++k)
      EXPECT_NEAR(pivots.after[k], free.after[k], 1e-12) << run;
  }
  EXPECT_GT(opened, 10);
}

/// The least double impulse, V and −V, that topples a block of slenderness α where the second acts just after
/// the first impact, by conservation of momentum and energy: with ω = 3 V cos α/(4R) and r = 1 − (3/2) sin²α,
/// (1 + r)² ω² I₀/2 = m g R (1 − cos α).
double critical_amplitude(const Block& own) {
  const double radius = std::hypot(own.half_width, own.half_height);
  const double cosine = own.half_height / radius;
  return 4 * radius / (3 * cosine * (1 + slim_ratio(own))) * std::sqrt(1.5 * 9.81 * (1 - cosine) / radius);
}

// K. Nabeshima, R. Taniguchi, K. Kojima, I. Takewaki, Closed-form overturning limit of rigid block under
// critical near-fault ground motions, Frontiers in Built Environment 2 (2016) 9.
TEST(Impulses, TopplePublishedBlockAtTheCriticalAmplitude) {
  const Block own = block(0.2, 1);
  const auto topples = [&](double amplitude) {
    Scene scene = released({own}, {0}, 30);
    scene.horizontal.steps = {{0, amplitude}};
    const double impact = solve(scene).events.at(1).time;
    scene.horizontal.steps.push_back({impact, -amplitude});
    return solve(scene).events.back().kind == EventKind::topple;
  };
  double low = 0.2, high = 0.3;
  while (high - low > 1e-13) (topples((low + high) / 2) ? high : low) = (low + high) / 2;
  EXPECT_NEAR(low, critical_amplitude(own), 1e-12);
  EXPECT_NEAR(low, 0.267225503, 1e-9);
}

}  // namespace
}  // namespace rockstack
