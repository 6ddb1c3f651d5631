#include "analytic/polynomials/crossing.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace rockstack {
namespace {

using Quintic = Polynomial<double>;

/// sign × (s − r₁)(s − r₂)…, rounded once a root.
Quintic product(double factor, const std::vector<double>& roots) {
  Quintic result{factor, 0, 0, 0, 0, 0};
  for (const double root : roots) {
    for (std::size_t i = 5; i > 0; --i) result[i] = result[i - 1] - root * result[i];
    result[0] *= -root;
  }
  return result;
}

// Rounding of the coefficients (at most 2⁵ in size) moves a simple root by their error over the slope there.
double root_error(const Quintic& polynomial, double root) {
  return 64 * 32 * std::numeric_limits<double>::epsilon() / std::abs(tangent(polynomial, root).slope);
}

TEST(Polynomial, FirstCrossingIsTheFirstKnownRoot) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> place(0.01, 2.0);
  int crossings = 0;
  for (int i = 0; i < 20000; ++i) {
    std::vector<double> roots(5);
    for (double& root : roots) root = place(generator);
    std::sort(roots.begin(), roots.end());
    const Quintic polynomial = product(-1, roots);  // positive left of the first root
    const auto crossing = first_crossing(polynomial);
    const double error = root_error(polynomial, roots[0]);
    if (error > (roots[1] - roots[0]) / 8 || std::abs(roots[0] - 1) < error) continue;
    ASSERT_EQ(crossing.has_value(), roots[0] < 1) << roots[0];
    if (!crossing) continue;
    ++crossings;
    EXPECT_NEAR(*crossing, roots[0], error);
  }
  EXPECT_GT(crossings, 10000);
}

TEST(Polynomial, FirstCrossingAgreesWithAScan) {
  std::mt19937_64 generator(2);
  std::normal_distribution<double> coefficient;
  int crossings = 0;
  for (int i = 0; i < 5000; ++i) {
    Quintic polynomial{0, 0, 0, 0, 0, 0};
    for (double& c : polynomial) c = coefficient(generator);
    polynomial[0] = std::abs(polynomial[0]) * 0.3;
    const auto crossing = first_crossing(polynomial);
    const double end = crossing.value_or(1);
    // Nowhere negative before, negative right after; 1e-13 is a thousand roundings of six coefficients of
    // size 1.
    for (int j = 0; j < 500; ++j) ASSERT_GE(value(polynomial, end * j / 500), -1e-13);
    if (!crossing) continue;
    ++crossings;
    EXPECT_NEAR(value(polynomial, end), 0, 1e-13);
    EXPECT_LE(tangent(polynomial, end).slope, 1e-6);  // 0 at a double root, to the root of rounding
  }
  EXPECT_GT(crossings, 1000);
}

// Beyond its zero near a = 1e-9 the polynomial is as flat as s²¹: Newton's method comes nearer by a
// twenty-first of the way at each point. At the zero the slope is that of both terms, and the value is
// rounded by ε a²¹.
TEST(Polynomial, AZeroThatNewtonsMethodCreepsToIsFound) {
  const double a = 1e-9;
  Polynomial<double> polynomial;
  polynomial.terms = 22;
  std::fill(polynomial.begin(), polynomial.end(), 0.0);
  polynomial[0] = std::pow(a, 21);
  polynomial[1] = -1e-3 * std::pow(a, 20);
  polynomial[21] = -1;
  const auto crossing = first_crossing(polynomial);
  ASSERT_TRUE(crossing);
  EXPECT_GT(value(polynomial, *crossing * (1 - 1e-15)), 0);
  EXPECT_LT(value(polynomial, *crossing * (1 + 1e-15)), 0);
}

// Coefficients below 32 in size, a dozen roundings each: 1e-13 is above what rounding can carry below zero.
TEST(Polynomial, TouchingZeroFromAboveIsNoCrossing) {
  for (int i = 1; i < 100; ++i) {
    const double root = i / 100.0;
    Quintic pair = product(1, {root, root});
    Quintic two_pairs = product(1, {root, root, root, root});
    pair[0] += 1e-13;
    two_pairs[0] += 1e-13;
    EXPECT_FALSE(first_crossing(pair)) << root;
    EXPECT_FALSE(first_crossing(two_pairs)) << root;
  }
  EXPECT_FALSE(first_crossing(Quintic{}));
}

