#include <gtest/gtest.h>

#include <sstream>

#include "tests/analytic/proof/proved_table.hpp"
#include "tests/analytic/proof/step.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack::proof {
namespace {

TEST(ProvedNumbers, DecimalBoundsHoldTheirNumber) {
  const Precision bits(128);
  const auto [lower, upper] = decimal_bounds(Ball(decimal("2")) / Ball(3), 6);
  EXPECT_EQ(lower, "0.666666");
  EXPECT_EQ(upper, "0.666667");
  const DecimalBounds below = decimal_bounds(Ball(decimal("-0.0125")) + within(Ball(decimal("0.0001"))), 3);
  EXPECT_EQ(below.lower, "-0.013");
  EXPECT_EQ(below.upper, "-0.012");
}

TEST(ProvedNumbers, DecimalTextsAreFractions) {
  EXPECT_EQ(decimal("-1.25e-2").text(), "-1/80");
  EXPECT_EQ(decimal(0.1).text(), "1/10");
  EXPECT_THROW(decimal("one"), std::invalid_argument);
}

/// Coefficients of a guard, at 128 bits.
struct Coefficients {
  explicit Coefficients(const std::vector<int>& values)
      : size(static_cast<slong>(values.size())), data(_arb_vec_init(size)) {
    for (slong n = 0; n < size; ++n) arb_set_si(data + n, values[static_cast<std::size_t>(n)]);
  }
  ~Coefficients() { _arb_vec_clear(data, size); }
  Coefficients(const Coefficients&) = delete;
  Coefficients& operator=(const Coefficients&) = delete;
  slong size;
  arb_ptr data;
};

ZeroSearch zero_of(const std::vector<int>& polynomial, int zeros, double bound) {
  const Precision bits(128);
  const Coefficients coefficients(polynomial);
  return first_zero({coefficients.data, coefficients.size, zeros, 1, Ball(bound), Ball(64)}, Ball(4));
}

const std::vector<int> padding(60, 0);
std::vector<int> padded(std::vector<int> polynomial) {
  polynomial.insert(polynomial.end(), padding.begin(), padding.end());
  return polynomial;
}

TEST(ProvedZero, FirstOfTwoIsFoundPastAnExactOne) {
  // t (7 − 5t)(3 − t)
  const ZeroSearch found = zero_of(padded({0, 21, -22, 5}), 1, 64);
  ASSERT_TRUE(found.zero);
  EXPECT_TRUE(arb_contains_fmpq(found.zero->data(), decimal("1.4").data()));
  EXPECT_LT(width_exponent(*found.zero), -100);
}

TEST(ProvedZero, DoubleZeroDecidesNothing) {
  EXPECT_THROW(zero_of(padded({4, -4, 1}), 0, 64), Undecided);  // (2 − t)²
}

TEST(ProvedZero, LargeRemainderDecidesNothing) {
  EXPECT_THROW(zero_of({3, -4, 1}, 0, 1e9), Undecided);  // three coefficients leave out too much
}

TEST(ProvedTable, ChatterBelowAMicrosecondIsLeftOut) {
  const Precision bits(192);
  Proof proof;
  const auto add = [&](EventKind kind, double time, Pattern from, Pattern to) {
    proof.events.push_back({kind, 0, std::move(from), std::move(to), Ball(time), {Ball(0)}, {Ball(0)}});
  };
  add(EventKind::impact, 1.0, {1}, {-1});
  add(EventKind::impact, 1.25, {-1}, {1});
  add(EventKind::impact, 1.25 + 1e-7, {1}, {-1});
  add(EventKind::accumulation, 1.25 + 2e-7, {-1}, {0});
  std::ostringstream output;
  write_table(output, proof);
  const std::string text = output.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_NE(text.find("\nrest,1,L,C,1.25"), std::string::npos);
}

}  // namespace
}  // namespace rockstack::proof
