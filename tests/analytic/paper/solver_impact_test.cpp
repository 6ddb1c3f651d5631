#include <gtest/gtest.h>

#include <cmath>

#include "analytic/mechanics/impact.hpp"
#include "tests/analytic/paper/draw.hpp"
#include "tests/analytic/paper/first_principles.hpp"
#include "tests/analytic/paper/impact_pattern_1.hpp"
#include "tests/analytic/paper/impact_pattern_2.hpp"
#include "tests/analytic/paper/impact_patterns_3_4.hpp"
#include "tests/analytic/paper/solver_state.hpp"

// The solver's impact (nearest motion in kinetic energy) against the paper's solutions of the momentum
// equations.

namespace rockstack::paper {
namespace {

constexpr Reading right = Reading::corrected;

struct Pivots {
  double base, top;
};

/// What the solver makes of velocities before, with S = −1 for the paper's subcase b: everything mirrored.
Velocities solver_after(const Draw& d, const Pivots& before, const Pivots& after, const Angles& u,
                        const Velocities& minus) {
  const Motion s{{d.S * u.u1, d.S * u.u2}, {d.S * minus.base, d.S * minus.top}};
  const State<double> state = state_of(pattern_with(d.S * before.base, d.S * before.top), s);
  const Pattern next = pattern_with(d.S * after.base, d.S * after.top);
  const Model<double> model = model_of(d.q, 9.81, Equations::nonlinear);
  const Vector<double> rates = absolute(velocities_after(model, Impact<double>{state, {}}, next).relative);
  return {d.S * rates[0], d.S * rates[1]};
}

template <class Test>
void on_draws(const Test& test) {
  repeat_on_draws(3000, 3000, test);
}

// Rounding grows by the condition of a two-by-two mass matrix, below 10⁵ for the drawn blocks: 10⁵ · 2⁻⁵³ ·
// some ten operations on velocities of a few rad/s.
constexpr double round_off = 1e-9;

void expect_same(const Velocities& solver, const Velocities& paper) {
  EXPECT_NEAR(solver.base, paper.base, round_off);
  EXPECT_NEAR(solver.top, paper.top, round_off);
}

/// True where any velocity is off by more than round-off.
bool differs(const Velocities& solver, const Velocities& paper) {
  return std::abs(solver.base - paper.base) + std::abs(solver.top - paper.top) > 10 * round_off;
}

TEST(SolverImpact, AgreesWithEqs52To60WhenPattern1HitsTheGround) {
  on_draws([](const Draw& d) {
    const Angles u{0, d.opening};
    const Velocities solver = solver_after(d, {1, 1}, {-1, 1}, u, d.minus);
    expect_same(solver, apply(eqs52_and_53(d.q, eqs56_to_60(d.q, u, right)), d.minus));
    EXPECT_TRUE(differs(solver, apply(eqs52_and_53(d.q, eqs56_to_60(d.q, u, Reading::printed)), d.minus)));
  });
}

TEST(SolverImpact, AgreesWithEqs67To79WhenTheBlocksOfPattern1Meet) {
  on_draws([](const Draw& d) {
    const Angles u{d.lean, d.lean};
    expect_same(solver_after(d, {1, 1}, {1, -1}, u, d.minus),
                apply(eqs67_and_68(d.q, eqs73_to_79(d.q, u)), d.minus));
  });
}

TEST(SolverImpact, AgreesWithEqs84To86WhenTheBlocksOfPattern1Join) {
  on_draws([](const Draw& d) {
    const Angles u{d.lean, d.lean};
    const double rate = eq84(d.q, eq85(d.q), eq86(d.q, u), d.minus);
    expect_same(solver_after(d, {1, 1}, {1, 0}, u, d.minus), {rate, rate});
  });
}

TEST(SolverImpact, AgreesWithEqs93To104WhenPattern2HitsTheGround) {
  on_draws([](const Draw& d) {
    const Angles u{0, -d.opening};
    const Velocities solver = solver_after(d, {1, -1}, {-1, -1}, u, d.minus);
    expect_same(solver, apply(eqs93_and_94(d.q, eqs99_to_104(d.q, u, right)), d.minus));
    EXPECT_TRUE(differs(solver, apply(eqs93_and_94(d.q, eqs99_to_104(d.q, u, Reading::printed)), d.minus)));
  });
}

TEST(SolverImpact, AgreesWithEqs111To122WhenTheBlocksOfPattern2Meet) {
  on_draws([](const Draw& d) {
    const Angles u{d.lean, d.lean};
    const Velocities solver = solver_after(d, {1, -1}, {1, 1}, u, d.minus);
    const Es e = eqs117_to_122(d.q, u, right);
    expect_same(solver, apply(eqs111_and_112(d.q, e, top_after(d.q, u, right)), d.minus));
    EXPECT_TRUE(differs(solver, apply(eqs111_and_112(d.q, e, top_after(d.q, u, Reading::printed)), d.minus)));
  });
}

TEST(SolverImpact, AgreesWithEq84AndE1AndE5WhenTheBlocksOfPattern2Join) {
  on_draws([](const Draw& d) {
    const Angles u{d.lean, d.lean};
    const Es e = eqs117_to_122(d.q, u, right);
    const double rate = eq84(d.q, e.E1, e.E5, d.minus);
    expect_same(solver_after(d, {1, -1}, {1, 0}, u, d.minus), {rate, rate});
  });
}

TEST(SolverImpact, AgreesWithEqs132To144WhenPattern3HitsTheGround) {
  on_draws([](const Draw& d) {
    const Velocities minus{d.minus.base, d.minus.base};
    const Velocities solver = solver_after(d, {1, 0}, {-1, -1}, {}, minus);
    expect_same(solver, apply(eqs132_and_133(d.q, eqs136_to_140(d.q, right)), minus));
    EXPECT_TRUE(differs(solver, apply(eqs132_and_133(d.q, eqs136_to_140(d.q, Reading::printed)), minus)));
    const double rate = eq144(d.q, minus.base);
    expect_same(solver_after(d, {1, 0}, {-1, 0}, {}, minus), {rate, rate});
  });
}

TEST(SolverImpact, AgreesWithEqs151To163WhenTheTopOfPattern4FallsBack) {
  on_draws([](const Draw& d) {
    const Velocities minus{0, d.minus.top};
    const Velocities solver = solver_after(d, {0, 1}, {-1, -1}, {}, minus);
    expect_same(solver, apply(eqs151_and_152(d.q, eqs155_to_159(d.q, right)), minus));
    EXPECT_TRUE(differs(solver, apply(eqs151_and_152(d.q, eqs155_to_159(d.q, Reading::printed)), minus)));
    expect_same(solver_after(d, {0, 1}, {0, -1}, {}, minus), {0, eq163(d.q, minus.top)});
  });
}

}  // namespace
}  // namespace rockstack::paper