TEST(Polynomial, ATouchToRoundingCountsAtMostWhereItTouches) {
  for (int i = 1; i < 100; ++i) {
    const double root = i / 100.0;
    const auto crossing = first_crossing(product(1, {root, root}));
    if (crossing) {
      EXPECT_NEAR(*crossing, root, 1e-7);  // the square root of rounding
    }
  }
}

TEST(Polynomial, TwoRootsANanoPartAreNotMissed) {
  // Coefficients of size 1 leave (root distance)² / 4 = 2.5e-19 below rounding for a pair in the middle; near
  // zero they are small themselves, and there the pair must be found.
  for (const double root : {1e-9, 1e-6, 1e-3}) {
    const auto crossing = first_crossing(product(1, {root, root * (1 + 1e-6)}));
    ASSERT_TRUE(crossing) << root;
    EXPECT_NEAR(*crossing / root, 1, 1e-6);
  }
  const auto pair = first_crossing(product(1, {0.5, 0.5 + 1e-7}));  // dips to -2.5e-15
  ASSERT_TRUE(pair);
  EXPECT_NEAR(*pair, 0.5, 1e-7);
}

TEST(Polynomial, ALaunchFromZeroCrossesOnlyWhenItComesBack) {
  EXPECT_FALSE(first_crossing(Quintic{0, 1, 0, 0, 0, 0}));
  EXPECT_FALSE(first_crossing(Quintic{0, 0, 1, 0, 0, 0}));
  for (const double root : {1e-12, 1e-6, 0.3, 0.999999}) {
    const auto crossing = first_crossing(Quintic{0, root, -1, 0, 0, 0});
    ASSERT_TRUE(crossing) << root;
    EXPECT_NEAR(*crossing / root, 1, 1e-14);
  }
}

TEST(Polynomial, WhatFallsFromZeroCrossesAtOnce) {
  EXPECT_EQ(first_crossing(Quintic{0, -1, 0, 0, 0, 0}), 0.0);
  EXPECT_EQ(first_crossing(Quintic{0, 0, 0, -1e-30, 0, 0}), 0.0);
  EXPECT_EQ(first_crossing(Quintic{-1e-18, 1, 0, 0, 0, 0}), 0.0);
}

TEST(Polynomial, RootsAtTheEndsBelongToTheStep) {
  EXPECT_EQ(first_crossing(Quintic{1, -1, 0, 0, 0, 0}).value_or(1),
            1);  // whether it counts as reached is open
  const auto near_start = first_crossing(Quintic{1e-15, -1, 0, 0, 0, 0});
  ASSERT_TRUE(near_start);
  EXPECT_NEAR(*near_start, 1e-15, 1e-28);
  const auto near_end = first_crossing(Quintic{1 - 1e-12, -1, 0, 0, 0, 0});
  ASSERT_TRUE(near_end);
  EXPECT_NEAR(*near_end, 1 - 1e-12, 4e-16);
}

TEST(Polynomial, BernsteinFormKeepsEndsAndHalvesMeet) {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> coefficient(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    Quintic polynomial{0, 0, 0, 0, 0, 0};
    for (double& c : polynomial) c = coefficient(generator);
    const Quintic form = bernstein(polynomial);
    // Sums of six numbers of size 1, some dozen roundings.
    const double error = 1e-14;
    EXPECT_EQ(form[0], polynomial[0]);
    EXPECT_NEAR(form[5], value(polynomial, 1.0), error);
    const auto halves = halve(form);
    EXPECT_EQ(halves.left[0], form[0]);
    EXPECT_EQ(halves.right[5], form[5]);
    EXPECT_EQ(halves.left[5], halves.right[0]);
    EXPECT_NEAR(halves.left[5], value(polynomial, 0.5), error);
    const auto quarter = halve(halves.left);
    EXPECT_NEAR(quarter.left[5], value(polynomial, 0.25), error);
    const auto [least, most] = std::minmax_element(form.begin(), form.end());
    for (int j = 0; j <= 16; ++j) {
      EXPECT_GE(value(polynomial, j / 16.0), *least - error);
      EXPECT_LE(value(polynomial, j / 16.0), *most + error);
    }
  }
}

