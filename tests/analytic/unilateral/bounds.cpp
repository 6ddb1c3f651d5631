// What the solver leaves out because of a bound, of random stacks in motion.

#include <gtest/gtest.h>

#include <random>

#include "analytic/unilateral/contact/contact_modes.hpp"
#include "analytic/unilateral/series/guards.hpp"
#include "analytic/unilateral/series/mode_step.hpp"
#include "analytic/unilateral/springs/spring_series.hpp"

namespace rockstack {
namespace {

/// One to four blocks, half of them of equal width, on joints that stick.
struct StuckStack {
  ContactModel<> stack;
  Joints<double> joints;
  Bodies<> bodies;
};

class RandomStacks {
 public:
  double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  bool either() { return in(0, 1) < 0.5; }

  /// With that friction; nothing turns at the start or all does.
  StuckStack stuck(double friction) {
    const bool equal = either();
    const double width = in(0.5, 2);
    std::vector<Block> blocks;
    for (auto more = static_cast<int>(in(1, 5)); more > 0; --more) {
      Block block = make_block(equal ? width : in(0.5, 2), in(0.5, 4), in(100, 3000));
      block.offset_x = in(-0.2, 0.2) * block.half_width;
      block.offset_y = in(-0.2, 0.2) * block.half_height;
      blocks.push_back(block);
    }
    const std::size_t size = blocks.size();
    StuckStack made{ContactModel<>(blocks, std::vector<double>(size, friction)),
                    Joints<double>(size),
                    {Poses<>(size), Poses<>(size)}};
    const double fastest = either() ? 0 : 2;
    for (std::size_t k = 0; k < size; ++k) {
      Joint<double>& joint = made.joints[k];
      joint.touch = static_cast<Contact>(static_cast<int>(in(0, 3)) - 1);
      joint.corner_below =
          joint.pivots() && corner_is_below<double>(made.stack, static_cast<int>(k), 0, joint.side());
      const double below = k > 0 ? made.bodies.pose[k - 1].angle : 0;
      made.bodies.pose[k].angle = below + joint.side() * in(0, 0.2);
      made.bodies.velocity[k].angle = in(-fastest, fastest);
    }
    place(made.stack, made.joints, made.bodies);
    return made;
  }

 private:
  std::mt19937 generator_{1};
};

constexpr int many = 2000;

// Gauss's principle: see most_turning().
TEST(Bounds, NoInterfaceTurnsFasterThanItsBound) {
  RandomStacks random;
  for (int i = 0; i < many; ++i) {
    const StuckStack made = random.stuck(1);
    FreeVector<> free = uniform<double>(made.stack.size(), random.in(-20, 20), random.in(-30, 10));
    for (int k = 0; k < made.stack.size(); ++k) free[3 * k + 2] = random.either() ? 0 : random.in(-5, 5);
    const auto motion =
        respond<double>({made.stack, made.bodies, free, ContactLevel::accelerations}, made.joints).motion;
    const double most = most_turning(made.stack, made.bodies.velocity, free);
    for (int k = 0; k < made.stack.size(); ++k)
      EXPECT_LE(std::abs(angle_row<double>(made.stack, k).dot(motion)), most) << i;
  }
}

// One mode obeys of what sticks at an impact, so that a likely one that does is what
// complementarity leads to.
TEST(Bounds, ALikelyModeThatObeysIsTheOneOfComplementarity) {
  RandomStacks random;
  int likely = 0;
  for (int i = 0; i < many; ++i) {
    const StuckStack made = random.stuck(random.in(0.2, 2));
    FreeVector<> free(3 * made.stack.size());
    for (Eigen::Index e = 0; e < free.size(); ++e) free[e] = random.in(-1, 1);
    const ContactProblem<> problem{made.stack, made.bodies, free, ContactLevel::impacts};
    const TouchingContacts<double> contacts(problem, made.joints);
    const Joints<double> mode = likely_mode(contacts, made.joints);
    if (!surely_obeys(contacts, mode, {})) continue;
    ++likely;
    const auto found = mode_on_faces(contacts, made.joints);
    ASSERT_TRUE(found) << i;
    EXPECT_TRUE(std::equal(mode.begin(), mode.end(), found->begin(), std::mem_fn(&Joint<double>::same_mode)))
        << i;
  }
  EXPECT_GT(likely, many / 100);
}

// What no guard tells of stays positive all along a step: normal forces, and what is left of friction.
TEST(Bounds, ForcesWithoutGuardsStayInTheirCones) {
  RandomStacks random;
  const SpringPoints<double> no_points;
  int left_out = 0;
  for (int i = 0; i < many / 4; ++i) {
    const StuckStack made = random.stuck(random.in(0.1, 2));
    const double unit = made.stack.fall_time(9.81), length = unit / 8;
    const double scale = length * length;
    SpringSeries<double> none(made.stack, no_points, made.bodies);
    const ScaledBodyForce<double> body_force{{random.in(-3, 3) * scale, random.in(-3, 3) * scale},
                                             {-9.81 * scale, random.in(-3, 3) * scale}};
    const ModeSeries<double> series =
        mode_step(made.stack, made.joints, made.bodies, body_force, length, 1e-6 * unit, unit, none).series;
    const std::vector<double> upright(made.joints.size(), 1.5);
    const auto guards = guards_of(made.stack, made.joints, upright, series);
    for (int k = 0; k < made.stack.size(); ++k) {
      const auto guarded = [&](const Guard<double>& guard) {
        return guard.change == Change::force && guard.interface == k;
      };
      if (std::any_of(guards.begin(), guards.end(), guarded)) continue;
      ++left_out;
      const bool pair = is_corner_pair(made.stack, k, made.joints[k]);
      for (const int sign : {-1, 1}) {
        const ForceSeries<double> force = pair && sign == made.joints[k].side()
                                              ? on_upper_face(series, k, series.forces[k])
                                              : series.forces[k];
        for (double s = 0; s <= 1; s += 1.0 / 64) {
          const double normal = value(force.normal, s), tangential = value(force.tangential, s);
          EXPECT_GT(normal, 0) << i;
          EXPECT_GT(made.stack.friction[k] * normal + sign * tangential, 0) << i;
        }
      }
    }
  }
  EXPECT_GT(left_out, many / 40);
}

}  // namespace
}  // namespace rockstack
