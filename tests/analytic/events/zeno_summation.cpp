#include "analytic/events/zeno_summation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "analytic/solver/solver.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

using Real = long double;

constexpr double ended_at = std::numeric_limits<double>::epsilon();  // rad: where chatter ends as a rule
constexpr double followed = 1e-19;                                   // and where it is followed to its end
constexpr double agreement = 1e-13;  // what the solver in double has with 113 bits

BasicHistory<Real> solved(const Scene& scene, SolveOptions options, EventsKept events, double resolution) {
  options.events = events;
  options.resolution = resolution;
  return Solver<Real>(scene, options).run();
}

Scene chattering_scene(std::uint64_t seed) {
  testing::Draw draw(12000 + seed);
  Scene scene = testing::random_scene(draw, 1 + draw.below(4), false);
  if (seed % 2 == 1) testing::shake(draw, scene);
  if (seed % 4 == 3) scene.equations = Equations::linear;
  return scene;
}

double most_apart(const std::vector<Real>& some, const std::vector<Real>& others) {
  EXPECT_EQ(some.size(), others.size());
  Real most = 0;
  for (std::size_t i = 0; i < std::min(some.size(), others.size()); ++i)
    most = std::max(most, std::abs(some[i] - others[i]));
  return static_cast<double>(most);
}

/// All events, each by itself.
std::size_t counted(const BasicHistory<Real>& history) {
  return std::accumulate(history.events.begin(), history.events.end(), std::size_t{0},
                         [](std::size_t sum, const auto& event) { return sum + event.count; });
}

/// Events that are no impacts in between.
std::vector<BasicEvent<Real>> turns(const BasicHistory<Real>& history) {
  std::vector<BasicEvent<Real>> kept;
  std::copy_if(history.events.begin(), history.events.end(), std::back_inserter(kept),
               [](const auto& event) { return event.kind != EventKind::impact; });
  return kept;
}

TEST(ZenoSummation, SummedUpItLeadsToTheMotionThatAllItsImpactsLeadTo) {
  std::size_t all = 0, summed = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Scene scene = chattering_scene(seed);
    const SolveOptions options{.sample_times = regular_times(0.05, scene.duration), .peaks = true};
    const auto exact = solved(scene, options, EventsKept::all, followed);
    const auto ended = solved(scene, options, EventsKept::all, ended_at);
    const auto found = solved(scene, options, EventsKept::summed, ended_at);
    EXPECT_LT(most_apart(found.angles, exact.angles), agreement) << seed;
    EXPECT_LT(most_apart(found.peaks, exact.peaks), agreement) << seed;
    const auto expected_turns = turns(ended);
    const auto found_turns = turns(found);
    ASSERT_EQ(found_turns.size(), expected_turns.size()) << seed;
    for (std::size_t i = 0; i < found_turns.size(); ++i) {
      EXPECT_EQ(found_turns[i].kind, expected_turns[i].kind) << seed;
      EXPECT_EQ(found_turns[i].interface, expected_turns[i].interface) << seed;
      EXPECT_EQ(found_turns[i].to, expected_turns[i].to) << seed;
    }
    all += ended.events.size();
    summed += counted(found);
  }
  EXPECT_LT(summed, all * 4 / 5) << "there must be chatter to sum up";
}

TEST(ZenoSummation, SummedUpItAsksOfInterfacesWhatAllItsImpactsDo) {
  std::size_t all = 0, summed = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Scene scene = chattering_scene(seed);
    const SolveOptions options{.validity = true};
    const auto expected = solved(scene, options, EventsKept::all, ended_at);
    const auto found = solved(scene, options, EventsKept::summed, ended_at);
    const auto near = [&](const Real& value, const Real& other, double unit) {
      if (value == other) return;
      EXPECT_NEAR(static_cast<double>(value - other), 0, agreement * unit) << seed;
    };
    const auto model = make_model<double>(scene);
    const double weight = model.gravity * model.stack.mass.sum();
    const double momentum =
        model.stack.mass.sum() * std::sqrt(2 * model.gravity * model.stack.half_height.sum());
    for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
      near(found.forces[k].least_normal, expected.forces[k].least_normal, weight);
      near(found.forces[k].friction, expected.forces[k].friction, 1);
      near(found.impulses[k].least_normal, expected.impulses[k].least_normal, momentum);
    }
    all += expected.events.size();
    summed += counted(found);
  }
  EXPECT_LT(summed, all);
}