TEST(Polynomial, TheSummitIsThatOfAScanAndNoLess) {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> coefficient(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    Quintic polynomial{0, 0, 0, 0, 0, 0};
    for (double& c : polynomial) c = coefficient(generator);
    double scanned = value(polynomial, 0.0);
    for (int j = 1; j <= 1000; ++j) scanned = std::max(scanned, value(polynomial, j / 1000.0));
    // A parabola of curvature below 2·(1 + 3 + 6 + 10) falls by 5e-6 in half a step of the scan.
    const auto top = maximum(polynomial, -10.0);
    ASSERT_TRUE(top);
    EXPECT_GE(top->height, scanned - 2e-14);
    EXPECT_LE(top->height, scanned + 40 * 0.5e-3 * 0.5e-3 / 2);
    EXPECT_NEAR(value(polynomial, top->s), top->height, 1e-14);
    EXPECT_FALSE(maximum(polynomial, top->height + 1e-13));
    EXPECT_FALSE(maximum(polynomial, 7.0));  // six coefficients of size 1
  }
}

// A slack far below what rounding makes of the polynomial cannot be had.
TEST(Polynomial, TheMaximumOfLargeCoefficientsIsFoundToTheirRounding) {
  std::mt19937_64 generator(6);
  std::uniform_real_distribution<double> coefficient(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    Quintic polynomial{0, 0, 0, 0, 0, 0};
    for (double& c : polynomial) c = coefficient(generator);
    const auto top = maximum(polynomial, -10.0);
    for (double& c : polynomial) c *= 1e130;
    const auto large = maximum(polynomial, -1e131, 1e-14);
    ASSERT_TRUE(top && large);
    EXPECT_NEAR(large->height, 1e130 * top->height, 1e-14 * 1e130);
  }
}

// Bounds may say too little, never too much; and they say more than the sum of all sizes would.
TEST(Polynomial, BoundsHoldWhereverTheyTell) {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> coefficient(-1, 1);
  int above = 0, falling = 0;
  for (int i = 0; i < 20000; ++i) {
    Quintic polynomial{0, 0, 0, 0, 0, 0};
    for (std::size_t j = static_cast<std::size_t>(i) % 3; j < polynomial.terms; ++j)
      polynomial[j] = coefficient(generator);
    const bool positive = stays_positive(polynomial);
    const auto bounds = hull_beyond_zero(polynomial);
    const bool negative = stays_clear(polynomial, bounds, -1);
    EXPECT_TRUE(positive || !stays_clear(polynomial, bounds));
    const bool falls_all_along = falls(polynomial);
    EXPECT_FALSE(positive && negative);
    EXPECT_TRUE(positive || polynomial[0] <= reach(polynomial));
    above += positive ? 1 : 0;
    falling += falls_all_along ? 1 : 0;
    for (int j = 1; j <= 64; ++j) {
      const double s = j / 64.0;
      EXPECT_TRUE(!positive || value(polynomial, s) > 0);
      EXPECT_TRUE(!negative || value(polynomial, s) < 0);
      EXPECT_TRUE(!falls_all_along || tangent(polynomial, s).slope < 0);
    }
  }
  EXPECT_GT(above, 1000);
  EXPECT_GT(falling, 1000);
}

TEST(Polynomial, QuarticThroughFivePointsIsTheQuartic) {
  std::mt19937_64 generator(4);
  std::uniform_real_distribution<double> coefficient(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    Quintic quartic{0, 0, 0, 0, 0};
    for (double& c : quartic) c = coefficient(generator);
    std::array<double, 5> values{};
    for (std::size_t j = 0; j < 5; ++j) values[j] = value(quartic, static_cast<double>(j) / 4);
    const auto found = quartic_through(values);
    // Rounding of values (5 ε) times the sum of the weights, below 512.
    for (std::size_t j = 0; j < 5; ++j) EXPECT_NEAR(found[j], quartic[j], 5e-13);
  }
}

}  // namespace
}  // namespace rockstack
