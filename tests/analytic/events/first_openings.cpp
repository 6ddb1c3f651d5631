#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

using testing::Draw;
using Number = long double;

constexpr Number tau = 2 * std::numbers::pi_v<Number>;

/// A pulse as its definition says, over its amplitude; of Mavroeidis & Papageorgiou by the product rule.
Number shape(const Pulse& pulse, Number t) {
  const Number period = pulse.period;
  switch (pulse.shape) {
    case PulseShape::sine:
    case PulseShape::half_sine:
      return std::sin(tau * t / period);
    case PulseShape::cosine:
      return std::cos(tau * t / period);
    case PulseShape::rectangle:
      return 1;
    case PulseShape::ricker: {
      const Number square = std::pow(tau / 2 * (t - 2 * period) / period, 2);
      return (1 - 2 * square) * std::exp(-square);
    }
    default: {
      const Number cycles = pulse.cycles;
      const Number s = t - cycles * period / 2;
      const Number wide = tau * s / (cycles * period);
      const Number narrow = tau * s / period + Number(pulse.phase);
      return -(std::sin(wide) / cycles * std::cos(narrow) + (1 + std::cos(wide)) * std::sin(narrow)) / 2;
    }
  }
}

Number lasting(const Pulse& pulse) {
  const Number period = pulse.period;
  if (pulse.shape == PulseShape::half_sine) return period / 2;
  if (pulse.shape == PulseShape::ricker) return 4 * period;
  return pulse.shape == PulseShape::rectangle ? period : Number(pulse.cycles) * period;
}

/// A stretch of time through which the same pulses act.
struct Stretch {
  Number from, to;
  const Pulse* horizontal = nullptr;
  const Pulse* vertical = nullptr;

  /// g + ÿ, m/s².
  Number effective_gravity(const Scene& scene, Number t) const {
    const Number rise = vertical ? vertical->amplitude * shape(*vertical, t - vertical->start) : Number(0);
    return scene.gravity + rise;
  }
  /// ẍ/(g + ÿ).
  Number tilt(const Scene& scene, Number t) const {
    const Number push =
        horizontal ? horizontal->amplitude * shape(*horizontal, t - horizontal->start) : Number(0);
    return push / effective_gravity(scene, t);
  }
};

std::vector<Stretch> stretches(const Scene& scene) {
  std::vector<Number> ends{0, scene.duration};
  for (const GroundMotion* motion : {&scene.horizontal, &scene.vertical}) {
    if (!motion->pulse) continue;
    ends.push_back(motion->pulse->start);
    ends.push_back(motion->pulse->start + lasting(*motion->pulse));
  }
  std::sort(ends.begin(), ends.end());
  const auto acting = [](const GroundMotion& motion, Number t) -> const Pulse* {
    if (!motion.pulse) return nullptr;
    const Number since = t - motion.pulse->start;
    return since > 0 && since < lasting(*motion.pulse) ? &*motion.pulse : nullptr;
  };
  std::vector<Stretch> result;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const Number middle = (ends[i - 1] + ends[i]) / 2;
    if (ends[i] > ends[i - 1])
      result.push_back(
          {ends[i - 1], ends[i], acting(scene.horizontal, middle), acting(scene.vertical, middle)});
  }
  return result;
}

