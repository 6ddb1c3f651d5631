#include "engines/scene_setup.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "engines/ground_path.hpp"
#include "engines/placement.hpp"

namespace rockstack {
namespace {

/// True where the engine is to move the ground: all engines that can name the parameter so.
bool moves_ground(const Parameters& parameters) {
  const auto shaking = parameters.find("shaking");
  return shaking != parameters.end() && shaking->second != 0;
}

}  // namespace

Setup set_up(const Scene& scene, double dt, const Parameters& parameters) {
  check_step(dt, scene.duration);
  Setup setup;
  setup.blocks = place(scene);
  setup.friction = friction_of(scene);
  setup.gravity = body_acceleration(scene);
  for (int k = 0; k < static_cast<int>(scene.blocks.size()); ++k)
    setup.toppling_angles.push_back(toppling_angle(scene, k));
  setup.dt = dt;
  // A duration that is a whole number of steps up to rounding counts as one.
  setup.steps = static_cast<std::size_t>(std::floor(scene.duration / dt + 1e-9));
  if (!is_shaken(scene)) return setup;
  GroundPath path(scene, dt);
  for (std::size_t step = 0; step < setup.steps; ++step) {
    if (moves_ground(parameters)) {
      setup.ground.push_back(path.next());
    } else {
      const double start = static_cast<double>(step) * dt;
      setup.accelerations.push_back(body_acceleration(scene, start, static_cast<double>(step + 1) * dt));
    }
  }
  return setup;
}

void check_step(double dt, double duration) {
  const double shortest = 1e-9 * duration;
  if (!(dt >= shortest && dt <= duration * (1 + 1e-9)))
    throw std::invalid_argument(
        fmt::format("dt = {} s: must be from {} s to the duration, {} s", dt, shortest, duration));
}

}  // namespace rockstack
