#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analytic/unilateral/springs/spring_rounding.hpp"
#include "analytic/unilateral/springs/spring_series.hpp"
#include "tests/analytic/unilateral/scenes.hpp"
#include "tests/analytic/unilateral/solve_unilateral.hpp"
#include "tests/analytic/unilateral/springs/random_springs.hpp"

namespace rockstack {
namespace {

/// The right end of an interface: a corner of the upper block that slides to the right.
struct SlidingEnd {
  Scene scene;
  ContactModel<> stack;
  Bodies<> bodies;
  SpringPoint<double> point;

  double elastic() const { return elastic_energy(stack, point, bodies); }
  ContactKinematics<double> rows() const { return kinematics_of(stack, bodies, point); }
  double stretch() const { return rows().slip - point.slider; }
};

/// The corner is `inside` the end of its face and `depth` under it, its spring stretched by `stretch`.
SlidingEnd sliding_end(double angle, double inside, double depth, double stretch, double tangential,
                       double friction = 0.5, double damping = 0) {
  Scene scene;
  scene.law = Law::compliant;
  scene.blocks = {make_block(1.1, 0.8, 1000), make_block(0.9, 1.3, 1000)};
  scene.initial = {{0, 0}, {0, 0}};
  scene.friction = {1, friction};
  scene.springs = {};
  scene.springs.stiffness = {1e6, 1e6};
  scene.springs.damping = {0, damping};
  scene.springs.tangential = tangential;
  SlidingEnd end{scene, contact_model_of<double>(scene), {}, {}};
  const Point<double> corner(0.55 - inside, 0.8 - depth);
  const Point<double> middle = corner - turned<double>({0.45, -0.65}, angle);
  end.bodies.pose = {{0, 0.4, 0}, {middle.x(), middle.y(), angle}};
  end.bodies.velocity = {{0, 0, 0}, {0, 0, 0}};
  end.point.interface = 1;
  end.point.side = 1;
  end.point.press = Press::pushing;
  end.point.slide = 1;
  end.point.slider = end.rows().slip - stretch;
  return end;
}

void pass(SlidingEnd& end) {
  pass_to_other_corner(end.stack, end.bodies, end.point);
}

// Depths round as places of a metre do, ten times, and stretches as what depths leave of them.
TEST(CornerPass, CarriesDepthAndStretchOverWhereBothCornersAreAsFarInside) {
  for (const double angle : {-0.3, -1e-3, 1e-3, 0.3})
    for (const double tangential : {0.1, 1.0, 3.0}) {
      SlidingEnd end = sliding_end(angle, 0.01 * std::tan(angle / 2), 0.01, 0.004, tangential);
      pass(end);
      EXPECT_TRUE(end.point.corner_below);
      EXPECT_NEAR(end.rows().gap, -0.01, 1e-15);
      EXPECT_NEAR(end.stretch(), 0.004, 1e-15 * (1 + 0.01 / (0.004 * tangential)));
    }
}

// One spring between corner and slider, which is the other corner: as the face turns it stays as it is, and
// the slider comes to be where the corner is, at the end of the other face.
TEST(CornerPass, LeavesASpringThatIsAlikeInAllDirectionsAsItIs) {
  for (const double angle : {-0.2, 0.2}) {
    SlidingEnd end = sliding_end(angle, -0.004, 0.01, 0.004, 1);
    pass(end);
    EXPECT_NEAR(end.point.slider, -0.45, 1e-14);
  }
}

// With the slider at the end of its face: what springs hold goes over, or where they hold less than the other
// corner's depth stands for, they are left with that. Energies round as stiffness times depths of a metre.
TEST(CornerPass, KeepsWhatSpringsHoldOrGainsWhatTheLawSays) {
  testing::Draw draw(7);
  int gained = 0;
  int lost = 0;
  for (int i = 0; i < 10000; ++i) {
    const double angle = draw.between(-0.3, 0.3);
    const double depth = draw.between(0, 0.02);
    const double stretch = draw.between(0, 0.01);
    const double tangential = std::pow(10, draw.between(-1, 0.7));
    SlidingEnd end = sliding_end(angle, -stretch, depth, stretch, tangential);
    const double stiffness = end.scene.springs.stiffness[1];
    const double before = end.elastic();
    pass(end);
    const double after = end.elastic();
    const double other = depth * std::cos(angle) - stretch * std::sin(angle);
    const double rounding = 1e-15 * stiffness * 0.02;
    if (other <= 0) {
      ++lost;
      EXPECT_EQ(end.point.press, Press::off);
      EXPECT_EQ(after, 0);
    } else if (stiffness * other * other / 2 > before + rounding) {
      ++gained;
      EXPECT_LT(angle, 0);
      EXPECT_NEAR(after, stiffness * other * other / 2, rounding);
      const double square = std::pow(std::sin(angle), 2);
      EXPECT_LE(after - before,
                stiffness / 2 * depth * depth * square * (1 - tangential) / (tangential - square) + rounding);
    } else {
      EXPECT_NEAR(after, before, rounding);
    }
  }
  EXPECT_GT(gained, 100);
  EXPECT_GT(lost, 100);
}

// Without a dashpot a stretch is at most that of μN. What slips back is rubbed; what is below it sticks.
TEST(CornerPass, SlipsBackAtOnceWithoutADashpot) {
  for (const double angle : {0.1, -0.1}) {
    SlidingEnd end = sliding_end(angle, -0.005, 0.01, 0.005, 1);
    pass(end);
    const double held = end.elastic();
    const double rubbed = slip_at_once(end.stack, end.bodies, end.point);
    EXPECT_NEAR(held - end.elastic(), rubbed, 1e-12);
    const double most = 0.5 * -end.rows().gap;
    if (angle > 0) {
      EXPECT_EQ(end.point.slide, 1);
      EXPECT_GT(rubbed, 0);
      EXPECT_NEAR(end.stretch(), most, 1e-15);
    } else {
      EXPECT_EQ(end.point.slide, 0);
      EXPECT_EQ(rubbed, 0);
      EXPECT_LT(end.stretch(), most);
    }
  }
  SlidingEnd damped = sliding_end(0.1, -0.005, 0.01, 0.005, 1, 0.5, 1e3);
  pass(damped);
  EXPECT_EQ(slip_at_once(damped.stack, damped.bodies, damped.point), 0);
  EXPECT_EQ(damped.point.slide, 1);
}

/// A random stack whose blocks slide off one another: half of them of one width, from no friction to more
/// than one, without dashpots or with those that are more than critical.
Scene sliding_scene(std::uint64_t seed) {
  testing::Draw draw(seed);
  Scene scene;
  scene.law = Law::compliant;
  scene.duration = 0.5;
  const int size = 2 + draw.below(2);
  const double width = draw.between(0.5, 1.5);
  double mass = 0;
  for (int k = 0; k < size; ++k) {
    scene.blocks.push_back(
        make_block(draw.coin() ? width : draw.between(0.5, 1.5), draw.between(0.4, 2), 1000));
    mass += scene.blocks.back().mass;
    const int kind = k == 0 ? 2 : draw.below(6);
    scene.friction.push_back(kind == 0   ? 0
                             : kind == 1 ? std::pow(10, draw.between(-4, -1))
                                         : draw.between(0.3, 1.5));
  }
  const auto blocks = static_cast<std::size_t>(size);
  scene.initial.angles.assign(blocks, draw.coin() ? 0 : draw.between(-0.1, 0.1));
  for (std::size_t k = 0; k < blocks; ++k) {
    if (k > 0)
      scene.initial.angles[k] = scene.initial.angles[k - 1] + draw.below(2) * draw.between(-0.1, 0.1);
    scene.initial.velocities.push_back(draw.below(2) * draw.between(-0.5, 0.5));
    const double stiffness = mass * std::pow(10, draw.between(2.3, 4.3));
    const double ratio = draw.below(3) == 0 ? 0 : std::pow(10, draw.between(-2, 0.3));
    scene.springs.stiffness.push_back(stiffness);
    scene.springs.damping.push_back(2 * ratio * std::sqrt(stiffness * mass));
  }
  scene.initial.preloaded = draw.coin();
  scene.springs.tangential = std::pow(10, draw.between(-1, 0.7));
  scene.inclination = draw.below(2) * draw.between(-0.12, 0.12);
  return scene;
}

TEST(CornerPass, NeitherLosesEnergyNorMakesAnyInRandomScenes) {
  int passes = 0;
  int frictionless = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const Scene scene = sliding_scene(seed);
    const History history = solve_unilateral(scene, {.sample_times = regular_times(0.01, scene.duration)});
    const double rounding = 1e-11 * testing::weight_times_height(scene);
    const double first = testing::energy_with_losses(scene, samples_of(history).front());
    double taken = 0;
    for (const auto& sample : samples_of(history)) {
      EXPECT_NEAR(testing::energy_with_losses(scene, sample), first, rounding) << seed << ' ' << sample.time;
      double now = 0;
      for (const auto& springs : sample.springs) now += springs.damped + springs.rubbed;
      EXPECT_GE(now, taken - rounding) << seed << ' ' << sample.time;
      taken = now;
    }
    for (const Event& event : history.events) {
      if (event.kind != EventKind::corner) continue;
      ++passes;
      frictionless += scene.friction[static_cast<std::size_t>(event.interface - 1)] == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(passes, 50);
  EXPECT_GT(frictionless, 5);
}

}  // namespace
}  // namespace rockstack
