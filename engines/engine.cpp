#include "engines/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "analytic/scene/input_error.hpp"
#ifdef ROCKSTACK_WITH_BULLET
#include "engines/bullet/bullet.hpp"
#endif
#ifdef ROCKSTACK_WITH_ODE
#include "engines/ode/ode.hpp"
#endif

namespace rockstack {
namespace {

std::vector<std::unique_ptr<Engine>> make_engines() {
  std::vector<std::unique_ptr<Engine>> list;
#ifdef ROCKSTACK_WITH_BULLET
  for (auto& engine : make_bullet()) list.push_back(std::move(engine));
#endif
#ifdef ROCKSTACK_WITH_ODE
  for (auto& engine : make_ode()) list.push_back(std::move(engine));
#endif
  return list;
}

std::string joined(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

std::size_t steps_of(const Scene& scene, double dt) {
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

void require_finite(const History& history) {
  const std::size_t last = history.size() - 1;
  for (std::size_t k = 0; k < static_cast<std::size_t>(history.blocks); ++k) {
    const char* quantity = !std::isfinite(history.angles_at(last)[k])       ? "angle"
                           : !std::isfinite(history.velocities_at(last)[k]) ? "angular velocity"
                                                                            : nullptr;
    if (quantity == nullptr) continue;
    throw std::runtime_error(
        fmt::format("{} of block {} is not finite at t = {} s", quantity, k + 1, history.times[last]));
  }
}

bool has_toppled(const Scene& scene, std::span<const double> angles) {
  for (int k = 0; k < static_cast<int>(angles.size()); ++k) {
    if (std::abs(angles[static_cast<std::size_t>(k)]) > toppling_angle(scene, k)) return true;
  }
  return false;
}

double stepping_seconds(Simulation& simulation, std::size_t steps) {
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t step = 0; step < steps; ++step) simulation.step();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

const std::vector<std::unique_ptr<Engine>>& engines() {
  static const std::vector<std::unique_ptr<Engine>> list = make_engines();
  return list;
}

std::vector<std::string> engines_left_out() {
  std::vector<std::string> names;
#ifndef ROCKSTACK_WITH_BULLET
  names.emplace_back("bullet");
#endif
#ifndef ROCKSTACK_WITH_ODE
  names.emplace_back("ode");
#endif
  return names;
}

const Engine& find_engine(const std::string& name) {
  std::vector<std::string> there;
  there.reserve(engines().size());
  for (const auto& engine : engines()) {
    const std::string full = engine->name() + ":" + engine->solver();
    if (name == engine->name() || name == full) return *engine;
    there.push_back(full);
  }
  throw InputError(fmt::format("engine = {}: must be one of: {}; left out of this build: {}", name,
                               joined(there), joined(engines_left_out())));
}

EngineRun simulate(const Engine& engine, const Scene& scene, double dt, const Parameters& parameters) {
  const auto simulation = engine.start(scene, dt, parameters);
  const std::size_t steps = steps_of(scene, dt);
  History history;
  history.blocks = static_cast<int>(scene.blocks.size());
  history.times.reserve(steps + 1);
  history.angles.reserve((steps + 1) * scene.blocks.size());
  history.velocities.reserve((steps + 1) * scene.blocks.size());
  append(history, 0, *simulation);
  for (std::size_t step = 1; step <= steps; ++step) {
    simulation->step();
    append(history, static_cast<double>(step) * dt, *simulation);
    require_finite(history);
    if (has_toppled(scene, history.angles_at(step))) break;
  }
  return {std::move(history), simulation->warnings()};
}

SteppingTime stepping_time(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const double median = 0.5 * (seconds[(seconds.size() - 1) / 2] + seconds[seconds.size() / 2]);
  return {seconds.front(), median, static_cast<int>(seconds.size())};
}

SteppingTime time_stepping(const Engine& engine, const Scene& scene, double dt, const Parameters& parameters,
                           int repeats) {
  if (repeats < 1) throw std::invalid_argument(fmt::format("repeats = {}: must be at least 1", repeats));
  // The warm-up is a whole simulation: it tells how many steps there are before a block topples.
  const std::size_t steps = simulate(engine, scene, dt, parameters).history.size() - 1;
  std::vector<double> seconds;
  seconds.reserve(static_cast<std::size_t>(repeats));
  for (int run = 0; run < repeats; ++run) {
    seconds.push_back(stepping_seconds(*engine.start(scene, dt, parameters), steps));
  }
  return stepping_time(std::move(seconds));
}

}  // namespace rockstack