/// Points of a stretch among which is each maximum of a course, to rounding of its height.
template <class Course>
std::vector<Number> points(const Stretch& stretch, const Course& course) {
  Number period = stretch.to - stretch.from;
  for (const Pulse* pulse : {stretch.horizontal, stretch.vertical}) {
    if (pulse) period = std::min(period, Number(pulse->period));
  }
  const int count = 8 + static_cast<int>(128 * (stretch.to - stretch.from) / period);
  const auto grid = [&](int i) { return stretch.from + (stretch.to - stretch.from) * i / count; };
  std::vector<Number> result;
  for (int i = 0; i <= count; ++i) {
    result.push_back(grid(i));
    Number low = grid(std::max(i - 1, 0)), high = grid(std::min(i + 1, count));
    if (course(grid(i)) < std::max(course(low), course(high))) continue;
    for (int part = 0; part < 40; ++part) {
      const Number third = (high - low) / 3;
      const bool rises = course(low + third) < course(high - third);
      (rises ? low : high) = rises ? low + third : high - third;
    }
    result.push_back(low);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The interface whose |ẍ|/(g + ÿ) is least, from 0, and that: West's condition for all above it as one body.
struct Weakest {
  int interface;
  Number critical_tilt;
};

Weakest weakest(const Scene& scene) {
  Weakest result{-1, std::numeric_limits<Number>::infinity()};
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    Number bottom = 0, mass = 0, moment = 0;
    for (std::size_t j = k; j < scene.blocks.size(); ++j) {
      mass += scene.blocks[j].mass;
      moment += scene.blocks[j].mass * (bottom + Number(scene.blocks[j].half_height));
      bottom += 2 * Number(scene.blocks[j].half_height);
    }
    const Number half_width =
        std::min(scene.blocks[k].half_width, scene.blocks[k == 0 ? 0 : k - 1].half_width);
    if (half_width * mass / moment < result.critical_tilt)
      result = {static_cast<int>(k), half_width * mass / moment};
  }
  return result;
}

Number largest_tilt(const Scene& scene) {
  Number largest = 0;
  for (const Stretch& stretch : stretches(scene)) {
    const auto course = [&](Number t) { return std::abs(stretch.tilt(scene, t)); };
    for (const Number t : points(stretch, course)) largest = std::max(largest, course(t));
  }
  return largest;
}

struct Opening {
  Number time;
  Contact side;
  bool jumps;  ///< the tilt jumps there, perhaps beyond what other interfaces bear too
};

/// When the ground first tilts the effective gravity beyond a critical tilt, by bisection. Precondition: it
/// does.
Opening first_opening(const Scene& scene, Number critical_tilt) {
  for (const Stretch& stretch : stretches(scene)) {
    const auto course = [&](Number t) { return std::abs(stretch.tilt(scene, t)); };
    Number low = stretch.from;
    for (Number high : points(stretch, course)) {
      if (!(course(high) > critical_tilt)) {
        low = high;
        continue;
      }
      for (int halving = 0; halving < 80; ++halving) {
        const Number middle = (low + high) / 2;
        (course(middle) > critical_tilt ? high : low) = middle;
      }
      return {high, stretch.tilt(scene, high) > 0 ? Contact::left : Contact::right, high == stretch.from};
    }
  }
  return {std::numeric_limits<Number>::infinity(), Contact::closed, false};
}

GroundMotion drawn_pulse(Draw& draw, double amplitude) {
  GroundMotion motion;
  motion.pulse = Pulse{.shape = static_cast<PulseShape>(draw.below(6)),
                       .amplitude = draw.coin() ? amplitude : -amplitude,
                       .period = std::pow(10, draw.between(-2, 1)),
                       .start = draw.coin() ? 0 : draw.between(0, 1),
                       .cycles = draw.between(1.1, 5),
                       .phase = draw.between(0, 6)};
  return motion;
}

/// A stack at rest under pulses that tilt its effective gravity to `excess` + 1 times what its weakest
/// interface bears.
Scene pushed(Draw& draw, double excess) {
  Scene scene = testing::random_stack(draw, 1 + draw.below(5));
  scene.horizontal = drawn_pulse(draw, 1);
  if (draw.coin()) scene.vertical = drawn_pulse(draw, draw.between(0.1, 0.9) * scene.gravity);
  scene.duration = static_cast<double>(scene.horizontal.pulse->start + lasting(*scene.horizontal.pulse));
  scene.horizontal.pulse->amplitude *=
      static_cast<double>(weakest(scene).critical_tilt / largest_tilt(scene)) * (1 + excess);
  return scene;
}

/// The longer period of a scene's pulses, s.
double longest_period(const Scene& scene) {
  return std::max(scene.horizontal.pulse->period, scene.vertical.pulse ? scene.vertical.pulse->period : 0.0);
}

// Draws go on where tests are repeated: --gtest_repeat=50 takes 10,000 stacks.
constexpr int stacks = 200;

// West's condition tells when, where and to which side a stack at rest opens under a pulse. Where the tilt
// passes its threshold by a share δ, it does so at a slope of √(2δ): roundings weigh up to a thousand times
// more in a time, as a share of the period. Times have their own rounding.
TEST(FirstOpenings, AreThoseOfWestsCondition) {
  static Draw draw(71);
  for (int i = 0; i < stacks; ++i) {
    Scene scene = pushed(draw, std::pow(10, draw.between(-6, 1)));
    const Weakest weak = weakest(scene);
    const Opening expected = first_opening(scene, weak.critical_tilt);
    scene.duration = static_cast<double>(expected.time) + 1e-3 * longest_period(scene);
    const History history = solve(scene);
    ASSERT_FALSE(history.events.empty()) << i;
    const Event& event = history.events[0];
    EXPECT_EQ(event.kind, EventKind::opening) << i;
    if (!expected.jumps) {
      EXPECT_EQ(event.interface, weak.interface + 1) << i;
      EXPECT_EQ(event.to[weak.interface], expected.side) << i;
    }
    EXPECT_NEAR(event.time, static_cast<double>(expected.time),
                1e-12 * longest_period(scene) + 4 * std::numeric_limits<double>::epsilon() * event.time)
        << i;
  }
}

// Just below the threshold nothing opens, and what the interfaces demand is known: friction of the largest
// tilt, and the least of the effective gravity.
TEST(FirstOpenings, StayOutBelowTheThreshold) {
  static Draw draw(72);
  for (int i = 0; i < stacks; ++i) {
    const Scene scene = pushed(draw, -std::pow(10, draw.between(-6, -3)));
    const History history = solve(scene, {.validity = true});
    ASSERT_TRUE(history.events.empty()) << i << '\n' << testing::listing(history);
    double weight = 0;
    for (const Block& block : scene.blocks) weight += block.mass * scene.gravity;
    const auto tilt = static_cast<double>(largest_tilt(scene));
    for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
      // Forces are kept to 1024 roundings of the stack's weight.
      const double rounding = 2048 * std::numeric_limits<double>::epsilon() * weight * (1 + tilt) /
                              history.forces[k].least_normal;
      EXPECT_NEAR(history.forces[k].friction, tilt, rounding) << i;
    }
  }
}

TEST(FirstOpenings, ARickerPulseDemandsTheFrictionOfItsPeak) {
  Scene scene = testing::released({testing::block(2.8, 8.5)}, {0}, 2);
  scene.horizontal.pulse = Pulse{.shape = PulseShape::ricker, .amplitude = 3, .period = 0.2};
  const History history = solve(scene, {.validity = true});
  EXPECT_NEAR(history.forces[0].friction, 3 / 9.81, 1024 * std::numeric_limits<double>::epsilon());
}

}  // namespace
}  // namespace rockstack
