#include "plots/drawing/axes.hpp"

#include <gtest/gtest.h>

namespace rockstack::plots {
namespace {

TEST(LinearTics, AreRoundAndHaveRoom) {
  EXPECT_EQ(linear_tics("y", 0, 1, 300), "set ytics 0.1\n");
  EXPECT_EQ(linear_tics("y", -3, 4, 110), "set ytics 2\n");
  EXPECT_EQ(linear_tics("x", 0, 0.3, 340), "set xtics 0.1\n");
}

TEST(LogarithmicTics, ArePowersOfTenAndWithinTwoDecadesTheirMultiplesToo) {
  EXPECT_EQ(logarithmic_tics("x", 1e-4, 1e-2, 300), "set format x '10^{%T}'\nset xtics 0.0001, 10\n");
  EXPECT_EQ(logarithmic_tics("x", 1e-6, 1e-1, 300), "set format x '10^{%T}'\nset xtics 1e-06, 100\n");
  EXPECT_EQ(logarithmic_tics("y", 0.02, 0.5, 300),
            "set ytics ('3·10^{-2}' 0.03, '10^{-1}' 0.1, '3·10^{-1}' 0.3)\n");
  EXPECT_EQ(logarithmic_tics("y", 0.2, 0.9, 300),
            "set ytics ('2·10^{-1}' 0.2, '3·10^{-1}' 0.3, '5·10^{-1}' 0.5, '7·10^{-1}' 0.7)\n");
  EXPECT_EQ(logarithmic_tics("x", 0.027, 0.08, 185), "set xtics ('3.5·10^{-2}' 0.035, '6·10^{-2}' 0.06)\n");
}

}  // namespace
}  // namespace rockstack::plots
