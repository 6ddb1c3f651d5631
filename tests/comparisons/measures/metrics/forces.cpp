// Forces of engines beside the exact ones: closed forms of impulses, and engines made by hand.

#include "comparisons/measures/metrics/forces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/metrics/contact.hpp"

namespace rockstack {
namespace {

constexpr double step = 1e-3;  // s

/// One block that lands at 0.68 s; nothing else happens by 1 s.
Scene rocking(Law law) {
  Scene scene;
  scene.law = law;
  scene.duration = 1;
  scene.blocks = {make_block(0.5, 2.5, 2500)};
  scene.initial = {{0.1}, {0}};
  return scene;
}

Scene paper() {
  Scene scene;
  scene.duration = 1;
  scene.blocks = {make_block(1.25, 1.25, 2500), make_block(1, 2.5, 2500)};
  scene.initial = {{0.15, 0.15}, {0, 0}};
  return scene;
}

History sampled_motion(const Scene& scene) {
  return solve(scene, {.sample_times = regular_times(step, scene.duration)});
}

/// What an engine without error tells: the mean of both ends of a step, and the impulses of its events.
std::vector<Reaction> step_means(const Scene& scene, const History& exact) {
  const std::vector<Reaction> at = reactions_of(scene, exact);
  const Stack<double> stack = make_stack<double>(scene);
  const auto blocks = static_cast<std::size_t>(exact.blocks);
  std::vector<Reaction> means(at.size());
  for (std::size_t i = blocks; i < at.size(); ++i)
    means[i] = {0.5 * (at[i - blocks].normal + at[i].normal),
                0.5 * (at[i - blocks].tangential + at[i].tangential)};
  for (const Event& event : exact.events) {
    if (event.kind != EventKind::impact && event.kind != EventKind::closure) continue;
    const auto sample = static_cast<std::size_t>(std::ceil(event.time / step));
    const Points<double> impulses = blow_of(stack, event).impulses;
    for (std::size_t k = 0; k < blocks; ++k) {
      const double angle = k == 0 ? 0 : event.angles[k - 1], c = std::cos(angle), s = std::sin(angle);
      const Point<double> impulse = impulses.col(static_cast<Eigen::Index>(k)) / step;
      means[sample * blocks + k].normal += s * impulse.x() + c * impulse.y();
      means[sample * blocks + k].tangential += c * impulse.x() - s * impulse.y();
    }
  }
  return means;
}

std::vector<AlignedImpact> matched(const Scene& scene, const History& exact, double late) {
  std::vector<AlignedImpact> list;
  for (const ImpactTime& impact : reported_impacts(scene, exact, chatter_speed(scene))) {
    const int number = static_cast<int>(list.size()) + 1;
    list.push_back({impact.interface, number, impact.time, impact.time + late});
  }
  return list;
}

// The corner that lands stops at once: about it, angular momentum stays, so that the centre's velocity turns
// from that about one corner to that about the other: from ω(−h, −b) to rω(−h, b), r = 1 − 3/2 sin² α.
TEST(Blow, OfARockingBlockIsTheChangeOfItsMomentum) {
  for (const Law law : {Law::consistent, Law::unilateral}) {
    const Scene scene = rocking(law);
    const History exact = sampled_motion(scene);
    ASSERT_EQ(exact.events.front().kind, EventKind::impact);
    const Event& event = exact.events.front();
    const Block& block = scene.blocks[0];
    const double speed = -event.before[0], slenderness = std::atan2(block.half_width, block.half_height);
    const double left = 1 - 1.5 * std::pow(std::sin(slenderness), 2);
    const Point<double> impulse = blow_of(make_stack<double>(scene), event).impulses.col(0);
    // Angles at impact are zero to rounding.
    const double rounding = 1e-9 * block.mass * speed * block.half_height;
    EXPECT_NEAR(impulse.x(), block.mass * speed * block.half_height * (1 - left), rounding);
    EXPECT_NEAR(impulse.y(), block.mass * speed * block.half_width * (1 + left), rounding);
  }
}

TEST(Forces, OfAnEngineWithoutErrorAreTheExactOnes) {
  for (const Scene& scene : {rocking(Law::consistent), rocking(Law::unilateral), paper()}) {
    const History exact = sampled_motion(scene);
    History engine = exact;
    engine.reactions = step_means(scene, exact);
    const auto [forces, impulses] = compare_forces(scene, exact, engine, matched(scene, exact, 0));
    EXPECT_EQ(forces.normal, 0);
    EXPECT_EQ(forces.tangential, 0);
    EXPECT_EQ(forces.peak, forces.exact_peak);
    ASSERT_FALSE(impulses.empty());
    for (const ImpactImpulse& one : impulses) {
      EXPECT_NEAR(one.engine.normal / one.exact.normal, 1, 1e-9) << one.number;
      EXPECT_NEAR(one.engine.tangential / one.exact.normal, one.exact.tangential / one.exact.normal, 1e-9);
    }
    EXPECT_LT(impulse_error(impulses).value(), 1e-9);
  }
}

// A tenth more of everything is a tenth of the forces, near the weight, and of the impulses; of what the
// weight gives in the window of an impact as well, which is at most 2 × 0.05 s for 1.25 m.
TEST(Forces, AreOffByWhatAnEngineAddsToThem) {
  const Scene scene = rocking(Law::consistent);
  const History exact = sampled_motion(scene);
  History engine = exact;
  engine.reactions = step_means(scene, exact);
  for (Reaction& reaction : engine.reactions) reaction.normal *= 1.1, reaction.tangential *= 1.1;
  const auto [forces, impulses] = compare_forces(scene, exact, engine, matched(scene, exact, 0));
  EXPECT_NEAR(forces.peak.value() / forces.exact_peak.value(), 1.1, 1e-12);
  EXPECT_NEAR(forces.normal.value(), 0.1, 0.01);  // N falls to 0.9 of the weight
  ASSERT_EQ(impulses.size(), 1U);
  const double weight = scene.blocks[0].mass * scene.gravity;
  const double more = impulses[0].engine.normal - 1.1 * impulses[0].exact.normal;
  EXPECT_GT(more, 0);
  EXPECT_LT(more, 0.1 * weight * 2 * settling_duration(scene));
}

// The exact forces are taken off as late as the engine's impact comes.
TEST(Forces, OfALateEngineHaveTheSameImpulses) {
  const Scene scene = rocking(Law::consistent);
  const History exact = sampled_motion(scene);
  constexpr std::size_t late = 7;  // steps
  History engine = exact;
  engine.reactions = step_means(scene, exact);
  engine.reactions.insert(engine.reactions.begin(), late, engine.reactions[1]);
  engine.reactions.resize(exact.size());
  const auto impulses = compare_forces(scene, exact, engine, matched(scene, exact, late * step)).impulses;
  ASSERT_EQ(impulses.size(), 1U);
  EXPECT_NEAR(impulses[0].engine.normal / impulses[0].exact.normal, 1, 1e-9);
}

}  // namespace
}  // namespace rockstack
