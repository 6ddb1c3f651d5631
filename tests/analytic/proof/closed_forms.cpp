#if __has_include(<flint/acb_calc.h>)
#include <flint/acb_calc.h>
#else
#include <acb_calc.h>
#endif
#include <gtest/gtest.h>

#include "tests/analytic/proof/prover.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack::proof {
namespace {

/// A uniform block of half width 1/4 and half height 5/4 m that is let go at 0.1 rad: scene housner-block.
constexpr const char* block_scene = R"(duration = 60.0
[[blocks]]
width = 0.5
height = 2.5
density = 2500
[initial]
angles = [0.1]
)";

/// A block that rocks by its energy integral. With R the half diagonal, α = atan(b/h) and c = mgR/I₀ =
/// 3g/(4R), ω² = 2c (cos(α − θ₀) − cos(α − θ)), and an impact leaves 1 − (3/2) sin² α of ω (Housner 1963).
struct RockingBlock {
  Ball slenderness = arctangent(Ball(1), Ball(5));
  Ball stiffness = Ball(decimal("9.81")) * 3 / (Ball(4) * root(Ball(decimal("1.625"))));
  Ball kept;

  RockingBlock() {
    const Ball sine = sine_cosine(slenderness, Ball()).sine;
    kept = Ball(1) - Ball(3) / Ball(2) * sine * sine;
  }

  /// The amplitude after an impact, rad.
  Ball next(const Ball& amplitude) const {
    const Ball upright = sine_cosine(slenderness, Ball()).cosine;
    const Ball released = sine_cosine(slenderness - amplitude, Ball()).cosine;
    Ball result;
    arb_acos(result.data(), (upright + kept * kept * (released - upright)).data(), working_bits);
    return slenderness - result;
  }
};

struct QuarterSwing {
  Ball below_balance;  ///< α − θ₀
  Ball stiffness;
};

/// 2/√(2c sin(α − θ₀ + x²/2) sinc(x²/2)), which is dt/dx where θ = θ₀ − x².
int time_over_root(acb_ptr result, const acb_t x, void* swing, slong order, slong bits) {
  const auto& [below_balance, stiffness] = *static_cast<const QuarterSwing*>(swing);
  ComplexBall half, product, sinc;
  acb_mul(half.data(), x, x, bits);
  acb_mul_2exp_si(half.data(), half.data(), -1);
  acb_sinc(sinc.data(), half.data(), bits);
  acb_add_arb(product.data(), half.data(), below_balance.data(), bits);
  acb_sin(product.data(), product.data(), bits);
  acb_mul(product.data(), product.data(), sinc.data(), bits);
  acb_mul_arb(product.data(), product.data(), stiffness.data(), bits);
  acb_mul_2exp_si(product.data(), product.data(), 1);
  acb_rsqrt_analytic(result, product.data(), order != 0, bits);
  acb_mul_2exp_si(result, result, 1);
  return 0;
}

/// From rest at an amplitude to the ground, s, by a quadrature with certain bounds.
Ball quarter_swing(const RockingBlock& block, const Ball& amplitude) {
  QuarterSwing swing{block.slenderness - amplitude, block.stiffness};
  const ComplexBall from(0);
  const ComplexBall to(root(amplitude));
  ComplexBall time;
  mag_t tolerance;
  mag_init(tolerance);
  mag_set_ui_2exp_si(tolerance, 1, -working_bits);
  acb_calc_integrate(time.data(), time_over_root, &swing, from.data(), to.data(), working_bits, tolerance,
                     nullptr, working_bits);
  mag_clear(tolerance);
  Ball result;
  acb_get_real(result.data(), time.data());
  return result;
}

Proof proved(const char* scene, const ProofOptions& options) {
  const TemporaryFolder folder;
  return prove(read_exact_scene(folder.write("scene.toml", scene)), options);
}

bool overlap(const Ball& a, const Ball& b) {
  return arb_overlaps(a.data(), b.data()) != 0;
}

TEST(ProvedBlock, ImpactsAreThoseOfItsEnergyIntegralToFiftyDigits) {
  const Proof proof = proved(block_scene, {.bits = 256, .most_events = 12});
  const Precision bits(256);
  const RockingBlock block;
  Ball amplitude(decimal("0.1"));
  Ball time = quarter_swing(block, amplitude);
  ASSERT_EQ(proof.events.size(), 12);
  for (const ProvedEvent& impact : proof.events) {
    EXPECT_TRUE(overlap(impact.time, time));
    EXPECT_LT(width_exponent(impact.time), -166);  // 10⁻⁵⁰
    EXPECT_LT(width_exponent(time), -166);
    amplitude = block.next(amplitude);
    time = time + quarter_swing(block, amplitude) * 2;
  }
}

