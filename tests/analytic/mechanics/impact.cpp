#include "analytic/mechanics/impact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/analytic/mechanics/maximal.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

using testing::Draw;
using testing::Number;

/// A random state in which at least one interface impacts.
template <class Real>
Impact<Real> random_impact(Draw& draw, int size) {
  Impact<Real> impact{testing::random_state<Real>(draw, size), {}};
  const int certain = draw.below(size);
  for (int k = 0; k < size; ++k) {
    Contact& contact = impact.before.pattern[k];
    if (k != certain && (contact == Contact::closed || draw.coin())) continue;
    if (contact == Contact::closed) contact = Contact::right;
    impact.impacting.set(static_cast<std::size_t>(k));
    impact.before.angles[k] = 0;
    impact.before.velocities[k] = -sign(contact) * draw.between(0.01, 1);
  }
  return impact;
}

TEST(Impact, CandidatesAreAllPatternsOfTheTouchingInterfaces) {
  const Pattern before{4, {Contact::left, Contact::closed, Contact::right, Contact::left}};
  for (unsigned mask = 0; mask < 16; ++mask) {
    std::set<std::string> names;
    for (const Pattern& candidate : candidates(before, Interfaces(mask))) {
      names.insert(name(candidate));
      for (int k = 0; k < 4; ++k) {
        if ((mask >> k & 1U) == 0) {
          EXPECT_EQ(candidate[k], before[k]);
        }
      }
    }
    EXPECT_EQ(names.size(), static_cast<std::size_t>(std::pow(3, Interfaces(mask).count())));
  }
}

TEST(Impact, AngularMomentumAboveEveryPivotIsKeptWhateverThePattern) {
  Draw draw(21);
  for (int i = 0; i < 1000; ++i) {
    const int size = 1 + draw.below(4);
    const auto model = make_model<Number>(testing::random_stack(draw, size));
    const auto impact = random_impact<Number>(draw, size);
    const auto before = testing::velocities(
        testing::place(model, impact.before.pattern, impact.before.angles), impact.before.velocities);
    for (const Pattern& pattern : candidates(impact.before.pattern, impact.touching())) {
      const auto place = testing::place(model, pattern, impact.before.angles);
      const auto solution = velocities_after(model, impact, pattern);
      const auto after = testing::velocities(place, solution.relative);
      const Number energy = testing::kinetic_energy(model, before);
      const Number scale = std::sqrt(energy) * std::sqrt(model.stack.mass.sum()) * 10;
      for (int k = 0; k < size; ++k) {
        if (pattern[k] == Contact::closed) continue;
        // Long double rounding 1e-19, five digits lost to mass ratios.
        EXPECT_NEAR(static_cast<double>(testing::angular_momentum(model, place, before, k)),
                    static_cast<double>(testing::angular_momentum(model, place, after, k)),
                    static_cast<double>(1e-13L * scale));
      }
      EXPECT_LE(testing::kinetic_energy(model, after), energy * (1 + 1e-15L));
    }
  }
}

TEST(Impact, VelocitiesAndImpulsesAreThoseOfConstraintsInMaximalCoordinates) {
  Draw draw(22);
  for (int i = 0; i < 2000; ++i) {
    const int size = 1 + draw.below(4);
    const Scene scene = testing::random_stack(draw, size);
    const auto model = make_model<double>(scene);
    const auto impact = random_impact<double>(draw, size);
    const State<Number> before{impact.before.pattern, impact.before.angles.cast<Number>(),
                               impact.before.velocities.cast<Number>()};
    const auto all = candidates(impact.before.pattern, impact.touching());
    const Pattern pattern = all[static_cast<std::size_t>(draw.below(static_cast<int>(all.size())))];
    const auto solution = velocities_after(model, impact, pattern);
    const auto expected = testing::strike(make_model<Number>(scene), before, pattern);
    const double scale = 1 + static_cast<double>(expected.relative.cwiseAbs().maxCoeff());
    const double push = 1 + static_cast<double>(expected.force.cwiseAbs().maxCoeff());
    for (int k = 0; k < size; ++k) {
      // Double rounding with five digits lost to mass ratios of 10³.
      EXPECT_NEAR(solution.relative[k], static_cast<double>(expected.relative[k]), 1e-11 * scale);
      EXPECT_NEAR(std::hypot(solution.reactions.normal[k], solution.reactions.tangential[k]),
                  static_cast<double>(expected.force.col(k).norm()), 1e-9 * push);
    }
  }
}

