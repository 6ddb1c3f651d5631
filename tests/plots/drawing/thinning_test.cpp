#include "plots/drawing/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace rockstack::plots {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

Curve noise(std::size_t points) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> value(-1, 1);
  Curve curve;
  for (std::size_t i = 0; i < points; ++i) {
    curve.times.push_back(static_cast<double>(i));
    curve.values.push_back(value(generator));
  }
  return curve;
}

bool has_point(const Curve& curve, double time, double value) {
  for (std::size_t i = 0; i < curve.size(); ++i)
    if (curve.times[i] == time && curve.values[i] == value) return true;
  return false;
}

// 1024 points at 0, 1, … 1023 and 16 bins: bin b holds the indices i with 16 i / 1023 in [b, b + 1).
TEST(Thinning, KeepsTheSmallestAndTheLargestValueOfEveryBinAtTheirTimes) {
  const Curve curve = noise(1024);
  const Curve thinned = thin(curve, endless, 16);
  EXPECT_LE(thinned.size(), 2u * 16u + 2u);
  for (std::size_t bin = 0; bin < 16; ++bin) {
    std::size_t low = curve.size(), high = curve.size();
    for (std::size_t i = 0; i < curve.size(); ++i) {
      if (std::min<std::size_t>(16 * i / 1023, 15) != bin) continue;
      if (low == curve.size() || curve.values[i] < curve.values[low]) low = i;
      if (high == curve.size() || curve.values[i] > curve.values[high]) high = i;
    }
    EXPECT_TRUE(has_point(thinned, curve.times[low], curve.values[low])) << bin;
    EXPECT_TRUE(has_point(thinned, curve.times[high], curve.values[high])) << bin;
  }
}

TEST(Thinning, KeepsTimesInOrderAndBothEnds) {
  const Curve curve = noise(5000);
  const Curve thinned = thin(curve, endless, 100);
  EXPECT_TRUE(std::is_sorted(thinned.times.begin(), thinned.times.end()));
  EXPECT_EQ(thinned.times.front(), curve.times.front());
  EXPECT_EQ(thinned.times.back(), curve.times.back());
  EXPECT_EQ(thinned.values.back(), curve.values.back());
}

TEST(Thinning, LeavesAShortCurveAsItIs) {
  const Curve curve = noise(40);
  const Curve thinned = thin(curve, endless, 20);
  EXPECT_EQ(thinned.times, curve.times);
  EXPECT_EQ(thinned.values, curve.values);
}

// A curve a hundred times as long keeps as many points on the axis, and the next one.
TEST(Thinning, LooksAtTheTimeThatIsShownAlone) {
  const Curve curve = noise(100'000);
  Curve part;
  for (std::size_t i = 0; i <= 1000; ++i) part.add(curve.times[i], curve.values[i]);
  const Curve thinned = thin(curve, 999.5, 50), expected = thin(part, endless, 50);
  EXPECT_EQ(thinned.times, expected.times);
  EXPECT_EQ(thinned.values, expected.values);
  EXPECT_EQ(envelope(curve, 999.5, 50, 1e-6).values, envelope(part, endless, 50, 1e-6).values);
}

TEST(Thinning, DropsWhatIsNotFiniteAndTakesEmptyCurves) {
  const Curve thinned = thin(Curve{{0, 1, 2}, {1, endless, std::nan("")}}, endless, 1);
  EXPECT_EQ(thinned.values, std::vector<double>{1});
  EXPECT_EQ(thin(Curve{}, endless, 5).size(), 0u);
  EXPECT_EQ(envelope(Curve{}, endless, 5, 1e-6).size(), 0u);
}

TEST(Thinning, TakesCurvesWhoseTimesAreAllTheSame) {
  const Curve curve{std::vector<double>(50, 2.0), std::vector<double>(50, 3.0)};
  EXPECT_EQ(thin(curve, endless, 4).values.back(), 3.0);
  EXPECT_EQ(envelope(curve, endless, 4, 1e-6).values, std::vector<double>{3.0});
}

TEST(Envelope, HoldsTheLargestSizeOfEveryBinAndNeverLessThanTheFloor) {
  const Curve curve{{0, 1, 2, 3, 4, 5, 6, 7}, {1, -5, 2, 0, 0, 0, -3, 2}};
  const Curve outer = envelope(curve, endless, 4, 0.5);
  EXPECT_EQ(outer.times, (std::vector<double>{1, 2, 4, 6}));
  EXPECT_EQ(outer.values, (std::vector<double>{5, 2, 0.5, 3}));
}

TEST(Simplified, KeepsThePathWithinTheToleranceAndDropsWhatLiesOnLines) {
  Curve circle;
  constexpr int points = 1000;
  for (int i = 0; i <= points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    circle.times.push_back(std::cos(angle));
    circle.values.push_back(std::sin(angle));
  }
  const Curve few = simplified(circle, 1e-3);
  EXPECT_LT(few.size(), 200u);
  // A chord that leaves the unit circle by the tolerance, of an extent of 2, spans an angle of 2 acos(1 −
  // 2e-3).
  EXPECT_GT(few.size(), static_cast<std::size_t>(2 * std::numbers::pi / (2 * std::acos(1 - 2e-3))));
  for (std::size_t i = 0; i + 1 < few.size(); ++i) {
    const double x = (few.times[i] + few.times[i + 1]) / 2, y = (few.values[i] + few.values[i + 1]) / 2;
    EXPECT_GT(std::hypot(x, y), 1 - 2e-3 - 1e-5);  // points lie 1/1000 of a turn apart
  }
  EXPECT_EQ(simplified({{0, 1, 2, 3}, {0, 1, 2, 0}}, 1e-6).times, (std::vector<double>{0, 2, 3}));
}

}  // namespace
}  // namespace rockstack::plots
