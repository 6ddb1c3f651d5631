#include "engines/trajectory.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <span>

#include "analytic/scene/messages/input_error.hpp"
#include "engines/contact_watch.hpp"

namespace rockstack {
namespace {

/// The state that a simulation is in, as the last sample of its trajectory.
void append(Trajectory& trajectory, const Simulation& simulation, std::size_t blocks, bool bodies) {
  const std::size_t start = trajectory.angles.size();
  trajectory.angles.resize(start + blocks);
  trajectory.velocities.resize(start + blocks);
  simulation.read(std::span(trajectory.angles).subspan(start),
                  std::span(trajectory.velocities).subspan(start));
  for (std::size_t k = 0; bodies && k < blocks; ++k) trajectory.bodies.push_back(simulation.body(k));
}

double stepping_seconds(Simulation& simulation, std::size_t steps) {
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t step = 0; step < steps; ++step) simulation.step();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

bool has_ended(const Setup& setup, const Trajectory& trajectory) {
  const std::size_t blocks = setup.blocks.size();
  const std::span<const double> last = std::span(trajectory.angles).last(blocks);
  for (std::size_t k = 0; k < blocks; ++k) {
    if (!(std::abs(last[k]) <= setup.toppling_angles[k])) return true;
  }
  return false;
}

void require_finite(const Trajectory& trajectory, std::size_t blocks, double dt) {
  const auto require = [&](double value, const char* quantity, std::size_t i) {
    if (std::abs(value) <= largest_number) return;
    const std::size_t sample = i / blocks;
    throw NotFinite(fmt::format("{} of block {} is not finite at t = {} s{}", quantity, i % blocks + 1,
                                static_cast<double>(sample) * dt,
                                std::isfinite(value) ? fmt::format(", or as good as: {}", value) : ""));
  };
  for (std::size_t i = 0; i < trajectory.angles.size(); ++i) {
    require(trajectory.angles[i], "angle", i);
    require(trajectory.velocities[i], "angular velocity", i);
  }
  for (std::size_t i = 0; i < trajectory.bodies.size(); ++i) {
    const BodyState& body = trajectory.bodies[i];
    for (const double value : {body.x, body.y, body.z, body.tilt}) require(value, "place", i);
    for (const double value : {body.velocity_x, body.velocity_y}) require(value, "velocity", i);
  }
}

Trajectory run(const Engine& engine, const Setup& setup, const Parameters& parameters, bool bodies) {
  const auto simulation = engine.start(setup, parameters);
  const std::size_t blocks = setup.blocks.size();
  Trajectory trajectory;
  trajectory.angles.reserve((setup.steps + 1) * blocks);
  trajectory.velocities.reserve((setup.steps + 1) * blocks);
  std::optional<ContactWatch> contacts;
  if (bodies && simulation->watch_contacts()) contacts.emplace(setup, engine.capabilities.largest_friction);
  const auto observe = [&] {
    append(trajectory, *simulation, blocks, bodies);
    if (!contacts) return;
    contacts->observe(simulation->contacts(), std::span(trajectory.angles).last(blocks),
                      std::span(trajectory.velocities).last(blocks));
  };
  observe();
  for (std::size_t step = 1; step <= setup.steps; ++step) {
    const std::size_t before = simulation->warnings();
    simulation->step();
    if (simulation->warnings() > before) ++trajectory.warnings;
    observe();
    if (has_ended(setup, trajectory)) break;
  }
  require_finite(trajectory, blocks, setup.dt);
  if (contacts) trajectory.contacts = contacts->record();
  return trajectory;
}

std::vector<double> time_stepping(const Engine& engine, const Setup& setup, const Parameters& parameters,
                                  std::size_t steps, int repeats) {
  std::vector<double> seconds;
  seconds.reserve(static_cast<std::size_t>(repeats));
  for (int run = 0; run < repeats; ++run)
    seconds.push_back(stepping_seconds(*engine.start(setup, parameters), steps));
  return seconds;
}

}  // namespace rockstack