TEST(Impact, ASecondProjectionChangesNothing) {
  Draw draw(23);
  for (int i = 0; i < 1000; ++i) {
    const int size = 1 + draw.below(4);
    const auto model = make_model<double>(testing::random_stack(draw, size));
    Impact<double> impact = random_impact<double>(draw, size);
    const auto all = candidates(impact.before.pattern, impact.touching());
    const Pattern pattern = all[static_cast<std::size_t>(draw.below(static_cast<int>(all.size())))];
    const Vector<double> once = velocities_after(model, impact, pattern).relative;
    impact.before.pattern = pattern;
    impact.before.velocities = once;
    const Vector<double> twice = velocities_after(model, impact, pattern).relative;
    EXPECT_LE((twice - once).cwiseAbs().maxCoeff(), 1e-11 * (1 + once.cwiseAbs().maxCoeff()));
  }
}

// The claim at the head of impact.hpp: at most one pattern is admissible both ways, and it is found.
TEST(Impact, TheConsistentPatternIsUniqueAndFound) {
  Draw draw(24);
  int none = 0;
  for (int i = 0; i < 20000; ++i) {
    const int size = 1 + draw.below(i % 10 == 0 ? 6 : 4);
    const auto model = make_model<double>(testing::random_stack(draw, size));
    const auto impact = random_impact<double>(draw, size);
    std::vector<Pattern> admissible;
    for (const Pattern& pattern : candidates(impact.before.pattern, impact.touching())) {
      const auto solution = velocities_after(model, impact, pattern);
      if (!first_violation(model.stack, solution, impact.touching(), 0.0) && pushes(solution)) {
        admissible.push_back(pattern);
      }
    }
    const auto found = consistent_solution(model, impact, before_impact(model, impact.before));
    ASSERT_LE(admissible.size(), 1U);
    ASSERT_EQ(found.has_value(), !admissible.empty());
    if (found) {
      EXPECT_TRUE(found->pattern == admissible[0]);
    } else {
      ++none;
    }
  }
  EXPECT_GT(none, 0) << "the draws must include blocks that would lift off";
}

Impact<double> impact_of(Pattern pattern, const std::vector<double>& angles,
                         const std::vector<double>& velocities, int interface) {
  const auto size = static_cast<Eigen::Index>(angles.size());
  Impact<double> impact{{pattern, Vector<double>(size), Vector<double>(size)}, {}};
  for (Eigen::Index k = 0; k < size; ++k) {
    impact.before.angles[k] = angles[static_cast<std::size_t>(k)];
    impact.before.velocities[k] = velocities[static_cast<std::size_t>(k)];
  }
  impact.impacting.set(static_cast<std::size_t>(interface));
  return impact;
}

Pattern two(Contact lower, Contact upper) {
  Pattern pattern = closed_pattern(2);
  pattern[0] = lower;
  pattern[1] = upper;
  return pattern;
}

