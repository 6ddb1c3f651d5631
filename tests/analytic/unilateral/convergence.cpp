#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/analytic/unilateral/scenes.hpp"
#include "tests/analytic/unilateral/time_stepping.hpp"

namespace rockstack {
namespace {

/// Blocks that slide on a shaken ground which falls away under them for a while, and land.
Scene thrown(std::uint64_t seed) {
  testing::Draw draw(900 + seed);
  const int size = 1 + static_cast<int>(seed % 2);
  std::vector<Block> blocks;
  blocks.reserve(2);
  for (int k = 0; k < size; ++k)
    blocks.push_back(testing::block(draw.between(0.5, 1), draw.between(0.5, 1.2)));
  Scene scene =
      testing::released(std::move(blocks), std::vector<double>(static_cast<std::size_t>(size), 0), 0.45);
  const double g = scene.gravity;
  scene.horizontal =
      testing::pulse_of(PulseShape::sine, draw.between(0.5, 1) * g * (draw.coin() ? 1 : -1), 0.3, 0.01);
  scene.vertical = testing::pulse_of(PulseShape::half_sine, -draw.between(1.5, 2.5) * g, 0.12, 0.1);
  for (int k = 0; k < size; ++k) scene.friction.push_back(draw.between(0.1, 0.5));
  return scene;
}

double distance(const Bodies<>& one, const Bodies<>& other) {
  double largest = 0;
  for (std::size_t k = 0; k < one.pose.size(); ++k) {
    largest = std::max({largest, std::abs(one.pose[k].x - other.pose[k].x),
                        std::abs(one.pose[k].y - other.pose[k].y),
                        std::abs(one.pose[k].angle - other.pose[k].angle)});
  }
  return largest;
}

/// The slope of a straight line through points, by least squares.
double slope(const std::vector<std::pair<double, double>>& points) {
  double x = 0;
  double y = 0;
  for (const auto& point : points) {
    x += point.first / double(points.size());
    y += point.second / double(points.size());
  }
  double above = 0;
  double below = 0;
  for (const auto& point : points) {
    above += (point.first - x) * (point.second - y);
    below += (point.first - x) * (point.first - x);
  }
  return above / below;
}

bool slips_and_flies(const History& history) {
  bool slips = false;
  bool flies = false;
  for (const Event& event : history.events) {
    slips |= name(event.to).find_first_of("<>") != std::string::npos;
    flies |= name(event.to).find('-') != std::string::npos;
  }
  return slips && flies;
}

// Where within a step its events fall makes an error anything between zero and its bound, C step. So one pair
// of steps says little of the order, and the mean over scenes of each scene's fit is that of the law to its
// own standard error, here below 0.1: orders 1/2 and 2 are five of them and more away.
TEST(UnilateralConvergence, TimeStepsOfMoreauApproachItWithOrderOne) {
  constexpr int scenes = 20;
  double sum = 0;
  double squares = 0;
  for (std::uint64_t seed = 0; seed < scenes; ++seed) {
    const Scene scene = thrown(seed);
    const History history = solve_unilateral(scene);
    EXPECT_TRUE(slips_and_flies(history)) << seed;
    ASSERT_FALSE(ends_early(history)) << seed;
    std::vector<std::pair<double, double>> errors;
    for (const double step : {1e-3, 0.8e-3, 0.125e-3, 0.1e-3}) {
      const double error = distance(bodies_at_end(history), testing::time_stepped(scene, step));
      // No step of any scene leaves out more: the bound C, in m/s and rad/s.
      EXPECT_LT(error, 2 * step) << seed << ' ' << step;
      errors.emplace_back(std::log(step), std::log(error));
    }
    const double order = slope(errors);
    sum += order / scenes;
    squares += order * order / scenes;
  }
  const double standard_error = std::sqrt((squares - sum * sum) / (scenes - 1));
  EXPECT_LT(standard_error, 0.1);
  EXPECT_NEAR(sum, 1, 3 * standard_error);
}

// Sweeps that stop later show what those that stop at 10⁻⁹ leave out: no more than they may, and far less
// than steps do.
TEST(UnilateralConvergence, SweepsOfTheTimeStepperHaveEnded) {
  constexpr double step = 1e-3;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = thrown(seed);
    const double left_out = 1e-9 * scene.gravity * scene.duration * scene.duration;
    const Bodies<> stepped = testing::time_stepped(scene, step);
    const Bodies<> swept = testing::time_stepped(scene, step, 1e-12);
    EXPECT_LT(distance(stepped, swept), left_out) << seed;
    EXPECT_LT(left_out, 1e-3 * distance(bodies_at_end(solve_unilateral(scene)), stepped)) << seed;
  }
}

}  // namespace
}  // namespace rockstack