// A coarse resolution sums no chatter up, so that the events are those that are kept one by one.
TEST(ZenoSummation, AnEventStandsForTheImpactsInARowThatItCounts) {
  std::size_t all = 0, summed = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Scene scene = chattering_scene(seed);
    const auto each = solved(scene, {}, EventsKept::all, 1e-9).events;
    const auto rows = solved(scene, {}, EventsKept::summed, 1e-9).events;
    auto event = each.begin();
    for (const auto& row : rows) {
      ASSERT_LE(row.count, static_cast<std::size_t>(each.end() - event)) << seed;
      EXPECT_EQ(row.from, event->from) << seed;
      Pattern pattern = row.from;
      for (std::size_t i = 0; i < row.count; ++i, ++event) {
        EXPECT_EQ(event->kind, row.kind) << seed;
        EXPECT_EQ(event->interface, row.interface) << seed;
        EXPECT_EQ(event->consistency, row.consistency) << seed;
        if (row.count == 1) continue;
        pattern[row.interface - 1] = opposite(pattern[row.interface - 1]);
        EXPECT_EQ(event->to, pattern) << seed;
      }
      EXPECT_EQ(row.time, std::prev(event)->time) << seed;
      EXPECT_EQ(row.to, std::prev(event)->to) << seed;
    }
    EXPECT_EQ(event, each.end()) << seed;
    all += each.size();
    summed += rows.size();
  }
  EXPECT_LT(summed, all * 4 / 5) << "there must be chatter";
}

// Just after the base has come to rest under the top. The cost is measured, so that it comes near the bound:
// what is left out goes with u³, and flights take less than their half a time.
TEST(ZenoSummation, TheMotionAfterItIsOffByTheResolutionAtMost) {
  Scene scene = testing::paper_example();
  scene.duration = 0.97;
  const SolveOptions options{.sample_times = {scene.duration}};
  const double rate = std::sqrt(scene.gravity / 3.75);  // √(g/H)
  const auto exact = solved(scene, options, EventsKept::all, followed);
  double nearest = 0;
  for (const double resolution : {5e-11, 1e-11, 1e-12, 1e-13}) {
    const auto found = solved(scene, options, EventsKept::summed, resolution);
    const double error = most_apart(found.velocities, exact.velocities) / (rate * resolution);
    EXPECT_LT(error, 1) << resolution;
    nearest = std::max(nearest, error);
  }
  EXPECT_GT(nearest, 0.1);
}

// A top that turns round while its base chatters may lean most within the chatter; one that moves on, or has
// leant more, does not.
TEST(ZenoSummation, WhereABlockMayLeanMostInItItIsFollowed) {
  const Scene scene = testing::paper_example();
  const auto model = make_model<double>(scene);
  const SolveOptions options{.peaks = true};
  Recorder<double, Eigen::Dynamic> recorder(scene, model, options);
  recorder.raise_peaks({0.05, 0.1}, {0.05, 0.1});
  const auto wants = [&](double angle, double velocity) {
    RestOfChatter<double, Eigen::Dynamic> rest{};
    rest.duration = 1e-5;
    rest.fastest = 10;
    rest.angles = Eigen::Vector2d(0, angle);
    rest.closure.relative = Eigen::Vector2d(0, velocity);
    rest.impact.relative = Eigen::Vector2d(1e-5, velocity - 2e-5);
    return recorder.wants(rest, 1.0);
  };
  EXPECT_TRUE(wants(0.1, 0));
  EXPECT_TRUE(wants(-0.1, 1e-5));
  EXPECT_TRUE(wants(0.1, -1e-5));
  EXPECT_FALSE(wants(0.1, 0.1));
  EXPECT_FALSE(wants(0.1, -0.1));
  EXPECT_FALSE(wants(0.099, 0));
}

TEST(ZenoSummation, WhereSamplesFallIntoItItIsFollowed) {
  Scene scene = testing::paper_example();
  scene.duration = 1;
  const auto ends = solved(scene, {}, EventsKept::all, ended_at);
  const auto closure = std::find_if(ends.events.begin(), ends.events.end(),
                                    [](const auto& event) { return event.kind == EventKind::closure; });
  ASSERT_NE(closure, ends.events.end());
  const auto end = static_cast<double>(closure->time);
  SolveOptions options;
  for (int i = 0; i < 100; ++i) options.sample_times.push_back(end - 1e-3 * std::pow(0.9, i));
  const auto exact = solved(scene, options, EventsKept::all, followed);
  const auto found = solved(scene, options, EventsKept::summed, ended_at);
  EXPECT_LT(most_apart(found.angles, exact.angles), agreement);
  EXPECT_LT(most_apart(found.velocities, exact.velocities), agreement);
}

