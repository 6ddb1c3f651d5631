#include "tests/engines/findings/draws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analytic/solve.hpp"
#include "comparisons/measures/statistics/draws.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/suites/suite.hpp"
#include "tests/engines/linked_engines.hpp"

namespace rockstack {

std::vector<Draw> replicates(const Scene& scene, double dt, int runs) {
  const Distribution jitter{Distribution::Kind::uniform, 0.97, 1.03};
  std::vector<Draw> list;
  for (int run = 0; run < runs; ++run) {
    const double factor = draw(jitter, {7, static_cast<std::uint64_t>(run), 0});
    list.push_back({perturbed(scene, {runs, 1e-6, 3}, run), factor * dt});
  }
  return list;
}

Quartiles quartiles(const std::vector<double>& values) {
  return {quantile(values, 0.25), median(values), quantile(values, 0.75)};
}

const Engine* linked(const std::string& name) {
  for (const auto& engine : linked_engines()) {
    if (engine->full_name() == name) return engine;
  }
  return nullptr;
}

Parameters with(Parameters parameters, const Parameters& changes) {
  for (const auto& [name, value] : changes) parameters.at(name) = value;
  return parameters;
}

namespace {

Parameters made_gentle(Parameters parameters) {
  const Parameters changes{{"erp", 0.01},
                           {"contactMu2", 1},
                           {"quickStepNumIterations", 100},
                           {"splitImpulsePenetrationThreshold", 0},
                           {"numIterations", 50}};
  for (const auto& [name, value] : changes) {
    if (parameters.count(name) != 0) parameters[name] = value;
  }
  return parameters;
}

}  // namespace

Parameters gentle(const WorkerEngine& engine) {
  return made_gentle(engine.default_parameters());
}

Parameters gentle(const Engine& engine) {
  return made_gentle(engine.default_parameters());
}

double error_of(const Draw& draw, const std::vector<double>& angles) {
  SolveOptions options;
  for (std::size_t step = 0; step * draw.scene.blocks.size() < angles.size(); ++step)
    options.sample_times.push_back(static_cast<double>(step) * draw.dt);
  if (options.sample_times.back() < draw.scene.duration - 1.5 * draw.dt) return std::numbers::pi;
  Scene scene = draw.scene;
  scene.law = Law::consistent;
  const History exact = solve(scene, options);
  double largest = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double difference = std::abs(angles[i] - exact.angles.at(i));
    // A number that is none compares as false.
    largest = difference <= std::numbers::pi ? std::max(largest, difference) : std::numbers::pi;
  }
  return largest;
}

double error(const Engine& engine, const Draw& draw, const Parameters& parameters) {
  try {
    return error_of(draw, simulate(engine, draw.scene, draw.dt, parameters).history.angles);
  } catch (const NotFinite&) {
    return std::numbers::pi;
  }
}

std::vector<double> errors(const Engine& engine, const std::vector<Draw>& draws,
                           const Parameters& parameters) {
  std::vector<double> list;
  list.reserve(draws.size());
  for (const Draw& draw : draws) list.push_back(error(engine, draw, parameters));
  return list;
}

Scene slender_block(double duration) {
  Scene scene;
  scene.duration = duration;
  scene.blocks = {make_block(0.5, 2.5, 2500)};
  scene.initial = {{0.1}, {0}};
  return scene;
}

void scale_mass(Block& block, double factor) {
  block.mass *= factor;
  block.inertia *= factor;
}

}  // namespace rockstack
