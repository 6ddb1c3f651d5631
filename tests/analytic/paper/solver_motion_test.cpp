#include <gtest/gtest.h>

#include <cmath>

#include "analytic/mechanics/pattern_solution.hpp"
#include "tests/analytic/paper/draw.hpp"
#include "tests/analytic/paper/initiation.hpp"
#include "tests/analytic/paper/linear.hpp"
#include "tests/analytic/paper/motion.hpp"
#include "tests/analytic/paper/solver_state.hpp"
#include "tests/analytic/paper/transition.hpp"

// The project's solver (Gauss's principle) against the paper's equations, in their corrected reading.

namespace rockstack::paper {
namespace {

constexpr Reading right = Reading::corrected;

// As in verdicts_test.cpp, for the solver's operations too.
constexpr double round_off = 1e-12;

template <class Test>
void on_draws(const Test& test) {
  repeat_on_draws(163, 3000, test);
}

/// A motion with the solver's accelerations in place of the drawn ones.
Motion solved(const Geometry& q, Motion s, Equations equations, const Pattern& pattern) {
  const Vector<double> spin = absolute(
      accelerate(model_of(q, s, equations), state_of(pattern, s), Point<double>(s.xg, s.yg)).relative);
  s.a1 = spin[0];
  s.a2 = spin[1];
  return s;
}

void expect_zero(const Geometry& q, const Motion& s, double residual) {
  EXPECT_LT(std::abs(residual), round_off * moment_size(q, s));
}

TEST(SolverMotion, SatisfiesEqs8And9InPattern1) {
  on_draws([](const Draw& d) {
    const Motion s = solved(d.q, in_pattern_1(d), Equations::nonlinear, pattern_with(d.S, d.S));
    expect_zero(d.q, s, eq8(d.q, s, right));
    expect_zero(d.q, s, eq9(d.q, s, right));
  });
}

TEST(SolverMotion, SatisfiesEqs12And13InPattern2) {
  on_draws([](const Draw& d) {
    const Motion s = solved(d.q, in_pattern_2(d), Equations::nonlinear, pattern_with(d.S, -d.S));
    expect_zero(d.q, s, eq12(d.q, s));
    expect_zero(d.q, s, eq13(d.q, s, right));
  });
}

TEST(SolverMotion, SatisfiesEq15InPattern3) {
  on_draws([](const Draw& d) {
    const Motion s = solved(d.q, in_pattern_3(d), Equations::nonlinear, pattern_with(d.S, 0));
    EXPECT_EQ(s.a1, s.a2);
    expect_zero(d.q, s, eq15(d.q, s));
  });
}

TEST(SolverMotion, SatisfiesEq18InPattern4) {
  on_draws([](const Draw& d) {
    const Motion s = solved(d.q, in_pattern_4(d), Equations::nonlinear, pattern_with(0, d.S));
    EXPECT_EQ(s.a1, 0);
    expect_zero(d.q, s, eq18(d.q, s));
  });
}

TEST(SolverMotion, SatisfiesTheLinearEqs19To28) {
  on_draws([](const Draw& d) {
    const Motion s1 = solved(d.q, in_pattern_1(d), Equations::linear, pattern_with(d.S, d.S));
    expect_zero(d.q, s1, eq19(d.q, s1));
    expect_zero(d.q, s1, eq20(d.q, s1));
    const Motion s2 = solved(d.q, in_pattern_2(d), Equations::linear, pattern_with(d.S, -d.S));
    expect_zero(d.q, s2, eq22(d.q, s2, right));
    expect_zero(d.q, s2, eq23(d.q, s2, right));
    const Motion s3 = solved(d.q, in_pattern_3(d), Equations::linear, pattern_with(d.S, 0));
    expect_zero(d.q, s3, eq25(d.q, s3));
    const Motion s4 = solved(d.q, in_pattern_4(d), Equations::linear, pattern_with(0, d.S));
    expect_zero(d.q, s4, eq28(d.q, s4));
  });
}

/// The solver's distance of an interface from opening about one of its ends, N·m.
double to_opening(const Geometry& q, const Motion& s, const Pattern& pattern, int interface, int corner) {
  const Model<double> model = model_of(q, s, Equations::nonlinear);
  const PatternSolution<double> motion = accelerate(model, state_of(pattern, s), Point<double>(s.xg, s.yg));
  const Margins<double> margin = margins(model.stack, motion.reactions, interface);
  return corner > 0 ? margin.right : margin.left;
}

TEST(SolverOpening, HasTheMarginsOfEqs1To5AtRest) {
  on_draws([](const Draw& d) {
    Motion s = upright(d.motion);
    s.a1 = s.a2 = 0;
    const Pattern rest = pattern_with(0, 0);
    expect_zero(d.q, s, d.q.M * eq1(d.q, s) + to_opening(d.q, s, rest, 0, 1));
    expect_zero(d.q, s, d.q.M * eq3(d.q, s) + to_opening(d.q, s, rest, 0, -1));
    expect_zero(d.q, s, d.q.m2 * eq4(d.q, s) + to_opening(d.q, s, rest, 1, 1));
    expect_zero(d.q, s, d.q.m2 * eq5(d.q, s) + to_opening(d.q, s, rest, 1, -1));
  });
}

using Inequality = double (*)(const Geometry&, const Motion&, Reading);

struct Opening {
  double S;    ///< side of the interface that is open
  int corner;  ///< end about which the other one opens
  Inequality inequality;
};

double plain29(const Geometry& q, const Motion& s, Reading) {
  return eq29(q, s);
}

TEST(SolverOpening, HasTheMarginsOfEqs29To34InPattern3AndOpensAsTheySay) {
  on_draws([](Draw d) {
    for (const Opening& opening : {Opening{1, 1, plain29}, {1, -1, eq32}, {-1, -1, eq33}, {-1, 1, eq34}}) {
      d.S = opening.S;
      const Pattern joined = pattern_with(d.S, 0);
      const Motion s = solved(d.q, in_pattern_3(d), Equations::nonlinear, joined);
      const double margin = d.q.m2 * d.q.r2 * opening.inequality(d.q, s, right);
      expect_zero(d.q, s, margin + to_opening(d.q, s, joined, 1, opening.corner));
      if (std::abs(margin) < 1e-9 * moment_size(d.q, s)) continue;
      const Motion apart = solved(d.q, s, Equations::nonlinear, pattern_with(d.S, opening.corner));
      EXPECT_EQ(margin > 0, opening.corner * (apart.a2 - apart.a1) > 0);
    }
  });
}

TEST(SolverOpening, HasTheMarginsOfEqs35To40InPattern4AndOpensAsTheySay) {
  on_draws([](Draw d) {
    for (const Opening& opening : {Opening{1, 1, eq35}, {-1, -1, eq37}, {-1, 1, eq38}, {1, -1, eq40}}) {
      d.S = opening.S;
      const Pattern resting = pattern_with(0, d.S);
      const Motion s = solved(d.q, in_pattern_4(d), Equations::nonlinear, resting);
      const double margin = opening.inequality(d.q, s, right);
      expect_zero(d.q, s, margin + to_opening(d.q, s, resting, 0, opening.corner));
      if (std::abs(margin) < 1e-9 * moment_size(d.q, s)) continue;
      const Motion apart = solved(d.q, s, Equations::nonlinear, pattern_with(opening.corner, d.S));
      EXPECT_EQ(margin > 0, opening.corner * apart.a1 > 0);
    }
  });
}

TEST(SolverOpening, ContradictsTheMisprintsOfEqs32To40) {
  on_draws([](Draw d) {
    for (const Opening& opening : {Opening{1, -1, eq32}, {-1, -1, eq33}, {-1, 1, eq34}}) {
      d.S = opening.S;
      const Pattern joined = pattern_with(d.S, 0);
      const Motion s = solved(d.q, in_pattern_3(d), Equations::nonlinear, joined);
      const double margin = d.q.m2 * d.q.r2 * opening.inequality(d.q, s, Reading::printed);
      EXPECT_GT(std::abs(margin + to_opening(d.q, s, joined, 1, opening.corner)), 1e-9 * moment_size(d.q, s));
    }
    for (const Opening& opening : {Opening{1, 1, eq35}, {-1, -1, eq37}, {-1, 1, eq38}, {1, -1, eq40}}) {
      d.S = opening.S;
      const Pattern resting = pattern_with(0, d.S);
      const Motion s = solved(d.q, in_pattern_4(d), Equations::nonlinear, resting);
      const double missing = d.q.m2 * s.g * (opening.S == opening.corner ? d.q.xi : d.q.xi_);
      const double margin = opening.inequality(d.q, s, Reading::printed);
      expect_zero(d.q, s, margin - missing + to_opening(d.q, s, resting, 0, opening.corner));
    }
  });
}

}  // namespace
}  // namespace rockstack::paper
