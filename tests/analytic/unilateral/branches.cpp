#include "analytic/branches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analytic/unilateral/contact/contact_kinematics.hpp"
#include "tests/analytic/unilateral/equal_widths.hpp"
#include "tests/analytic/unilateral/momentum_laws.hpp"
#include "tests/analytic/unilateral/scenes.hpp"
#include "tests/stride.hpp"

namespace rockstack {
namespace {

constexpr std::size_t plenty = 64;

SolveOptions sampled(const Scene& scene, double samples = 200) {
  return {.sample_times = regular_times(scene.duration / samples, scene.duration)};
}

BranchTree branches_of(const Scene& scene, std::size_t most = plenty) {
  return solve_branches(scene, sampled(scene), most);
}

void expect_same_bits(const History& one, const History& other) {
  EXPECT_EQ(one.angles, other.angles);
  EXPECT_EQ(one.velocities, other.velocities);
  EXPECT_EQ(one.centres, other.centres);
  EXPECT_EQ(one.centre_velocities, other.centre_velocities);
  ASSERT_EQ(one.events.size(), other.events.size());
  for (std::size_t i = 0; i < one.events.size(); ++i) {
    EXPECT_EQ(one.events[i].time, other.events[i].time);
    EXPECT_EQ(one.events[i].to, other.events[i].to);
    EXPECT_EQ(one.events[i].after, other.events[i].after);
  }
}

bool tells_several(const History& history) {
  return std::ranges::any_of(history.events,
                             [](const Event& event) { return event.consistency == Consistency::several; });
}

/// The largest difference of places and angles at any sample, in m or rad; `side` −1: from the mirror image.
double largest_difference(const History& one, const History& other, double side = 1) {
  if (one.size() != other.size()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < one.angles.size(); ++i)
    largest = std::max({largest, std::abs(one.angles[i] - side * other.angles[i]),
                        std::abs(one.centres[2 * i] - side * other.centres[2 * i]),
                        std::abs(one.centres[2 * i + 1] - other.centres[2 * i + 1])});
  return largest;
}

TEST(Branches, TheFirstIsTheMotionOfSolveAndTheOnlyOneWhereNothingForks) {
  int single = 0, forked = 0;
  for (std::uint64_t seed = 0; seed < 60; seed += testing::stride) {
    for (const Scene& scene :
         {testing::equal_widths(seed), testing::rubbing_scene(seed), testing::seeded_scene(seed)}) {
      const History history = solve(scene, sampled(scene));
      const BranchTree tree = branches_of(scene, 2);
      expect_same_bits(tree.branches.front().history, history);
      const bool forks = !tree.branches.front().forks.empty();
      ++(forks ? forked : single);
      EXPECT_EQ(tree.branches.size() + tree.left_out > 1, forks);
      if (tells_several(history)) {
        EXPECT_TRUE(forks) << seed;
      }
    }
  }
  EXPECT_GT(testing::stride * single, 60);
  EXPECT_GT(testing::stride * forked, 5);
}

// p, critical friction and the force as in painleve.cpp: N = m (c ω² − g)/−p.
TEST(Branches, APainleveCornerPartsOrPresses) {
  const double angle = 0.2, lift = 1.05;
  const double a = 0.5 * std::cos(angle) - std::sin(angle);
  const double c = std::cos(angle) + 0.5 * std::sin(angle);
  const double friction = 1.05 * (1 + 3 * a * a / 1.25) / (3 * a * c / 1.25);
  Scene scene = testing::with_friction(testing::single(0.5, 1, 1e-3), friction);
  scene.initial = {{angle}, {std::sqrt(lift * scene.gravity / c)}, {1.0}};
  const BranchTree tree = branches_of(scene);
  ASSERT_EQ(tree.branches.size(), 2U);
  EXPECT_EQ(tree.left_out, 0U);
  const Branch& parts = tree.branches[0];
  const Branch& presses = tree.branches[1];
  ASSERT_EQ(parts.forks.size(), 1U);
  EXPECT_EQ(parts.forks[0].time, 0);
  EXPECT_EQ(name(parts.history.patterns[0]), "-");
  EXPECT_EQ(name(presses.history.patterns[0]), "R>");
  EXPECT_FALSE(presses.like);
  const double p = 1 + 3 * a * a / 1.25 - friction * 3 * a * c / 1.25;
  const double normal = (lift - 1) * scene.gravity / -p;  // over the mass
  const double interval =
      parts.history.times[1];  // over which forces change by a few of its shares of a second
  const auto acceleration = [&](const Branch& branch, std::size_t axis) {
    return (branch.history.centre_velocities[2 + axis] - branch.history.centre_velocities[axis]) / interval;
  };
  EXPECT_NEAR(acceleration(parts, 0), 0, 1e-9);
  EXPECT_NEAR(acceleration(parts, 1), -scene.gravity, 1e-9);
  EXPECT_NEAR(acceleration(presses, 1), normal - scene.gravity, 0.01 * normal);
  EXPECT_NEAR(acceleration(presses, 0), -friction * normal, 0.01 * friction * normal);
}

/// A flat block slides to the right on ground that falls faster than it does.
Scene flat_block(double friction, double fall) {
  Scene scene = testing::with_friction(testing::single(0.5, 1, 0.2), friction);
  scene.vertical = testing::pulse_of(PulseShape::rectangle, -fall, 1);
  scene.initial.slip_velocities = {2};
  return scene;
}

// About the middle of a block of half width b and half height h, N and T = −μN at its right corner turn it:
// the corner goes up by N/m + b (b − μh) N/I − (g − fall), which is zero where it presses.
TEST(Branches, AFlatFacePartsOrJamsOnACorner) {
  const double friction = 2.5, fall = 10.5, inertia = (0.25 + 1) / 3;  // over the mass
  const Scene scene = flat_block(friction, fall);
  const BranchTree tree = branches_of(scene);
  ASSERT_EQ(tree.branches.size(), 2U);
  EXPECT_EQ(name(tree.branches[0].history.patterns[0]), "-");
  const History& jams = tree.branches[1].history;
  EXPECT_EQ(name(jams.patterns[0]), "R>");
  const double normal = (scene.gravity - fall) / (1 + 0.5 * (0.5 - friction) / inertia);
  ASSERT_GT(normal, 0);
  const double turn = (friction - 0.5) * normal / inertia;
  EXPECT_NEAR(jams.velocities[1] / jams.times[1], turn, 0.01 * turn);
  // The other end of the condition: with less friction at the same fall nothing presses.
  EXPECT_EQ(branches_of(flat_block(0.5 + inertia / 0.5 - 0.01, fall)).branches.size(), 1U);
}

/// A leaning block slides on a flat one that friction turns, though at no point alone.
Scene coupled_stack(double friction) {
  Scene scene;
  scene.law = Law::unilateral;
  scene.duration = 0.03;  // until the other motion jams, and forces grow within a sample
  scene.blocks = {make_block(0.6, 0.5, 2500), make_block(1.6, 1.3, 2500)};
  scene.friction = {friction, friction};
  scene.initial = {{0, 0.07}, {0, -1.6}, {0, -1.3}};
  return scene;
}

TEST(Branches, InterfacesForkTogether) {
  const BranchTree tree = branches_of(coupled_stack(1.4));
  ASSERT_EQ(tree.branches.size(), 2U);
  EXPECT_EQ(name(tree.branches[0].history.patterns[0]), "CR<");
  EXPECT_EQ(name(tree.branches[1].history.patterns[0]), "LR<");
  EXPECT_EQ(branches_of(coupled_stack(0.7)).branches.size(), 1U);
}

// Ground that falls faster than blocks do pulls at what pivots close: the block opens to either side.
TEST(Branches, ASymmetricOpeningHasTwoThatAreMirrorImages) {
  for (const Law law : {Law::consistent, Law::paper}) {
    Scene scene = testing::single(0.2, 0.6, 0.5);
    scene.law = law;
    scene.vertical = testing::pulse_of(PulseShape::half_sine, -1.5 * scene.gravity, 0.2);
    const BranchTree tree = branches_of(scene);
    ASSERT_EQ(tree.branches.size(), 2U);
    const Branch& other = tree.branches[1];
    ASSERT_TRUE(other.like);
    EXPECT_EQ(other.like->branch, 0U);
    EXPECT_EQ(other.like->from, 0);
    EXPECT_TRUE(other.like->mirrored);
    EXPECT_GT(*std::ranges::max_element(other.history.angles), 1e-3);
    for (std::size_t i = 0; i < other.history.size(); ++i)
      EXPECT_EQ(other.history.angles[i], -tree.branches[0].history.angles[i]);
  }
}

/// The scene seen from behind.
Scene mirrored(Scene scene) {
  const auto turn = [](std::vector<double>& values) {
    for (double& value : values) value = -value;
  };
  turn(scene.initial.angles);
  turn(scene.initial.velocities);
  turn(scene.initial.slip_velocities);
  if (scene.horizontal.pulse) scene.horizontal.pulse->amplitude *= -1;
  return scene;
}

// Corner on corner: what widths a little apart from each other come to is what branches follow.
TEST(Branches, HaveTheLimitsOfWiderAndOfNarrowerBlocksAmongThem) {
  constexpr double share = 1e-10;
  int limits = 0;
  for (std::uint64_t seed = 0; seed < 200; seed += testing::stride) {
    const Scene scene = testing::equal_widths(seed);
    if (!tells_several(solve(scene))) continue;
    const BranchTree tree = branches_of(scene);
    ASSERT_EQ(tree.left_out, 0U) << seed;
    for (unsigned wider = 0; wider < 1U << (scene.blocks.size() - 1); ++wider) {
      const History limit = solve(testing::widened(scene, wider, share), sampled(scene));
      double nearest = std::numeric_limits<double>::infinity();
      for (const Branch& branch : tree.branches)
        nearest = std::min(nearest, largest_difference(limit, branch.history));
      EXPECT_LT(nearest, 30 * std::sqrt(share)) << seed << ' ' << wider;  // as in LimitTally
      ++limits;
    }
  }
  EXPECT_GT(testing::stride * limits, 60);
}

/// How deep corners of neighbours are in each other, m.
double overlap_of(const Scene& scene, const Poses<>& at) {
  double deepest = 0;
  const auto corner_in_face = [&](int owner, double corner_y, int other, double face_y) {
    for (const int side : {-1, 1}) {
      const Pose<> own = pose_of(at, owner), face = pose_of(at, other);
      const Point<double> corner =
          Point<double>(own.x, own.y) +
          turned<double>({side * scene.blocks[owner].half_width, corner_y}, own.angle);
      const Point<double> seen = turned<double>(corner - Point<double>(face.x, face.y), -face.angle);
      if (other >= 0 && std::abs(seen.x()) > scene.blocks[other].half_width) continue;
      deepest = std::max(deepest, face_y > 0 || other < 0 ? face_y - seen.y() : seen.y() - face_y);
    }
  };
  for (int k = 0; k < static_cast<int>(at.size()); ++k) {
    const double below = k == 0 ? 0 : scene.blocks[k - 1].half_height;
    corner_in_face(k, -scene.blocks[k].half_height, k - 1, below);
    if (k > 0) corner_in_face(k - 1, below, k, -scene.blocks[k].half_height);
  }
  return deepest;
}

std::vector<Scene> forking_scenes() {
  std::vector<Scene> scenes{flat_block(2.5, 10.5), coupled_stack(1.4)};
  for (std::uint64_t seed = 0; seed < 120; seed += testing::stride)
    scenes.push_back(testing::equal_widths(seed));
  return scenes;
}

// Momenta tell impulses of every branch, and forces between samples 10⁻⁷ s apart, with no part of the
// solver.
TEST(Branches, ObeyTheLawsOfContactAllOfThem) {
  constexpr double moment = 1e-7;
  int impacts = 0, forces = 0, place = 0;
  for (const Scene& scene : forking_scenes()) {
    SCOPED_TRACE(place++);
    const BranchTree tree = branches_of(scene, 8);
    if (tree.branches.size() == 1) continue;
    double mass = 0, height = 0;
    for (const Block& block : scene.blocks) mass += block.mass, height += 2 * block.half_height;
    SolveOptions options;
    for (const double time : regular_times(scene.duration / 200, scene.duration * 0.99))
      options.sample_times.insert(options.sample_times.end(), {time, time + moment});
    for (const Branch& branch : tree.branches) {
      Branching branching;
      for (const Fork& fork : branch.forks) branching.list.push_back(fork.taken);
      const History history = solve(scene, options, &branching);
      const testing::ImpactTally tally = testing::impacts_by_momenta(scene, history);
      impacts += tally.impacts;
      EXPECT_EQ(tally.broken, 0);
      for (std::size_t i = 0; i + 1 < history.size(); i += 2) {
        const Bodies<> first = bodies_at(history, i), second = bodies_at(history, i + 1);
        const double start = history.times[i], end = history.times[i + 1];
        EXPECT_LT(overlap_of(scene, first.pose), 1e-9) << start;
        const auto between = [&](const Event& event) {
          return event.time >= start - moment && event.time <= end + moment;
        };
        if (std::ranges::any_of(history.events, between)) continue;
        const double middle = (start + end) / 2, time = end - start;
        const Point<double> free(-acceleration(scene.horizontal, middle) * time,
                                 -(scene.gravity + acceleration(scene.vertical, middle)) * time);
        ++forces;
        EXPECT_TRUE(testing::obeys_laws(
            scene, {second.pose, second.velocity, testing::difference(second.velocity, first.velocity), free,
                    mass * scene.gravity * time}))
            << start;
      }
    }
  }
  EXPECT_GT(testing::stride * impacts, 20);
  EXPECT_GT(testing::stride * forces, 1000);
}

TEST(Branches, OfAMirroredSceneAreMirrored) {
  for (std::uint64_t seed = 0; seed < 100; seed += testing::stride) {
    const Scene scene = testing::equal_widths(seed);
    const BranchTree tree = branches_of(scene, 8), other = branches_of(mirrored(scene), 8);
    ASSERT_EQ(tree.branches.size(), other.branches.size()) << seed;
    for (std::size_t i = 0; i < tree.branches.size(); ++i)
      EXPECT_LT(largest_difference(tree.branches[i].history, other.branches[i].history, -1), 1e-9)
          << seed << ' ' << i;
  }
}

TEST(Branches, ABoundIsTold) {
  const Scene scene = testing::equal_widths(17);  // one fork
  const BranchTree all = branches_of(scene), one = branches_of(scene, 1);
  EXPECT_EQ(all.left_out, 0U);
  ASSERT_EQ(one.branches.size(), 1U);
  ASSERT_FALSE(one.branches[0].forks.empty());
  EXPECT_EQ(one.left_out, one.branches[0].forks.size());
  EXPECT_EQ(one.first_left_out, one.branches[0].forks[0].time);
}

}  // namespace
}  // namespace rockstack
