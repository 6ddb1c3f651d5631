#include "comparisons/measures/results/sentences.hpp"

#include <gtest/gtest.h>

namespace rockstack {
namespace {

TEST(AxisTitle, HasTheUnitOfTheKey) {
  EXPECT_EQ(axis_title("ground.horizontal.period"), "ground.horizontal.period (s)");
  EXPECT_EQ(axis_title("ground.vertical.period"), "ground.vertical.period (s)");
  EXPECT_EQ(axis_title("blocks.2.height"), "blocks.2.height (m)");
  EXPECT_EQ(axis_title("initial.angles.1"), "initial.angles.1 (rad)");
  EXPECT_EQ(axis_title("gravity"), "gravity (m/s²)");
  EXPECT_EQ(axis_title("contact.stiffness"), "contact.stiffness (N/m)");
  EXPECT_EQ(axis_title("contact.friction"), "contact.friction");
  EXPECT_EQ(axis_title("ground.horizontal.synthetic"), "ground.horizontal.synthetic");
  EXPECT_EQ(axis_title("ground.horizontal.peak"), "peak ground acceleration (m/s²)");
}

}  // namespace
}  // namespace rockstack
