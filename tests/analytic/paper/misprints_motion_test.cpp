#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/analytic/paper/draw.hpp"
#include "tests/analytic/paper/effects.hpp"
#include "tests/analytic/paper/linear.hpp"
#include "tests/analytic/paper/motion.hpp"
#include "tests/analytic/paper/transition.hpp"

// A second proof for each misprint, apart from first_principles.hpp and from the solver: a symmetry, a limit
// or another equation of the paper that the printed form contradicts.

namespace rockstack::paper {
namespace {

constexpr Reading print = Reading::printed;
constexpr Reading right = Reading::corrected;

// Differences of a few products of numbers that are bounded by the size they are compared with.
constexpr double round_off = 1e-13;

template <class Test>
void on_draws(const Test& test) {
  repeat_on_draws(2001, 1000, test);
}

/// What an equation gains from a unit of one of its arguments, all of which enter linearly.
double gain(const std::function<double(const Motion&)>& equation, Motion s, double Motion::*argument) {
  s.xg = s.yg = s.g = s.a1 = s.a2 = 0;
  const double zero = equation(s);
  s.*argument = 1;
  return equation(s) - zero;
}

Motion mirrored(Motion s) {
  s.angle = {-s.angle.u1, -s.angle.u2};
  s.velocity = {-s.velocity.base, -s.velocity.top};
  s.a1 = -s.a1;
  s.a2 = -s.a2;
  s.xg = -s.xg;
  return s;
}

/// Horizontal ground acceleration does to a block what weight would do to one turned by a quarter: the moment
/// of the one is minus the derivative of the other's by the angle.
double quarter_turn_error(const std::function<double(const Motion&)>& equation, const Motion& s,
                          double Angles::*angle) {
  const double step = 1e-4;
  Motion ahead = s;
  Motion behind = s;
  ahead.angle.*angle += step;
  behind.angle.*angle -= step;
  const double slope = (gain(equation, ahead, &Motion::g) - gain(equation, behind, &Motion::g)) / (2 * step);
  return std::abs(gain(equation, s, &Motion::xg) + slope);
}

// A central difference of sines errs by step²/6 of the amplitude.
constexpr double difference_error = 1e-8;

TEST(Misprint, Eq8HorizontalGroundDoesNotActAsAQuarterTurnedWeight) {
  on_draws([](const Draw& d) {
    const Motion s = in_pattern_1(d);
    const double size = d.q.M * (d.q.l + d.q.r1);
    const auto error = [&](Reading r) {
      return quarter_turn_error([&](const Motion& m) { return eq8(d.q, m, r); }, s, &Angles::u1) / size;
    };
    EXPECT_LT(error(right), difference_error);
    EXPECT_GT(error(print), 100 * difference_error);
  });
}

TEST(Misprint, Eq9MassMatrixIsNotSymmetric) {
  on_draws([](const Draw& d) {
    const Motion s = in_pattern_1(d);
    const double to_base = gain([&](const Motion& m) { return eq8(d.q, m, right); }, s, &Motion::a2);
    const auto to_top = [&](Reading r) {
      return gain([&](const Motion& m) { return eq9(d.q, m, r); }, s, &Motion::a1);
    };
    EXPECT_LT(std::abs(to_top(right) - to_base), round_off * inertia_size(d.q));
    EXPECT_EQ(to_top(print), 0);
  });
}

TEST(Misprint, Eq13HorizontalGroundDoesNotActAsAQuarterTurnedWeight) {
  on_draws([](const Draw& d) {
    const Motion s = in_pattern_2(d);
    const double size = d.q.m2 * d.q.r2;
    const auto error = [&](Reading r) {
      return quarter_turn_error([&](const Motion& m) { return eq13(d.q, m, r); }, s, &Angles::u2) / size;
    };
    EXPECT_LT(error(right), difference_error);
    EXPECT_GT(error(print), 100 * difference_error);
  });
}

TEST(Misprint, Eq22MassMatrixIsNotSymmetric) {
  on_draws([](const Draw& d) {
    const Motion s = in_pattern_2(d);
    const double to_base = gain([&](const Motion& m) { return eq23(d.q, m, right); }, s, &Motion::a1);
    const auto to_top = [&](Reading r) {
      return gain([&](const Motion& m) { return eq22(d.q, m, r); }, s, &Motion::a2);
    };
    EXPECT_LT(std::abs(to_top(right) - to_base), round_off * inertia_size(d.q));
    EXPECT_GT(std::abs(to_top(print) - to_base), 1e-6 * d.q.m2 * d.q.l_ * d.q.r2);
  });
}

TEST(Misprint, Eq23IsNotTheLimitOfEq13AtSmallAngles) {
  on_draws([](Draw d) {
    // Angles of 1e-9 change the terms by about as much.
    d.lean = 1e-9;
    d.opening = 2e-9;
    Motion s = in_pattern_2(d);
    s.velocity = {};
    const double full = eq13(d.q, s, right);
    const double size = moment_size(d.q, s);
    EXPECT_LT(std::abs(eq23(d.q, s, right) - full), 1e-8 * size);
    // As printed, gravity alone comes out with its sign turned.
    s.xg = s.yg = 0;
    const double weight = gain([&](const Motion& m) { return eq13(d.q, m, right); }, s, &Motion::g);
    EXPECT_LT(weight * gain([&](const Motion& m) { return eq23(d.q, m, print); }, s, &Motion::g), 0);
  });
}

TEST(Misprint, Eq24IsTheLimitOfEq14WithItsSignTurned) {
  on_draws([](const Draw& d) {
    const Angles u{d.S * 1e-15, 0};
    EXPECT_NEAR(eq24(d.q, u, right), eq14(d.q, u), round_off);
    EXPECT_NEAR(eq24(d.q, u, print), -eq14(d.q, u), round_off);
  });
}

TEST(Misprint, Eqs32And34AreNotMirrorImages) {
  on_draws([](const Draw& d) {
    const Motion s = in_pattern_3(d);
    const double size = moment_size(d.q, s) / (d.q.m2 * d.q.r2);
    EXPECT_LT(std::abs(eq32(d.q, s, right) - eq34(d.q, mirrored(s), right)), round_off * size);
    EXPECT_GT(std::abs(eq32(d.q, s, print) - eq34(d.q, mirrored(s), print)), 1e-9 * size);
  });
}

TEST(Misprint, Eq33IsNotTheMirrorImageOfEq29) {
  on_draws([](const Draw& d) {
    const Motion s = in_pattern_3(d);
    const double size = moment_size(d.q, s) / (d.q.m2 * d.q.r2);
    EXPECT_LT(std::abs(eq29(d.q, s) - eq33(d.q, mirrored(s), right)), round_off * size);
    EXPECT_GT(std::abs(eq29(d.q, s) - eq33(d.q, mirrored(s), print)), 1e-9 * size);
  });
}

TEST(Misprint, Eqs33And34ReadWithTheAngleFromTheVerticalErrOnlyInTheSignOfTheInertia) {
  on_draws([](const Draw& d) {
    const Motion s = in_pattern_3(d);
    const double size = moment_size(d.q, s) / (d.q.m2 * d.q.r2);
    const double inertia = 2 * d.q.IG2 / (d.q.m2 * d.q.r2) * s.a1;
    Geometry from_vertical = d.q;
    from_vertical.nu = d.q.zeta;
    EXPECT_LT(std::abs(eq33(from_vertical, s, print) + inertia - eq33(d.q, s, right)), round_off * size);
    EXPECT_LT(std::abs(eq34(from_vertical, s, print) - inertia - eq34(d.q, s, right)), round_off * size);
  });
}

/// An inequality feels gravity and a vertical ground acceleration alike.
double equivalence_error(double (*inequality)(const Geometry&, const Motion&, Reading), const Geometry& q,
                         const Motion& s, Reading r) {
  const auto at = [&](const Motion& m) { return inequality(q, m, r); };
  return std::abs(gain(at, s, &Motion::g) - gain(at, s, &Motion::yg));
}

TEST(Misprint, Eq32TellsGravityFromVerticalGroundAcceleration) {
  on_draws([](const Draw& d) {
    const Motion s = in_pattern_3(d);
    const double rates = d.q.d * s.velocity.base * s.velocity.base;
    EXPECT_LT(equivalence_error(eq32, d.q, s, right), round_off * (1 + rates));
    EXPECT_GT(equivalence_error(eq32, d.q, s, print), 1e-6);
  });
}

TEST(Misprint, Eqs35To40TellGravityFromVerticalGroundAccelerationByTheTopBlocksWeight) {
  on_draws([](const Draw& d) {
    const Motion s = in_pattern_4(d);
    const double size = moment_size(d.q, s);
    for (const auto inequality : {eq35, eq37, eq38, eq40}) {
      const double arm = inequality == eq35 || inequality == eq37 ? d.q.xi : d.q.xi_;
      EXPECT_LT(equivalence_error(inequality, d.q, s, right), round_off * size);
      EXPECT_NEAR(equivalence_error(inequality, d.q, s, print), d.q.m2 * arm, round_off * size);
    }
  });
}

TEST(LinearEquations, FeelTheSameGravityAtEveryAngle) {
  on_draws([](const Draw& d) {
    const Motion s = in_pattern_4(d);
    const auto weight = [&](const Motion& m) { return eq28(d.q, m); };
    Motion farther = s;
    farther.angle.u2 *= 2;
    EXPECT_EQ(gain(weight, s, &Motion::g), gain(weight, farther, &Motion::g));
    EXPECT_NE(eq18(d.q, s), eq18(d.q, farther));
  });
}

TEST(PapersExample, TopSeparatesByEq29BeforeTheBaseHitsTheGround) {
  const auto separation = [](const Geometry& q, const Motion& s, Reading) { return eq29(q, s); };
  EXPECT_NEAR(time_to_opening(0.15, separation, print), 0.3595, 2e-4);
  EXPECT_NEAR(time_to_opening(-0.15, eq33, right), 0.3595, 2e-4);
  const auto hits = [](const Geometry&, const Motion& s, Reading) { return 0.002 - s.angle.u1; };
  EXPECT_NEAR(time_to_opening(0.15, hits, print), 0.61, 0.005);
}

}  // namespace
}  // namespace rockstack::paper
