#include "analytic/scene/kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rockstack {
namespace {

using std::cos;
using std::sin;

/// Three blocks, the middle one the widest.
Stack<double> three_blocks() {
  Scene scene;
  scene.blocks = {{0.6, 0.5, 3.0, 1.0}, {0.7, 1.25, 2.0, 1.0}, {0.4, 0.75, 1.0, 1.0}};
  return make_stack<double>(scene);
}

Vector<double> three(double first, double second, double third) {
  Vector<double> result(3);
  result << first, second, third;
  return result;
}

Pattern word(Contact first, Contact second, Contact third) {
  Pattern pattern = closed_pattern(3);
  pattern[0] = first;
  pattern[1] = second;
  pattern[2] = third;
  return pattern;
}

const Pattern right_left_right = word(Contact::right, Contact::left, Contact::right);

// A polynomial's terms are rounded each: cosine and sine are off by little more than a unit in their last
// place, on both sides of where the library takes over, and a mirrored angle has the mirrored direction.
TEST(Kinematics, DirectionsAreThoseOfTheLibraryToAUnitInTheLastPlace) {
  const double unit = std::numeric_limits<double>::epsilon();
  for (int i = 0; i < 20000; ++i) {
    const double angle = i < 16000 ? 1.6 * i / 16000 : std::ldexp(1 + i / 20000.0, -(i % 60));
    const PlaneDirection<double> direction = direction_of(angle);
    EXPECT_NEAR(direction.cosine, std::cos(angle), 1.25 * unit * std::abs(std::cos(angle)) + 1e-300) << angle;
    EXPECT_NEAR(direction.sine, std::sin(angle), 1.25 * unit * std::sin(angle)) << angle;
    const PlaneDirection<double> mirrored = direction_of(-angle);
    EXPECT_EQ(mirrored.cosine, direction.cosine) << angle;
    EXPECT_EQ(mirrored.sine, -direction.sine) << angle;
  }
}

TEST(Kinematics, AWiderUpperBlockPivotsOnTheLowerOnesCorner) {
  const Stack<double> stack = three_blocks();
  EXPECT_EQ(stack.half_width[0], 0.6);
  EXPECT_EQ(stack.half_width[1], 0.6);
  EXPECT_EQ(stack.half_width[2], 0.4);
}

TEST(Kinematics, CentresOfAClosedUprightStackStandAboveEachOther) {
  const auto result = centres(make_chain(three_blocks(), closed_pattern(3), three(0, 0, 0)));
  const double heights[] = {0.5, 1.0 + 1.25, 3.5 + 0.75};
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(result(0, k), 0.0);
    EXPECT_EQ(result(1, k), heights[k]);
  }
}

TEST(Kinematics, EqualAnglesAreARigidRotationAboutTheLowestPivot) {
  const Stack<double> stack = three_blocks();
  const double angle = 0.3;
  const auto upright = centres(make_chain(stack, closed_pattern(3), three(0, 0, 0)));
  for (const Contact end : {Contact::left, Contact::right}) {
    // The other interfaces' pivots carry no relative rotation, so they must not matter.
    for (const Contact other : {Contact::left, Contact::closed, Contact::right}) {
      const double pivot = sign(end) * stack.half_width[0];
      const double turn = sign(end) * angle;
      const auto tilted = centres(make_chain(stack, word(end, other, other), three(turn, turn, turn)));
      for (int k = 0; k < 3; ++k) {
        const double x = upright(0, k) - pivot;
        const double y = upright(1, k);
        // A dozen roundings of numbers below 5: 12 × 5 × 2⁻⁵³ = 7e-15.
        EXPECT_NEAR(tilted(0, k), pivot + x * cos(turn) + y * sin(turn), 7e-15);
        EXPECT_NEAR(tilted(1, k), y * cos(turn) - x * sin(turn), 7e-15);
      }
    }
  }
}

TEST(Kinematics, PositiveAnglesLeanToTheRight) {
  const auto result = centres(make_chain(three_blocks(), closed_pattern(3), three(0.1, 0.1, 0.1)));
  EXPECT_GT(result(0, 0), 0.0);
  EXPECT_GT(result(0, 2), result(0, 0));
}

TEST(Kinematics, RelativeAndAbsoluteAreInverse) {
  // Multiples of a power of two: sums and differences are exact.
  const Vector<double> angles = three(0.125, -0.25, 0.0625);
  EXPECT_EQ(relative(angles), three(0.125, -0.375, 0.3125));
  EXPECT_EQ(absolute(relative(angles)), angles);
  EXPECT_EQ(relative(absolute(angles)), angles);
}

TEST(Kinematics, CentreVelocitiesAreTheRatesOfCentres) {
  const Stack<double> stack = three_blocks();
  const Vector<double> angles = three(0.2, 0.05, 0.11);
  const Vector<double> rates = three(0.7, -0.4, 0.9);
  const double step = 1e-5;
  const auto ahead = centres(make_chain<double>(stack, right_left_right, angles + step * rates));
  const auto behind = centres(make_chain<double>(stack, right_left_right, angles - step * rates));
  const Points<double> slope = (ahead - behind) / (2 * step);
  const auto velocities = centre_velocities(make_chain(stack, right_left_right, angles), rates);
  // The central difference leaves step²/6 × the third rate, which is |ω|³ × length summed over the chain,
  // below 0.9³ × 7 m; rounding leaves about 12 × 5 × 2⁻⁵³ / step.
  const double tolerance = step * step / 6 * 5.2 + 7e-15 / step;
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(velocities(0, k), slope(0, k), tolerance);
    EXPECT_NEAR(velocities(1, k), slope(1, k), tolerance);
  }
}

TEST(Kinematics, AMirroredStackHasMirroredCentresToTheLastBit) {
  const Stack<double> stack = three_blocks();
  const Vector<double> angles = three(0.2, 0.05, 0.11);
  const Vector<double> rates = three(0.7, -0.4, 0.9);
  const Pattern mirrored = word(Contact::left, Contact::right, Contact::left);
  const auto chain = make_chain(stack, right_left_right, angles);
  const auto mirror = make_chain<double>(stack, mirrored, -angles);
  const auto here = centres(chain);
  const auto there = centres(mirror);
  const auto velocity_here = centre_velocities(chain, rates);
  const auto velocity_there = centre_velocities(mirror, -rates);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(there(0, k), -here(0, k));
    EXPECT_EQ(there(1, k), here(1, k));
    EXPECT_EQ(velocity_there(0, k), -velocity_here(0, k));
    EXPECT_EQ(velocity_there(1, k), velocity_here(1, k));
  }
}

TEST(Kinematics, PatternFollowsAnglesAndWhereTheyAreZeroVelocities) {
  EXPECT_EQ(pattern_of(three(0.1, 0, 0), three(-1, -1, 0)),
            word(Contact::right, Contact::left, Contact::closed));
  EXPECT_EQ(pattern_of(three(-0.1, 0, 0), three(1, 1, 0)),
            word(Contact::left, Contact::right, Contact::closed));
}

}  // namespace
}  // namespace rockstack