// Flights become a geometric series: past the nth its rest is η/(1 − η) of it, but for a share of some
// amplitude.
TEST(ProvedBlock, RestsWhereItsQuarterSwingsAddUp) {
  const Proof proof = proved(block_scene, {.bits = 640, .slow_speed = 1e-9});
  ASSERT_TRUE(proof.whole);
  EXPECT_EQ(proof.end, "the stack rests for ever");
  ASSERT_EQ(proof.events.back().kind, EventKind::accumulation);
  const Precision bits(128);
  const RockingBlock block;
  Ball amplitude(decimal("0.1"));
  Ball time = quarter_swing(block, amplitude);
  Ball flight;
  for (int impact = 1; impact <= 300; ++impact) {
    amplitude = block.next(amplitude);
    flight = quarter_swing(block, amplitude) * 2;
    time = time + flight;
  }
  const Ball tail = flight * block.kept / (Ball(1) - block.kept);
  const Ball share = within(Ball(10) * amplitude);
  EXPECT_TRUE(overlap(proof.events.back().time, time + tail + tail * share));
  EXPECT_LT(approximate(magnitude(tail * share)), 1e-20);
  EXPECT_LT(width_exponent(proof.events.back().time), -56);
}

/// Energy of a stack from places and velocities of its centres of mass, J; angles and rates absolute.
Ball energy(const Stack& stack, const Pattern& pattern, const ProvedEvent& event) {
  Ball sum, x, y, right, up;  // of the pivot: its place and velocity
  for (std::size_t k = 0; k < stack.size(); ++k) {
    const auto direction = sine_cosine(event.angles[k], Ball());
    const Ball &sine = direction.sine, &cosine = direction.cosine, &rate = event.rates[k];
    const auto move = [&](const Ball& along, const Ball& across, Ball& px, Ball& py, Ball& vx, Ball& vy) {
      const Ball dx = along * cosine + across * sine;
      const Ball dy = across * cosine - along * sine;
      px = x + dx;
      py = y + dy;
      vx = right + rate * dy;
      vy = up - rate * dx;
    };
    Ball cx, cy, vx, vy;
    const Ball pivot = stack.pivot(pattern, k);
    move(stack.centre_x[k] - pivot, stack.centre_y[k], cx, cy, vx, vy);
    sum = sum + stack.mass[k] * (stack.gravity * cy + (vx * vx + vy * vy) / 2) +
          stack.inertia[k] * rate * rate / 2;
    move(stack.pivot(pattern, k + 1) - pivot, stack.height[k], cx, cy, vx, vy);
    x = cx;
    y = cy;
    right = vx;
    up = vy;
  }
  return sum;
}

TEST(ProvedStack, NeitherFlightsNorOpeningsChangeItsEnergy) {
  const char* text = R"(duration = 5.0
[[blocks]]
width = 1.25
height = 1.25
density = 2500
center_of_mass = [0.02, -0.05]
[[blocks]]
width = 1.0
height = 2.5
mass = 6000
inertia = 3500
[initial]
angles = [0.15, 0.15]
velocities = [0.1, 0.1]
)";
  const TemporaryFolder folder;
  const ExactScene scene = read_exact_scene(folder.write("scene.toml", text));
  const Proof proof = prove(scene, {.bits = 256, .most_events = 8});
  const Precision bits(256);
  const Stack stack = make_stack(scene);
  ProvedEvent last{EventKind::impact, 0, {}, {1, 0}, 0, {}, {}};
  for (std::size_t k = 0; k < 2; ++k) {
    last.angles.emplace_back(scene.angles[k]);
    last.rates.emplace_back(scene.velocities[k]);
  }
  int openings = 0;
  ASSERT_EQ(proof.events.size(), 8);
  for (const ProvedEvent& event : proof.events) {
    // Before an impact rates are others: its energy is known after it alone.
    if (event.kind == EventKind::opening) {
      const Ball change = energy(stack, event.from, event) - energy(stack, last.to, last);
      EXPECT_TRUE(overlap(change, Ball()));
      EXPECT_LT(width_exponent(change), -100);
      ++openings;
    } else {
      EXPECT_TRUE(negative(energy(stack, event.to, event) - energy(stack, last.to, last)));
    }
    last = event;
  }
  EXPECT_GT(openings, 0);
}

}  // namespace
}  // namespace rockstack::proof
