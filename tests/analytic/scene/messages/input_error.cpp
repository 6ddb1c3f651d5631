#include "analytic/scene/messages/input_error.hpp"

#include <gtest/gtest.h>

namespace rockstack {
namespace {

TEST(NearWord, IsOneThatASlipOfTheKeyboardMayHaveMeant) {
  const std::vector<std::string> names{"width", "height", "mass"};
  EXPECT_EQ(did_you_mean("heigth", names), "; did you mean height?");
  EXPECT_EQ(did_you_mean("widht", names), "; did you mean width?");
  EXPECT_EQ(did_you_mean("hieght", names), "; did you mean height?");
  EXPECT_EQ(did_you_mean("widths", names), "; did you mean width?");
  EXPECT_EQ(did_you_mean("ass", names), "; did you mean mass?");
  EXPECT_EQ(did_you_mean("colour", names), "");
  EXPECT_EQ(did_you_mean("", names), "");
  EXPECT_EQ(did_you_mean("width", {}), "");
}

TEST(NearWord, IsTheNearestAndOfTwoTheFirst) {
  EXPECT_EQ(did_you_mean("bulet", {"ballets", "bullet"}), "; did you mean bullet?");
  EXPECT_EQ(did_you_mean("lamp", {"damp", "camp"}), "; did you mean damp?");
}

}  // namespace
}  // namespace rockstack