// A cube that falls back onto another one at rest: the paper's 1b drives the top into the base, its 4b needs
// a pull from the ground at one end of the base, and the consistent outcome is that the whole stack lifts.
TEST(Impact, ASquatTopThatFallsOnARestingBaseLiftsTheStack) {
  const Scene scene = testing::released({testing::block(1, 1), testing::block(1, 1)}, {0, 0}, 1);
  const auto model = make_model<double>(scene);
  const auto impact = impact_of(two(Contact::closed, Contact::right), {0, 0}, {0, -1}, 1);
  const auto open = velocities_after(model, impact, two(Contact::left, Contact::left));
  EXPECT_EQ(name(open.pattern), "1b");
  EXPECT_GT(open.relative[1], 0) << "the top moves into the base";
  const auto joined = velocities_after(model, impact, two(Contact::closed, Contact::left));
  EXPECT_EQ(name(joined.pattern), "4b");
  const auto ground = margins(model.stack, joined.reactions, 0);
  EXPECT_LT(std::min(ground.left, ground.right), 0) << "the ground would have to pull";
  const auto consistent = consistent_solution(model, impact, before_impact(model, impact.before));
  ASSERT_TRUE(consistent);
  EXPECT_EQ(name(consistent->pattern), "3b");
  const auto paper = resolve(model, impact, before_impact(model, impact.before), Law::paper);
  EXPECT_EQ(name(paper.solution.pattern), "4b");
  EXPECT_EQ(paper.consistency, Consistency::other);
  EXPECT_EQ(resolve(model, impact, before_impact(model, impact.before), Law::consistent).consistency,
            Consistency::consistent);
}

TEST(Impact, ThePaperTriesOpenThenJoinedThenClosed) {
  Draw draw(25);
  int counts[3] = {0, 0, 0};
  for (int i = 0; i < 4000; ++i) {
    Scene scene = testing::random_stack(draw, 2);
    if (draw.coin()) {  // so squat that no impact can reverse it: b/h > √2, Housner
      Block& top = scene.blocks[1];
      top.half_width = scene.blocks[0].half_width = 2 * (top.half_height + scene.blocks[0].half_height);
      top.inertia = rectangle_inertia(top.mass, top.half_width, top.half_height);
    }
    const auto model = make_model<double>(scene);
    const bool upper = draw.coin();  // pattern 4 hit by its top, or pattern 3 hitting the ground
    const auto impact = upper ? impact_of(two(Contact::closed, Contact::right), {0, 0}, {0, -1}, 1)
                              : impact_of(two(Contact::right, Contact::closed), {0, 0}, {-1, 0}, 0);
    const Pattern order[3] = {
        two(Contact::left, Contact::left),
        upper ? two(Contact::closed, Contact::left) : two(Contact::left, Contact::closed),
        two(Contact::closed, Contact::closed)};
    const auto chosen = paper_solution(
        impact, [&](const Pattern& pattern) { return velocities_after(model, impact, pattern); });
    int expected = 0;
    while (expected < 2 &&
           !kinematically_admissible(velocities_after(model, impact, order[expected]), impact.touching())) {
      ++expected;
    }
    EXPECT_TRUE(chosen.pattern == order[expected]);
    ++counts[expected];
  }
  for (const int count : counts) EXPECT_GT(count, 0);
}

TEST(Impact, TheMirrorImageOfAnImpactHasTheMirrorImageAfterIt) {
  Draw draw(26);
  for (int i = 0; i < 2000; ++i) {
    const int size = 1 + draw.below(4);
    const auto model = make_model<double>(testing::random_stack(draw, size));
    const auto impact = random_impact<double>(draw, size);
    Impact<double> mirrored = impact;
    mirrored.before.angles = -impact.before.angles;
    mirrored.before.velocities = -impact.before.velocities;
    for (int k = 0; k < size; ++k) mirrored.before.pattern[k] = opposite(impact.before.pattern[k]);
    for (const Law law : {Law::paper, Law::consistent}) {
      const auto one = resolve(model, impact, before_impact(model, impact.before), law);
      const auto other = resolve(model, mirrored, before_impact(model, mirrored.before), law);
      EXPECT_EQ(one.consistency, other.consistency);
      EXPECT_EQ(one.solution.relative, -other.solution.relative);  // to the bit
      for (int k = 0; k < size; ++k) EXPECT_EQ(one.solution.pattern[k], opposite(other.solution.pattern[k]));
    }
  }
}

}  // namespace
}  // namespace rockstack
