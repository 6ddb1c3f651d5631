#include "engines/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "engines/body_watch.hpp"

namespace rockstack {
namespace {

std::size_t steps_of(const Scene& scene, double dt) {
  check_step(dt, scene.duration);
  // A duration that is a whole number of steps up to rounding counts as one.
  return static_cast<std::size_t>(std::floor(scene.duration / dt + 1e-9));
}

void append(History& history, double time, const Simulation& simulation) {
  const auto width = static_cast<std::size_t>(history.blocks);
  const std::size_t start = history.angles.size();
  history.times.push_back(time);
  history.angles.resize(start + width);
  history.velocities.resize(start + width);
  simulation.read(std::span(history.angles).subspan(start), std::span(history.velocities).subspan(start));
}

void append_places(History& history, const BodyWatch& watch) {
  for (const InterfaceState& state : watch.interfaces()) {
    history.slips.push_back(state.slip);
    history.gaps.push_back(-state.depth);
  }
  for (const BlockPose& pose : watch.poses()) history.places.insert(history.places.end(), {pose.x, pose.y});
}

void require_finite(const History& history) {
  const std::size_t last = history.size() - 1;
  for (std::size_t k = 0; k < static_cast<std::size_t>(history.blocks); ++k) {
    const char* quantity = !std::isfinite(history.angles_at(last)[k])       ? "angle"
                           : !std::isfinite(history.velocities_at(last)[k]) ? "angular velocity"
                                                                            : nullptr;
    if (quantity == nullptr) continue;
    throw NotFinite(
        fmt::format("{} of block {} is not finite at t = {} s", quantity, k + 1, history.times[last]));
  }
}

bool has_toppled(const Scene& scene, std::span<const double> angles) {
  for (int k = 0; k < static_cast<int>(angles.size()); ++k) {
    if (std::abs(angles[static_cast<std::size_t>(k)]) > toppling_angle(scene, k)) return true;
  }
  return false;
}

/// True where the engine really moves the ground: all engines that can name the parameter so.
bool moves_ground(const Parameters& parameters) {
  const auto shaking = parameters.find("shaking");
  return shaking != parameters.end() && shaking->second != 0;
}

/// The coefficient that acts at each interface.
std::vector<double> acting_friction(const Engine& engine, const Scene& scene) {
  std::vector<double> friction = friction_of(scene);
  std::transform(friction.begin(), friction.end(), friction.begin(),
                 [&](double asked) { return engine.friction(asked); });
  return friction;
}

double stepping_seconds(Simulation& simulation, std::size_t steps) {
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t step = 0; step < steps; ++step) simulation.step();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

EngineRun simulate(const Engine& engine, const Scene& scene, double dt, const Parameters& parameters,
                   bool bodies) {
  const auto simulation = engine.start(scene, dt, parameters);
  const std::size_t steps = steps_of(scene, dt);
  History history;
  history.blocks = static_cast<int>(scene.blocks.size());
  history.times.reserve(steps + 1);
  history.angles.reserve((steps + 1) * scene.blocks.size());
  history.velocities.reserve((steps + 1) * scene.blocks.size());
  std::optional<BodyWatch> watch;
  const bool slips = scene.law == Law::unilateral;
  if (bodies || slips)
    watch.emplace(scene, dt, moves_ground(parameters), acting_friction(engine, scene), *simulation);
  const auto observe = [&](std::size_t step) {
    append(history, static_cast<double>(step) * dt, *simulation);
    if (watch) watch->observe(history.angles_at(step), history.velocities_at(step));
    if (slips) append_places(history, *watch);
  };
  observe(0);
  for (std::size_t step = 1; step <= steps; ++step) {
    simulation->step();
    observe(step);
    require_finite(history);
    if (has_toppled(scene, history.angles_at(step))) break;
  }
  EngineRun run{std::move(history), simulation->warnings(), {}};
  if (bodies) run.bodies = watch->record();
  return run;
}

std::vector<double> time_stepping(const Engine& engine, const Scene& scene, double dt,
                                  const Parameters& parameters, std::size_t steps, int repeats) {
  std::vector<double> seconds;
  seconds.reserve(static_cast<std::size_t>(repeats));
  for (int run = 0; run < repeats; ++run) {
    seconds.push_back(stepping_seconds(*engine.start(scene, dt, parameters), steps));
  }
  return seconds;
}

}  // namespace rockstack
