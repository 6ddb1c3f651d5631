#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/analytic/mechanics/maximal.hpp"
#include "tests/analytic/solver/stacks.hpp"
#include "tests/stride.hpp"

namespace rockstack {
namespace {

using testing::Column;

State<double> state_of(const History& history, std::size_t sample) {
  const auto relative_of = [](std::span<const double> row) {
    Vector<double> values(static_cast<Eigen::Index>(row.size()));
    std::copy(row.begin(), row.end(), values.begin());
    return relative(values);
  };
  return {history.patterns[sample], relative_of(history.angles_at(sample)),
          relative_of(history.velocities_at(sample))};
}

/// Instants at which the ground's acceleration or the motion may jump or kink.
std::vector<double> kinks(const Scene& scene, const History& history) {
  std::vector<double> times{0};
  for (const GroundMotion* motion : {&scene.horizontal, &scene.vertical}) {
    for (std::size_t i = 0; i < motion->samples.size(); ++i)
      times.push_back(static_cast<double>(i) * motion->interval);
    if (!motion->pulse) continue;
    times.push_back(motion->pulse->start);
    times.push_back(motion->pulse->start + length(*motion->pulse));
  }
  const bool toppled = !history.events.empty() && history.events.back().kind == EventKind::topple;
  const double end = toppled ? history.events.back().time : scene.duration;
  for (const Event& event : history.events) times.push_back(event.time);
  std::erase_if(times, [end](double time) { return time >= end; });
  times.push_back(end);
  std::sort(times.begin(), times.end());
  return times;
}

/// Gauss's rule with three points on stretches of at most 2 ms between kinks: what it leaves out is of the
/// sixth order, far below the solver's own error.
struct Nodes {
  std::vector<double> times, weights;  // s
};

Nodes gauss_nodes(const std::vector<double>& kinks) {
  const double offset = std::sqrt(0.6);
  Nodes nodes;
  for (std::size_t i = 1; i < kinks.size(); ++i) {
    const int pieces = static_cast<int>(std::ceil((kinks[i] - kinks[i - 1]) / 2e-3));
    const double half = (kinks[i] - kinks[i - 1]) / (2 * std::max(pieces, 1));
    for (int piece = 0; piece < pieces; ++piece) {
      const double middle = kinks[i - 1] + (2 * piece + 1) * half;
      for (const auto& [place, weight] :
           {std::pair{-offset, 5.0 / 9}, std::pair{0.0, 8.0 / 9}, std::pair{offset, 5.0 / 9}}) {
        nodes.times.push_back(middle + place * half);
        nodes.weights.push_back(weight * half);
      }
    }
  }
  return nodes;
}

double kinetic_energy(const Model<double>& model, const State<double>& state) {
  return energy(model, state) - energy(model, {state.pattern, state.angles, 0 * state.velocities});
}

/// Work of the inertial force −m(ẍg, ÿg) in the frame of the ground, J.
double work(const Scene& scene, const History& history, const Nodes& nodes, double from, double to) {
  const auto model = make_model<double>(scene);
  double result = 0;
  const auto first = std::lower_bound(nodes.times.begin(), nodes.times.end(), from) - nodes.times.begin();
  for (auto i = static_cast<std::size_t>(first); i < history.size() && nodes.times[i] < to; ++i) {
    const State<double> state = state_of(history, i);
    const Point<double> ground{acceleration(scene.horizontal, nodes.times[i]),
                               acceleration(scene.vertical, nodes.times[i])};
    const auto speeds =
        centre_velocities(make_chain(model.stack, state.pattern, directions_at(model, state.angles)),
                          absolute(state.velocities));
    result -= nodes.weights[i] * (speeds * model.stack.mass).dot(ground);
  }
  return result;
}

double largest_kinetic_energy(const Scene& scene, const History& history) {
  const auto model = make_model<double>(scene);
  double largest = 0;
  for (std::size_t i = 0; i < history.size(); ++i)
    largest = std::max(largest, kinetic_energy(model, state_of(history, i)));
  return largest;
}

TEST(Balances, BetweenEventsEnergyChangesByTheWorkOfTheGround) {
  for (std::uint64_t seed = 0; seed < 1000; seed += testing::stride) {
    const Scene scene = testing::seeded_scene(8000 + seed);
    const Nodes nodes = gauss_nodes(kinks(scene, solve(scene)));
    const History history = solve(scene, {.sample_times = nodes.times});
    const double kinetic = largest_kinetic_energy(scene, history);
    double weight = 0;
    for (const Block& block : scene.blocks) weight += block.mass * scene.gravity * block.half_height;
    // Closures are told where their impacts accumulate, with the state of the last one that is followed:
    // energy is held across them, less what they take.
    const auto energy_at = [&](const Event& event, const Pattern& pattern, const std::vector<double>& rates) {
      return testing::energy_above_rest(scene, pattern, event.angles, rates);
    };
    const Event* first = history.events.empty() ? nullptr : &history.events.front();
    double taken = 0;
    for (std::size_t i = 1; i < history.events.size(); ++i) {
      const Event& last = history.events[i];
      const double end = energy_at(last, last.from, last.before);
      if (last.kind == EventKind::closure) {
        taken += end - energy_at(last, last.to, last.after);
        continue;
      }
      const double start = energy_at(*first, first->to, first->after);
      const double done = work(scene, history, nodes, first->time, last.time);
      // Error of the work by the rule: (λh)⁶/2016000, below 1e-11 up to λ = 80/s; of the energy, rounding.
      ASSERT_NEAR(end - start + taken, done, 1e-11 * (weight + kinetic))
          << "seed " << seed << " from " << first->time << " to " << last.time;
      first = &last;
      taken = 0;
    }
  }
}

Column velocities_of(const testing::Placement& placement, const std::vector<double>& absolute_velocities) {
  Vector<testing::Number> values(static_cast<Eigen::Index>(absolute_velocities.size()));
  std::copy(absolute_velocities.begin(), absolute_velocities.end(), values.begin());
  return testing::velocities(placement, relative(values));
}

TEST(Balances, EveryImpactKeepsTheAngularMomentumAboutEachNewPivot) {
  int impacts = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Scene scene = testing::seeded_scene(8000 + seed);
    const auto model = make_model<testing::Number>(scene);
    for (const Event& event : solve(scene).events) {
      if (event.kind == EventKind::opening || event.kind == EventKind::topple) continue;
      ++impacts;
      Vector<testing::Number> angles(static_cast<Eigen::Index>(event.angles.size()));
      std::copy(event.angles.begin(), event.angles.end(), angles.begin());
      angles = relative(angles);
      const auto place = testing::place(model, event.to, angles);
      const auto before = velocities_of(testing::place(model, event.from, angles), event.before);
      const auto after = velocities_of(place, event.after);
      // Double rounding of the velocities, five digits lost to mass ratios.
      const testing::Number scale =
          std::sqrt(testing::kinetic_energy(model, before) * model.stack.mass.sum()) * 10;
      for (int k = 0; k < model.stack.size(); ++k) {
        if (event.to[k] == Contact::closed) continue;
        ASSERT_NEAR(static_cast<double>(testing::angular_momentum(model, place, before, k)),
                    static_cast<double>(testing::angular_momentum(model, place, after, k)),
                    static_cast<double>(1e-11L * scale))
            << "seed " << seed << " at " << event.time;
      }
    }
  }
  EXPECT_GT(impacts, 10000);
}

}  // namespace
}  // namespace rockstack
