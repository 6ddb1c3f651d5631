#include "analytic/round/round.hpp"

#include <gtest/gtest.h>

#include "analytic/solve.hpp"

namespace rockstack {
namespace {

constexpr double g = 9.81;

RoundScene cylinder(double radius, double height, double duration = 10) {
  RoundScene scene;
  scene.radius = radius;
  scene.height = height;
  scene.duration = duration;
  return scene;
}

RoundScene column() {
  return cylinder(0.25, 2);
}

GroundMotion sine(double amplitude, double period = 0.5, double start = 0) {
  GroundMotion motion;
  motion.pulse = Pulse{.shape = PulseShape::sine, .amplitude = amplitude, .period = period, .start = start};
  return motion;
}

/// A record of 2 s, linear between samples.
GroundMotion record(double amplitude, double rate) {
  GroundMotion motion;
  motion.interval = 0.02;
  for (int i = 0; i <= 100; ++i)
    motion.samples.push_back(amplitude * std::sin(rate * i) * std::sin(0.031 * i));
  return motion;
}

RoundScene wobble(RoundScene scene) {
  scene.tilt = 0.1;
  scene.steady = true;
  return scene;
}

RoundScene let_go(RoundScene scene, double precession) {
  scene.tilt = 0.1;
  scene.precession = precession;
  return scene;
}

RoundScene shaken(RoundScene scene) {
  scene.x = record(3, 0.21);
  scene.y = record(2, 0.17);
  scene.z = record(1, 0.33);
  return scene;
}

RoundScene pulsed(double amplitude, double share, double late) {
  RoundScene scene = column();
  scene.x = sine(amplitude);
  scene.y = sine(share * amplitude, 0.5, late);
  return scene;
}

RoundMotion solved(const RoundScene& scene, double interval = 0.01) {
  return solve_round(scene, regular_times(interval, scene.duration));
}

// Angles and the vector of the axis share nothing but the cylinder's numbers. Either rounds to 1e-16 a step,
// which passages and impulses of the ground multiply by 1e3; ψ grows to hundreds of radians.
TEST(RoundColumn, TwoDerivationsAgreeToTwelveDigits) {
  for (RoundScene scene : {wobble(column()), wobble(cylinder(0.0375, 0.0127)), let_go(column(), 0.2),
                           let_go(cylinder(0.3, 0.2), -1.5), pulsed(0.45 * g, 0.3, 0.1),
                           pulsed(0.4 * g, 0.01, 0.1), shaken(column()), shaken(let_go(column(), 0.4))}) {
    const RoundMotion angles = solved(scene);
    scene.equations = RollingEquations::axis;
    const RoundMotion axis = solved(scene);
    ASSERT_EQ(angles.samples.size(), axis.samples.size());
    EXPECT_EQ(angles.events.size(), axis.events.size());
    for (std::size_t i = 0; i < axis.samples.size(); ++i) {
      const Rolling<double>&one = angles.samples[i].rolling, &other = axis.samples[i].rolling;
      ASSERT_NEAR(one.tilt, other.tilt, 1e-12) << i;
      ASSERT_NEAR(one.azimuth, other.azimuth, 1e-12 * std::max(1.0, std::abs(one.azimuth))) << i;
      ASSERT_NEAR(one.omega3, other.omega3, 1e-12 * std::max(1.0, std::abs(one.omega1))) << i;
    }
  }
}

TEST(RoundColumn, EnergyStaysToFourteenDigits) {
  for (const RoundScene& scene : {wobble(column()), wobble(cylinder(0.0375, 0.0127)), let_go(column(), 0.2),
                                  let_go(column(), 1e-6), let_go(cylinder(0.3, 0.2), -1.5)}) {
    const RoundMotion motion = solved(scene);
    for (const RoundState& state : motion.samples)
      ASSERT_NEAR(state.energy, motion.samples[0].energy, 1e-14 * motion.samples[0].energy);
  }
}

// Moffatt, Nature 404 (2000) 833: ψ̇² = 4g/(a sin α) of a thin disk of radius a; h/r = 1e-17 is below
// rounding.
TEST(RoundColumn, AThinDiskPrecessesAsMoffattSays) {
  for (const double tilt : {0.01, 0.1, 0.7})
    EXPECT_NEAR(*steady_precession(cylinder(0.3, 6e-18).body(), tilt),
                std::sqrt(4 * g / (0.3 * std::sin(tilt))), 4e-16 * std::sqrt(4 * g / (0.3 * std::sin(tilt))));
  EXPECT_FALSE(steady_precession(column().body(), 0.3));  // past balance
}

// The base carries the weight and needs no friction, as the centre of mass is at rest.
TEST(RoundColumn, ASteadyWobbleGoesOn) {
  for (const RoundScene& scene : {wobble(column()), wobble(cylinder(0.0375, 0.0127))}) {
    const double rate = *steady_precession(scene.body(), 0.1);
    const RoundMotion motion = solved(scene);
    EXPECT_TRUE(motion.events.empty());
    for (const RoundState& state : motion.samples) {
      ASSERT_NEAR(state.rolling.tilt, 0.1, 1e-15);
      ASSERT_NEAR(state.rolling.azimuth, rate * state.time, 1e-14 * rate * 10);
      ASSERT_NEAR(state.support.normal, 1, 1e-14);
      ASSERT_NEAR(state.support.friction, 0, 1e-14);
    }
  }
}

// With w = −ψ̇ sin²θ → 0 the contact point runs by Δψ = π√((16h² + 15r²)/(16h² + 3r²)) around the rim, no
// energy is lost, and friction of 12hr/(3r² + 16h²) is needed. What a turn at 1e-10 rad/s leaves is below the
// ninth digit.
TEST(RoundColumn, ANearPassageTurnsByItsLimit) {
  for (const auto& [r, height] : {std::pair(0.25, 2.0), {0.05, 0.012}, {0.25, 0.2}}) {
    RoundScene scene = let_go(cylinder(r, height, 2), 1e-10);
    const double h = height / 2, square = r * r, tall = 16 * h * h;
    const RoundMotion motion = solved(scene);
    ASSERT_GE(motion.events.size(), 2u);
    const auto& [passage, least] = motion.events[0];
    const auto& [peak, next] = motion.events[1];
    EXPECT_EQ(passage, RoundEvent::passage);
    EXPECT_EQ(peak, RoundEvent::peak);
    const double limit = pi<double> * std::sqrt((tall + 15 * square) / (tall + 3 * square));
    EXPECT_NEAR(next.rolling.azimuth, limit, 1e-9 * limit);
    EXPECT_NEAR(next.rolling.tilt, 0.1, 1e-12);
    EXPECT_NEAR(least.support.friction, 12 * h * r / (3 * square + tall), 1e-6);
    EXPECT_LT(least.rolling.tilt, 1e-10);
  }
}

// In a plane the base lands flat when that limit has its least tilt, and keeps e = (16h² − 9r²)/(16h² +
// 15r²).
TEST(RoundColumn, APlanarReleaseLandsWithHousnersRatio) {
  RoundScene scene = let_go(column(), 0);
  const RoundMotion plane = solved(scene);
  scene.precession = 1e-8;
  const RoundMotion space = solved(scene);
  const double e = (16 - 9 * 0.0625) / (16 + 15 * 0.0625);
  ASSERT_EQ(plane.events[0].first, RoundEvent::impact);
  EXPECT_NEAR(plane.events[0].second.time, space.events[0].second.time, 1e-9);
  const auto above = [&](double time) {
    return plane.samples[static_cast<std::size_t>(time * 100)].energy - g;  // of standing
  };
  EXPECT_NEAR(above(0.6) / above(0), e * e, 1e-12);
  EXPECT_EQ(plane.samples[60].rolling.azimuth, pi<double>);
  scene.precession = 0;
  scene.room = RoundRoom::plane;
  EXPECT_EQ(solved(scene).events[0].second.time, plane.events[0].second.time);
}

// A component along the ground that is a share of the other one only turns the plane.
TEST(RoundColumn, SidewaysMotionOfOneShapeKeepsAPlane) {
  RoundScene scene = pulsed(0.3 * g, 0.75, 0), turned = column();
  turned.x = sine(0.3 * g * 1.25);
  const RoundMotion motion = solved(scene), alone = solved(turned);
  EXPECT_NEAR(*plane_of(scene), std::atan(0.75), 1e-15);
  for (std::size_t i = 0; i < motion.samples.size(); ++i)
    ASSERT_NEAR(motion.samples[i].rolling.tilt, alone.samples[i].rolling.tilt, 1e-12);
  scene.y = sine(0.3 * g * 0.75, 0.5, 1e-3);
  EXPECT_FALSE(plane_of(scene));
  scene.x = record(2, 0.2);
  scene.y = record(-1, 0.2);
  EXPECT_NEAR(*plane_of(scene), std::atan(-0.5), 1e-15);
  scene.y.samples[40] *= 1 + 1e-10;
  EXPECT_FALSE(plane_of(scene));
}

// West's condition: a sine of g tan α/sin(2πt/T). What is felt is all that a standing column bears.
TEST(RoundColumn, LiftsWhereWhatIsFeltPassesItsEdge) {
  const RoundMotion motion = solved(pulsed(0.4 * g, 0.01, 0.1));
  ASSERT_EQ(motion.events[0].first, RoundEvent::lift);
  const double lift = 0.5 / (2 * pi<double>)*std::asin(0.25 / 0.4);
  EXPECT_NEAR(motion.events[0].second.time, lift, 1e-15);
  EXPECT_NEAR(motion.samples[2].support.friction, 0.4 * std::sin(4 * pi<double> * 0.02), 1e-15);
  EXPECT_EQ(motion.samples[5].rolling.tilt, 0);
  EXPECT_GT(motion.samples[6].rolling.tilt, 0);
  EXPECT_TRUE(solved(pulsed(0.2 * g, 0.01, 0.1)).events.empty());
}

// What the ground does to a body in its frame is the work of −a on the velocity ρ × ω of the centre of mass.
// By Simpson's rule over pieces of the record; an error of the fourth order in 1/400 s.
TEST(RoundColumn, EnergyIsTheWorkOfTheGround) {
  RoundScene scene = shaken(let_go(column(), 0.4));
  scene.duration = 2;
  const RoundMotion motion = solved(scene, 0.0025);
  const Cylinder body = scene.body();
  const auto power = [&](const RoundState& state) {
    const auto& [tilt, tilt_rate, omega1, omega3, azimuth] = state.rolling;
    const double b = body.half_height * tilt_rate, d = body.radius * tilt_rate;
    const double q = -(body.half_height * omega1 + body.radius * omega3);
    const double p = b * std::cos(tilt) + d * std::sin(tilt), up = d * std::cos(tilt) - b * std::sin(tilt);
    const double x = p * std::cos(azimuth) - q * std::sin(azimuth);
    const double y = p * std::sin(azimuth) + q * std::cos(azimuth);
    return -(acceleration(scene.x, state.time) * x + acceleration(scene.y, state.time) * y +
             acceleration(scene.z, state.time) * up);
  };
  double work = 0;
  for (std::size_t i = 0; i + 2 < motion.samples.size(); i += 2) {
    const RoundState* at = &motion.samples[i];
    work += 0.005 / 6 * (power(at[0]) + 4 * power(at[1]) + power(at[2]));
    ASSERT_NEAR(at[2].energy - motion.samples[0].energy, work, 2e-5) << at[2].time;
  }
  EXPECT_GT(std::abs(work), 0.02);
}

TEST(RoundColumn, TopplesPastItsAngleAndLandsFlatInAPlaneAlone) {
  const RoundScene falls = pulsed(0.52 * g, 1e-6, 0.1);
  const RoundMotion motion = solved(falls);
  ASSERT_TRUE(motion.toppled);
  EXPECT_NEAR(motion.events.back().second.rolling.tilt, (std::atan(0.25) + pi<double> / 2) / 2, 1e-14);
  EXPECT_LE(motion.samples.back().time, *motion.toppled);
  EXPECT_TRUE(topples(falls, motion));
  EXPECT_THROW(solved(pulsed(0.3 * g, 0.1, 5)), std::domain_error);
}

}  // namespace
}  // namespace rockstack
