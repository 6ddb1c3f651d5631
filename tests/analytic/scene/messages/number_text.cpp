#include "analytic/scene/messages/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockstack {
namespace {

TEST(QuantityText, HasTheUnitThatSuitsItsSize) {
  EXPECT_EQ(quantity_text(3.6697, "m"), "3.67 m");
  EXPECT_EQ(quantity_text(0.0864, "m", 2), "86 mm");
  EXPECT_EQ(quantity_text(1e-4, "s"), "0.1 ms");
  EXPECT_EQ(quantity_text(1.25e-5, "rad"), "12.5 µrad");
  EXPECT_EQ(quantity_text(3669.7, "m"), "3670 m");
  EXPECT_EQ(quantity_text(-0.002, "s"), "-2 ms");
}

TEST(QuantityText, ANumberIsRoundedBeforeItsUnitIsChosen) {
  EXPECT_EQ(quantity_text(0.99996, "m"), "1 m");
  EXPECT_EQ(quantity_text(9.9996e-5, "s"), "0.1 ms");
}

TEST(QuantityText, RoundingIsZero) {
  EXPECT_EQ(quantity_text(0, "m"), "0 m");
  EXPECT_EQ(quantity_text(-3e-17, "m"), "0 m");
  EXPECT_EQ(signed_quantity_text(3e-17, "s"), "0 s");
  EXPECT_EQ(signed_quantity_text(4e-4, "s"), "+0.4 ms");
}

TEST(NumberText, AnExponentIsAPowerOfTen) {
  EXPECT_EQ(with_power("3.1e-05"), "3.1 × 10⁻⁵");
  EXPECT_EQ(with_power("1e+12"), "1 × 10¹²");
  EXPECT_EQ(with_power("0.001"), "0.001");
}

TEST(NumberText, TwoDigitsThatAreNotLessOrNotMore) {
  EXPECT_DOUBLE_EQ(two_digits_up(0.2039), 0.21);
  EXPECT_DOUBLE_EQ(two_digits_down(0.2039), 0.2);
  EXPECT_DOUBLE_EQ(two_digits_up(1060), 1100);
  EXPECT_DOUBLE_EQ(two_digits_up(0.999), 1);
  for (const double same : {0.3, 0.21, 1.7, 23.0, 4e-5}) {  // whatever the roundings of their digits
    EXPECT_DOUBLE_EQ(two_digits_up(same), same);
    EXPECT_DOUBLE_EQ(two_digits_down(same), same);
  }
  EXPECT_EQ(two_digits_up(0), 0);
  EXPECT_EQ(two_digits_up(INFINITY), INFINITY);
}

}  // namespace
}  // namespace rockstack
