#include "analytic/scene/pattern.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rockstack {
namespace {

Pattern two(Contact lower, Contact upper) {
  Pattern pattern = closed_pattern(2);
  pattern[0] = lower;
  pattern[1] = upper;
  return pattern;
}

TEST(Pattern, TwoBlocksHaveTheNamesOfThePaper) {
  using enum Contact;
  // Spanos et al. 2001, Fig. 2.
  EXPECT_EQ(name(two(right, right)), "1a");
  EXPECT_EQ(name(two(left, left)), "1b");
  EXPECT_EQ(name(two(right, left)), "2a");
  EXPECT_EQ(name(two(left, right)), "2b");
  EXPECT_EQ(name(two(right, closed)), "3a");
  EXPECT_EQ(name(two(left, closed)), "3b");
  EXPECT_EQ(name(two(closed, right)), "4a");
  EXPECT_EQ(name(two(closed, left)), "4b");
  EXPECT_EQ(name(two(closed, closed)), "rest");
}

TEST(Pattern, OtherStacksAreSpelledFromTheGroundUp) {
  Pattern pattern = closed_pattern(3);
  EXPECT_EQ(name(pattern), "CCC");
  EXPECT_TRUE(is_closed(pattern));
  pattern[0] = Contact::left;
  pattern[2] = Contact::right;
  EXPECT_EQ(name(pattern), "LCR");
  EXPECT_FALSE(is_closed(pattern));
  EXPECT_EQ(name(closed_pattern(1)), "C");
}

TEST(Pattern, OppositeSwapsTheEndsAndKeepsClosed) {
  EXPECT_EQ(opposite(Contact::left), Contact::right);
  EXPECT_EQ(opposite(Contact::right), Contact::left);
  EXPECT_EQ(opposite(Contact::closed), Contact::closed);
}

}  // namespace
}  // namespace rockstack