/// One solid column of two blocks that chatters on the ground, whose acceleration stays as it is, from a slow
/// speed down by the law of impact and the accelerations of its flights; and what ZenoSummation says of the
/// rest as soon as it is harmless.
class ChatteringColumn {
 public:
  ChatteringColumn(double top, double ground) : model_(make_model<double, 2>(column(top))) {
    piece_.length = 1;
    piece_.horizontal.value = ground;
  }

  std::optional<RestOfChatter<double, 2>> rest() const {
    ZenoSummation<double, 2> chatter(model_, ended_at);
    const EndOfChatter<double, 2> end(model_, ended_at);
    State<double, 2> state = on(Contact::right);
    state.velocities[0] = -1e-2;
    double time = 0;
    for (std::size_t number = 0; std::abs(state.velocities[0]) > 1e-12; ++number) {
      const Impact<double, 2> impact{state, 1};
      const BeforeImpact<double, 2> before = before_impact(model_, state);
      Pattern pattern = state.pattern;
      pattern[0] = opposite(pattern[0]);
      const auto after = velocities_after(model_, before, pattern);
      const ZenoSummation<double, 2>::Landing landing{impact, before, after, piece_, time, number};
      state = {pattern, state.angles, after.relative};
      if (chatter.below_resolution(landing))
        return chatter.rest(landing, end.fastest_return(state, piece_.at(time)));
      time += 2 * std::abs(state.velocities[0]) / pull(pattern[0]);
      state.velocities = -state.velocities;
    }
    ADD_FAILURE() << "never harmless";
    return std::nullopt;
  }

  /// What brings it back, rad/s².
  double pull(Contact side) const { return -sign(side) * flight(side).relative[0]; }

  /// The least margin of the blocks' interface in a flight, over that of a load in its middle.
  double spare(Contact side) const {
    const auto margin = margins(model_.stack, flight(side).reactions, 1);
    return 2 * std::min(margin.right, margin.left) / (margin.right + margin.left);
  }

 private:
  /// With an upper block of a width.
  static Scene column(double top) {
    Scene scene;
    scene.blocks = {testing::block(1.05, 2), testing::block(top, 1)};
    scene.initial = {{0, 0}, {0, 0}};
    return scene;
  }

  static State<double, 2> on(Contact side) {
    State<double, 2> state{closed_pattern(2), {0, 0}, {0, 0}};
    state.pattern[0] = side;
    return state;
  }

  PatternSolution<double, 2> flight(Contact side) const { return accelerate(model_, on(side), piece_.at(0)); }

  Model<double, 2> model_;
  GroundPiece<double> piece_{};
};

/// The ground's acceleration at which what falls with it comes down to a level, m/s².
template <class Falling>
double acceleration_at(const Falling& falling, double level) {
  double low = 0, high = 20;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (falling(middle) > level ? low : high) = middle;
  }
  return low;
}

TEST(ZenoSummation, WhereAnInterfaceAboveIsAboutToOpenItIsFollowed) {
  const double narrow = 0.6;
  const auto spare = [&](double ground) {
    const ChatteringColumn column(narrow, ground);
    return std::min(column.spare(Contact::right), column.spare(Contact::left));
  };
  EXPECT_TRUE(ChatteringColumn(narrow, acceleration_at(spare, 0.02)).rest());
  EXPECT_FALSE(ChatteringColumn(narrow, acceleration_at(spare, 0.005)).rest());
}

TEST(ZenoSummation, WhereFlightsHardlyComeBackItIsFollowed) {
  const double wide = 1.05;
  const auto pull = [&](double ground) {
    const ChatteringColumn column(wide, ground);
    return std::min(column.pull(Contact::right), column.pull(Contact::left));
  };
  EXPECT_TRUE(ChatteringColumn(wide, acceleration_at(pull, 1)).rest());
  EXPECT_FALSE(ChatteringColumn(wide, acceleration_at(pull, 0.2)).rest());
}

}  // namespace
}  // namespace rockstack
