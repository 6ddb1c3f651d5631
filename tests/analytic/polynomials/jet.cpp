#include "analytic/polynomials/jet.hpp"

#include <gtest/gtest.h>

namespace rockstack {
namespace {

constexpr std::size_t terms = max_terms<double>;
const Jet one = jet(terms, [](std::size_t n) { return n == 0 ? 1.0 : 0.0; });

/// Coefficients of all orders agree to a few roundings of the largest.
void expect_same(const Jet& one, const Jet& other) {
  ASSERT_EQ(one.terms(), other.terms());
  for (std::size_t n = 0; n < one.terms(); ++n) EXPECT_NEAR(one[n], other[n], 1e-14) << n;
}

// 1/(1 − s/2) has the coefficients 2⁻ⁿ; its square root squared, and a product divided again, are what they
// were.
TEST(Jets, DivisionAndRootUndoProducts) {
  const Jet line = jet(terms, [](std::size_t n) { return n == 0 ? 1.0 : n == 1 ? -0.5 : 0.0; });
  const Jet quotient = one / line;
  for (std::size_t n = 0; n < terms; ++n) EXPECT_EQ(quotient[n], std::pow(0.5, n));
  expect_same(quotient * line, one);
  expect_same(sqrt(line) * sqrt(line), line);
}

// sin² + cos² = 1, and (sin a)(sin a) of a = s is (1 − cos 2s)/2.
TEST(Jets, SineAndCosineLieOnTheCircle) {
  const auto [sine, cosine] = sine_cosine(jet(terms, [](std::size_t n) { return 0.3 / (1.0 + n); }));
  expect_same(sine * sine + cosine * cosine, one);
  const Jet s = jet(terms, [](std::size_t n) { return n == 1 ? 1.0 : 0.0; });
  expect_same(sine_cosine(s).sine * sine_cosine(s).sine, 0.5 * (one - sine_cosine(2 * s).cosine));
}

}  // namespace
}  // namespace rockstack
