#include <gtest/gtest.h>

#include "analytic/mechanics/pattern_solution.hpp"
#include "tests/analytic/mechanics/maximal.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

using testing::Draw;
using testing::Number;

State<Number> widened(const State<double>& state) {
  return {state.pattern, state.angles.cast<Number>(), state.velocities.cast<Number>()};
}

// Mass ratios of 10³ and six blocks' lengths lose up to five digits of sixteen in a Cholesky factor.
constexpr double digits_lost = 1e-11;

TEST(Dynamics, AccelerationsAreThoseOfConstraintForcesInMaximalCoordinates) {
  Draw draw(11);
  for (int i = 0; i < 4000; ++i) {
    const int size = 1 + draw.below(5);
    Scene scene = testing::random_stack(draw, size);
    scene.equations = draw.below(3) == 0 ? Equations::linear : Equations::nonlinear;
    const auto state = testing::random_state<double>(draw, size);
    const Point<double> ground{draw.between(-20, 20), draw.between(-8, 8)};
    const auto found = accelerations(make_model<double>(scene), state, ground);
    const auto expected =
        testing::accelerate(make_model<Number>(scene), widened(state), ground.cast<Number>());
    const double scale = 1 + static_cast<double>(expected.relative.cwiseAbs().maxCoeff());
    for (int k = 0; k < size; ++k) {
      ASSERT_NEAR(found[k], static_cast<double>(expected.relative[k]), digits_lost * scale)
          << name(state.pattern);
    }
  }
}

TEST(Dynamics, ReactionsAreTheConstraintForces) {
  Draw draw(12);
  for (int i = 0; i < 4000; ++i) {
    const int size = 1 + draw.below(5);
    Scene scene = testing::random_stack(draw, size);
    scene.equations = draw.below(3) == 0 ? Equations::linear : Equations::nonlinear;
    const auto model = make_model<double>(scene);
    const auto state = testing::random_state<double>(draw, size);
    const Point<double> ground{draw.between(-20, 20), draw.between(-8, 8)};
    const auto found = accelerate(model, state, ground).reactions;
    const auto expected =
        testing::accelerate(make_model<Number>(scene), widened(state), ground.cast<Number>());
    const Vector<double> tilts = absolute(state.angles);
    for (int k = 0; k < size; ++k) {
      const int face = model.stack.overhangs[static_cast<std::size_t>(k)] ? k : k - 1;
      const double tilt = scene.equations == Equations::linear || face < 0 ? 0 : tilts[face];
      const Point<double> force = expected.force.col(k).cast<double>();
      const Point<double> normal{std::sin(tilt), std::cos(tilt)};
      const Point<double> along{std::cos(tilt), -std::sin(tilt)};
      const double scale = 1e3 * digits_lost * (1 + expected.force.cwiseAbs().maxCoeff());
      ASSERT_NEAR(found.normal[k], normal.dot(force), scale);
      ASSERT_NEAR(found.tangential[k], along.dot(force), scale);
      ASSERT_NEAR(found.moment[k], static_cast<double>(expected.moment[k]), 10 * scale);
    }
  }
}

TEST(Dynamics, TheGroundCarriesTheRateOfMomentum) {
  Draw draw(13);
  for (int i = 0; i < 500; ++i) {
    const int size = 1 + draw.below(5);
    const Scene scene = testing::random_stack(draw, size);
    const auto model = make_model<double>(scene);
    const Point<double> ground{draw.between(-20, 20), draw.between(-8, 8)};
    const auto state = testing::random_state<double>(draw, size);
    const auto found = accelerate(model, state, ground).reactions;
    const auto motion =
        testing::accelerate(make_model<Number>(scene), widened(state), ground.cast<Number>()).motion;
    Point<double> sum{0, 0};
    double weight = 0;
    for (int k = 0; k < size; ++k) {
      const double mass = model.stack.mass[k];
      weight += mass * 9.81;
      sum += mass *
             (motion.segment<2>(testing::row(k)).cast<double>() + ground + Point<double>(0, model.gravity));
    }
    EXPECT_NEAR(found.tangential[0], sum.x(), 1e-9 * (weight + sum.norm()));
    EXPECT_NEAR(found.normal[0], sum.y(), 1e-9 * (weight + sum.norm()));
  }
}

// Energy along φ + φ̇t + φ̈t²/2, differenced over ±t: error t² times third derivatives, 1e-10 × 1e3 here.
TEST(Dynamics, EnergyChangesByThePowerOfTheGround) {
  Draw draw(14);
  for (int i = 0; i < 1000; ++i) {
    const int size = 1 + draw.below(5);
    const Scene scene = testing::random_stack(draw, size);
    const auto model = make_model<Number>(scene);
    const auto state = testing::random_state<Number>(draw, size);
    const Point<Number> ground{draw.between(-20, 20), draw.between(-8, 8)};
    const Vector<Number> rate = accelerations(model, state, ground);
    const auto at = [&](Number t) {
      const Vector<Number> angles = state.angles + t * state.velocities + t * t / 2 * rate;
      return energy(model, State<Number>{state.pattern, angles, Vector<Number>(state.velocities + t * rate)});
    };
    const Number step = 1e-5L;
    const Number found = (at(step) - at(-step)) / (2 * step);
    const auto speeds =
        centre_velocities(make_chain(model.stack, state.pattern, directions_at(model, state.angles)),
                          absolute(state.velocities));
    const Number power = -(speeds * model.stack.mass).dot(ground);
    const Number scale = energy(model, state) + model.stack.mass.sum() * 100;
    EXPECT_NEAR(static_cast<double>(found), static_cast<double>(power), static_cast<double>(1e-6L * scale));
  }
}

TEST(Dynamics, LinearEquationsAreTheFullOnesUprightAndStill) {
  Draw draw(15);
  for (int i = 0; i < 500; ++i) {
    const int size = 1 + draw.below(5);
    Scene scene = testing::random_stack(draw, size);
    const auto full = make_model<double>(scene);
    scene.equations = Equations::linear;
    const auto state = testing::random_state<double>(draw, size);
    const Vector<double> zero = Vector<double>::Zero(size);
    const Point<double> ground{draw.between(-20, 20), draw.between(-8, 8)};
    EXPECT_EQ(accelerations(make_model<double>(scene), state, ground),
              accelerations(full, State<double>{state.pattern, zero, zero}, ground));
  }
}

}  // namespace
}  // namespace rockstack
