#include "comparisons/measures/metrics/bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "analytic/solve.hpp"
#include "engines/worker/registry.hpp"
#include "tests/free_rocking.hpp"
#include "tests/native_engines.hpp"

namespace rockstack {
namespace {

TEST(Energy, OfTheExactMotionIsConstantBetweenImpactsAndNeverRises) {
  const Scene scene = free_rocking(3);
  const History history = solve(scene, {.sample_times = regular_times(1e-3, scene.duration)});
  const auto energy = energies(scene, history);
  const double rounding = 1e-12 * energy_scale(scene);
  for (std::size_t i = 0; i < history.size() && history.times[i] < 0.6; ++i) {
    EXPECT_NEAR(energy[i], energy[0], rounding) << history.times[i];
  }
  EXPECT_LT(largest_gain(energy), rounding);
  EXPECT_LT(energy.back(), 0.9 * energy.front());
}

TEST(Energy, IsZeroAtRestUpright) {
  Scene upright = free_rocking(3);
  upright.initial.angles = {0, 0};
  upright.duration = 0.1;
  Scene inclined = upright;
  inclined.inclination = 0.1;
  Scene uneven = inclined;
  uneven.blocks[1].offset_x = 0.1;
  uneven.blocks[1].offset_y = 0.2;
  for (const Scene& scene : {upright, inclined, uneven}) {
    const History history = solve(scene, {.sample_times = {0, 0.1}});
    for (const double energy : energies(scene, history)) EXPECT_NEAR(energy, 0, 1e-12 * energy_scale(scene));
  }
}

// A block 1 mm wide and 1 km high: its centre rises by b sin θ − h (1 − cos θ), and a rounding of its height
// is more than a thousandth of that.
TEST(Energy, OfAVerySlenderBlockKeepsItsDigits) {
  Scene scene;
  scene.blocks = {make_block(1e-3, 1000, 2500)};
  const double angle = 1e-7;
  History history;
  history.blocks = 1;
  history.times = {0};
  history.angles = {angle};
  history.velocities = {0};
  history.patterns = {closed_pattern(1)};
  history.patterns[0][0] = Contact::right;
  const double half = std::sin(angle / 2);
  const double rise = 0.5e-3 * std::sin(angle) - 2 * 500 * half * half;
  const double expected = scene.blocks[0].mass * scene.gravity * rise;
  EXPECT_NEAR(energies(scene, history)[0], expected, 1e-14 * expected);
}

// Both sides count from the same zero: an engine starts with the exact solution's energy.
TEST(Energy, EnginesStartWithThatOfTheExactSolution) {
  Scene scene = free_rocking(3);
  scene.inclination = 0.2;
  const History start = solve(scene, {.sample_times = {0}});
  for (const WorkerEngine& engine : native_engines()) {
    Scene brief = scene;
    brief.duration = 0.01;
    const WorkerRun made = run_in_worker(engine, brief, 1e-3, engine.tuned_parameters(), 0, {}, true);
    ASSERT_EQ(made.status, "done") << made.reason;
    // Single precision holds places of a few metres to 2e-7 m.
    EXPECT_NEAR(made.run.bodies.value().energy[0], energies(scene, start)[0], 1e-6 * energy_scale(scene))
        << engine.name << ":" << engine.solver;
  }
}

/// A block released from leaning, 2 m high and 1 m wide.
Scene leaning_block(double duration) {
  Scene scene;
  scene.duration = duration;
  scene.blocks = {make_block(1, 2, 2500)};
  scene.initial = {{0.2}, {0}};
  return scene;
}

/// Energy that tips a block over from rest.
double tipping_energy(const Scene& scene) {
  const Block& block = scene.blocks[0];
  return block.mass * scene.gravity * (std::hypot(block.half_width, block.half_height) - block.half_height);
}

EngineRun run_of(const WorkerEngine& engine, const Scene& scene, double dt, const Parameters& parameters) {
  WorkerRun made = run_in_worker(engine, scene, dt, parameters, 0, {}, true);
  EXPECT_EQ(made.status, "done") << made.reason;
  return std::move(made.run);
}

std::vector<double> sum(std::vector<double> one, const std::vector<double>& other) {
  for (std::size_t i = 0; i < one.size(); ++i) one[i] += other[i];
  return one;
}

// Seen by its bodies alone ODE's soft contact gains energy. All of that stood in the springs: implicit
// Euler's method only ever takes energy from them.
TEST(EnergyBalance, OfSoftContactNeverRises) {
  const Scene scene = leaning_block(2);
  const double tipping = tipping_energy(scene);
  for (const WorkerEngine& engine : native_engines()) {
    if (engine.name != "ode") continue;
    for (const double dt : {2e-3, 1e-3, 5e-4}) {
      Parameters parameters = engine.default_parameters();
      parameters["cfm"] = 1e-4;
      const BodyRecord record = run_of(engine, scene, dt, parameters).bodies.value();
      EXPECT_GT(largest_gain(record.energy), 0.05 * tipping) << engine.solver << " " << dt;
      EXPECT_LT(largest_gain(sum(record.energy, elastic_energy(record))), 3e-4 * tipping)
          << engine.solver << " " << dt;
      EXPECT_LT(largest_gain(energy_balance(record.energy, record.input, elastic_energy(record))),
                3e-4 * tipping);
    }
  }
}

/// A contact of k N/m and c N·s/m for a step of dt s.
Parameters spring(const WorkerEngine& engine, double k, double c, double dt) {
  Parameters parameters = engine.default_parameters();
  parameters["erp"] = dt * k / (dt * k + c);
  parameters["cfm"] = 1 / (dt * k + c);
  return parameters;
}

/// Root mean square difference of angles at the samples of the coarser run, which has half as many.
double apart(const History& coarse, const History& fine) {
  double squares = 0;
  for (std::size_t i = 0; i < coarse.size(); ++i)
    squares += std::pow(coarse.angles_at(i)[0] - fine.angles_at(2 * i)[0], 2);
  return std::sqrt(squares / static_cast<double>(coarse.size()));
}

// A method of first order: halving the step halves what the next halving still changes, up to terms of second
// order. With fixed erp and cfm each of these steps has a spring twice as stiff as the last, and nothing
// shrinks.
TEST(SoftContact, ConvergesWhereItsSpringStaysTheSame) {
  const Scene scene = leaning_block(1);
  for (const WorkerEngine& engine : native_engines()) {
    if (engine.name != "ode") continue;
    const auto change = [&](const auto& parameters, double dt) {
      return apart(run_of(engine, scene, dt, parameters(dt)).history,
                   run_of(engine, scene, dt / 2, parameters(dt / 2)).history);
    };
    const auto same_spring = [&](double dt) { return spring(engine, 2e6, 8e3, dt); };
    const auto same_share = [&](double) { return spring(engine, 2e6, 8e3, 1e-3); };
    EXPECT_NEAR(change(same_spring, 1e-3) / change(same_spring, 5e-4), 2, 0.3) << engine.solver;
    EXPECT_NEAR(change(same_share, 1e-3) / change(same_share, 5e-4), 1, 0.3) << engine.solver;
  }
}

/// What is told of one block at rest whose centre goes by so much, m, and turns by as much, rad, at each of
/// 101 times within 1 s.
template <class Way>
Unrest unrest(const Way& way, double height) {
  Scene scene = free_rocking(1);
  scene.blocks.resize(1);
  scene.initial = {{0}, {0}};
  const History exact = solve(scene, {.sample_times = regular_times(0.01, 1)});
  std::vector<double> centres = centres_of(scene, exact), gaps(exact.size(), height);
  History motion = exact;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    centres[2 * i] += way(exact.times[i]);
    motion.angles[i] += way(exact.times[i]);
  }
  return unrest_of(scene, exact, motion, centres, gaps);
}

TEST(Unrest, OfASteadyCreepIsItsSpeedAndOfATrembleNothing) {
  const Unrest creep = unrest([](double time) { return 7e-3 * time; }, 0.015);
  EXPECT_NEAR(creep.creep.value(), 7e-3, 1e-12);
  EXPECT_NEAR(creep.turn.value(), 7e-3, 1e-12);
  EXPECT_NEAR(creep.offset.value(), 7e-3, 1e-12);
  EXPECT_EQ(creep.hover.value(), 0.015);
  const Unrest slowing = unrest([](double time) { return -0.5 * (1 - time) * (1 - time); }, 0);
  EXPECT_LT(slowing.creep.value(), 0.05) << "the mean over the last tenth";
  const Unrest rocking =
      unrest([](double time) { return 0.065 * std::sin(2 * std::numbers::pi * time / 0.6); }, 0);
  EXPECT_EQ(rocking.turn.value(), 0) << "it goes one way over the last quarter of a second";
  const Unrest tremble =
      unrest([](double time) { return 1e-3 * std::cos(2 * std::numbers::pi * time / 0.1); }, 0);
  EXPECT_EQ(tremble.creep.value(), 0);
  EXPECT_EQ(tremble.turn.value(), 0);
}

// A fall, a landing at the third sample, and a hop of 4 cm after it.
TEST(LargestRise, IsBeyondWhatTheExactMotionHasThenAndLater) {
  History exact;
  exact.blocks = 1;
  exact.times = {0, 1, 2, 3, 4, 5};
  exact.gaps = {1, 0.5, 0, 0, 0, 0};
  const std::vector<double> hop{1, 0.52, 0.01, 0, 0.04, 0};
  EXPECT_DOUBLE_EQ(largest_rise(exact, hop, 5, 1), 0.04) << "a step late is not higher";
  EXPECT_DOUBLE_EQ(largest_rise(exact, hop, 0.5, 0), 0.52 - 0.5) << "beyond the horizon times do not tell";
}

TEST(EnergyGain, IsTheLargestRiseAboveTheLeastBefore) {
  EXPECT_EQ(largest_gain({5, 3, 4, 2, 3.5, 1}), 1.5);
  EXPECT_EQ(largest_gain({3, 2, 1}), 0);
}

using Values = std::vector<double>;

TEST(EnergyBalance, TakesTheWorkOfTheGroundOff) {
  EXPECT_EQ(energy_balance({0, 1, 2, 3}, {0, 1, 2, 2}, {0, 0, 0, 0}), (Values{0, 0, 0, 1}));
}

// A mass on a spring that is followed: what one loses the other holds.
TEST(EnergyBalance, IsConstantWhereSpringsTakeAndGiveBack) {
  EXPECT_EQ(energy_balance({5, 3, 1, 4, 5}, {0, 0, 0, 0, 0}, {0, 2, 4, 1, 0}), (Values{5, 5, 5, 5, 5}));
}

}  // namespace
}  // namespace rockstack
