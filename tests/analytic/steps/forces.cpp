#include <gtest/gtest.h>

#include <cmath>

#include "analytic/solver/validity.hpp"
#include "analytic/steps/taylor_step.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

using testing::Draw;

// The series of forces belongs to the same motion as the angles: at any place in the step it must give what
// the accelerations there call for. Mass ratios of 10³ lose up to five digits of sixteen in a Cholesky
// factor, and heavy blocks above light ones pass on forces up to 10³ times what moves them.
TEST(Forces, AlongAStepAreThoseThatTheAccelerationsCallFor) {
  Draw draw(31);
  SolveOptions options;
  options.validity = true;
  for (int i = 0; i < 2000; ++i) {
    const int size = 1 + draw.below(4);
    Scene scene = testing::random_stack(draw, size);
    scene.equations = draw.below(3) == 0 ? Equations::linear : Equations::nonlinear;
    const auto model = make_model<double>(scene);
    const auto state = testing::random_state<double>(draw, size);
    const GroundPiece<double> piece{0,
                                    0.01,
                                    {0.01, draw.between(-20, 20), draw.between(-900, 900)},
                                    {0.01, draw.between(-8, 8), draw.between(-300, 300)}};
    TaylorSteps<double, Eigen::Dynamic> steps(model, options);
    const auto output = steps(state, directions_at(model, state.angles),
                              make_linkage(model.stack, state.pattern), piece, 0, 0.01, {});
    for (const double s : {0.0, 0.37, 1.0}) {
      const auto expected = accelerate(model, output.at(s), piece.at(s * output.length)).reactions;
      const double scale = 1e-8 * (1 + std::max(expected.normal.cwiseAbs().maxCoeff(),
                                                expected.tangential.cwiseAbs().maxCoeff()));
      for (int k = 0; k < size; ++k) {
        const auto& force = output.forces[static_cast<std::size_t>(k)];
        ASSERT_NEAR(value(force.normal, s), expected.normal[k], scale) << name(state.pattern) << " at " << s;
        ASSERT_NEAR(value(force.tangential, s), expected.tangential[k], scale);
      }
    }
  }
}

// A demand is met somewhere in the step, and nowhere in a scan of it is there a greater one. Rounding of
// forces is set at 1e-12 of the weight; a ratio with a normal force of 1e-3 of it is known to 2e-9 of itself.
TEST(Forces, DemandsAlongAStepAreTheGreatestOfAScanAndAreMet) {
  Draw draw(32);
  const SolveOptions options{.validity = true};
  for (int i = 0; i < 2000; ++i) {
    const int size = 1 + draw.below(3);
    const Scene scene = testing::random_stack(draw, size);
    const auto model = make_model<double>(scene);
    const auto state = testing::random_state<double>(draw, size);
    const GroundPiece<double> piece{0,
                                    0.1,
                                    {0.1, draw.between(-8, 8), draw.between(-90, 90)},
                                    {0.1, draw.between(-4, 4), draw.between(-30, 30)}};
    TaylorSteps<double, Eigen::Dynamic> steps(model, options);
    const auto output = steps(state, directions_at(model, state.angles),
                              make_linkage(model.stack, state.pattern), piece, 0, 0.1, {});
    const double weight = model.gravity * model.stack.mass.sum();
    const double end = draw.between(0.1, 1);
    for (const ForcePolynomials<double>& force : output.forces) {
      if (force.normal.terms == 0) continue;
      Demand found, scanned;
      note_demand_along(found, force, end, 1e-12 * weight, 1e3, 0.0, output.length);
      for (int j = 0; j <= 500; ++j) {
        const double s = end * j / 500;
        note_demand(scanned, value(force.normal, s), value(force.tangential, s), 1e-12 * weight, s);
      }
      EXPECT_LE(found.least_normal, scanned.least_normal + 3e-12 * weight);
      const auto normal = [&](double time) { return value(force.normal, time / output.length); };
      EXPECT_NEAR(normal(found.least_normal_time), found.least_normal, 1e-12 * weight);
      if (scanned.least_normal <= 1e-3 * weight) continue;
      EXPECT_GE(found.friction, scanned.friction * (1 - 1e-8));
      const double tangential = value(force.tangential, found.friction_time / output.length);
      EXPECT_NEAR(std::abs(tangential) / normal(found.friction_time), found.friction, 1e-8 * found.friction);
    }
  }
}

// Forces follow from the motion and do not act back on it in a single bit.
TEST(Forces, TellingThemChangesNoEvent) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Draw draw(3100 + seed);
    const Scene scene = testing::random_scene(draw, 1 + draw.below(3), seed % 2 == 1);
    const History silent = solve(scene);
    const History telling = solve(scene, {.validity = true, .peaks = true});
    ASSERT_EQ(telling.events.size(), silent.events.size()) << "seed " << seed;
    for (std::size_t i = 0; i < silent.events.size(); ++i) {
      ASSERT_EQ(telling.events[i].time, silent.events[i].time) << "seed " << seed;
      ASSERT_EQ(telling.events[i].after, silent.events[i].after) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace rockstack
