#include "comparisons/suites/trajectory_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "analytic/scene/files/file_text.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/suites/trajectory_axes.hpp"
#include "comparisons/suites/trajectory_table.hpp"
#include "engines/scene_setup.hpp"

namespace rockstack {
namespace {

SpatialBody body_in_space(const MotionTable& table, const BodyTable& body, std::size_t i) {
  const auto vector = [i](const std::vector<double>& list) -> Eigen::Vector3d {
    if (list.empty()) return Eigen::Vector3d::Zero();
    return Eigen::Vector3d::Map(list.data() + 3 * i);
  };
  SpatialBody made{
      .place = vector(body.places), .velocity = vector(body.velocities), .spin = vector(body.spins)};
  if (body.turns.empty()) return made;
  const double* turn = body.turns.data() + 4 * i;
  const Eigen::Quaterniond read(turn[0], turn[1], turn[2], turn[3]);
  constexpr double rounded = 1e-3;
  if (!(std::abs(read.norm() - 1) < rounded))
    throw table.wrong(i,
                      fmt::format("qw, qx, qy, qz of length {:.4g}: must be a unit quaternion", read.norm()));
  made.turn = read.normalized();
  return made;
}

BodyState body_in_plane(const BodyTable& body, std::size_t i) {
  BodyState made;
  if (!body.places.empty()) std::tie(made.x, made.y) = std::pair(body.places[2 * i], body.places[2 * i + 1]);
  if (!body.velocities.empty())
    std::tie(made.velocity_x, made.velocity_y) =
        std::pair(body.velocities[2 * i], body.velocities[2 * i + 1]);
  if (!body.turns.empty()) made.angle = body.turns[i];
  if (!body.spins.empty()) made.angular_velocity = body.spins[i];
  return made;
}

/// States of a body, in its file's own origin; axes of poses in space.
std::vector<BodyState> states_of(const MotionTable& table, const BodyTable& body,
                                 const std::optional<TrajectoryAxes>& axes) {
  std::vector<BodyState> list;
  for (std::size_t i = 0; i < table.times.size(); ++i)
    list.push_back(axes ? axes->seen(body_in_space(table, body, i)) : body_in_plane(body, i));
  return list;
}

std::optional<TrajectoryAxes> axes_of(const MotionTable& table, const Setup& setup) {
  if (table.form != &in_space) return {};
  std::vector<SpatialBody> bodies;
  for (std::size_t i = 0; i < table.times.size(); ++i)
    for (const BodyTable& body : table.bodies) bodies.push_back(body_in_space(table, body, i));
  return find_axes(bodies, setup.blocks);
}

/// Puts rates of the step before in the place of those that are missing; at the start they are the scene's.
void add_rates(const std::vector<double>& times, const BodyTable& body, const Placement& start,
               std::vector<BodyState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    const BodyState& before = states[i == 0 ? 0 : i - 1];
    BodyState& now = states[i];
    const auto rate = [&](double BodyState::*at, double at_start) {
      return i == 0 ? at_start : (now.*at - before.*at) / (times[i] - times[i - 1]);
    };
    if (body.velocity.empty()) {
      now.velocity_x = rate(&BodyState::x, start.velocity_x);
      now.velocity_y = rate(&BodyState::y, start.velocity_y);
    }
    if (body.spin.empty()) now.angular_velocity = rate(&BodyState::angle, start.angular_velocity);
  }
}

/// Takes the ground's motion off.
void subtract(const std::vector<BodyState>& ground, std::vector<BodyState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    states[i].x -= ground[i].x;
    states[i].y -= ground[i].y;
    states[i].z -= ground[i].z;
    states[i].velocity_x -= ground[i].velocity_x;
    states[i].velocity_y -= ground[i].velocity_y;
  }
}

/// States of all blocks in the ground's frame, a list a block.
std::vector<std::vector<BodyState>> block_states(const MotionTable& table, const Setup& setup) {
  const auto axes = axes_of(table, setup);
  std::vector<BodyState> ground;
  if (table.ground) {
    ground = states_of(table, *table.ground, axes);
    add_rates(table.times, *table.ground, {}, ground);
  }
  std::vector<std::vector<BodyState>> list;
  for (std::size_t k = 0; k < table.bodies.size(); ++k) {
    std::vector<BodyState>& states = list.emplace_back(states_of(table, table.bodies[k], axes));
    double last = setup.blocks[k].angle;
    for (BodyState& state : states) last = state.angle = axes ? unwrap(state.angle, last) : state.angle;
    if (table.ground) subtract(ground, states);
    add_rates(table.times, table.bodies[k], setup.blocks[k], states);
  }
  return list;
}

/// A clock that begins later than after two steps is one of its own.
void start_clock(double dt, std::vector<double>& times) {
  constexpr double steps = 2;
  if (std::abs(times.front()) <= steps * dt) return;
  const double start = times.front();
  for (double& time : times) time -= start;
}

/// How near blocks have to start to where the scene has them: rad, and of the least height.
constexpr double start_tolerance = 0.01;

/// Moves all blocks by what the lowest is off at the start, where that is more than the tolerance: an origin
/// of the file's own. Out of the plane it is so anyway.
void move_to_origin(const Setup& setup, double tolerance, std::vector<std::vector<BodyState>>& blocks) {
  const BodyState& first = blocks.front().front();
  const Placement& start = setup.blocks.front();
  const bool own = std::hypot(first.x - start.x, first.y - start.y) > tolerance;
  const double x = own ? first.x - start.x : 0, y = own ? first.y - start.y : 0, z = first.z;
  for (std::vector<BodyState>& states : blocks)
    for (BodyState& state : states) {
      state.x -= x;
      state.y -= y;
      state.z -= z;
    }
}

/// What a block may have done up to the first sample counts as well.
void require_start(const MotionTable& table, const Setup& setup, double tolerance,
                   const std::vector<std::vector<BodyState>>& blocks) {
  const double passed = std::max(0.0, table.times.front());
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const BodyState& state = blocks[k].front();
    const Placement& start = setup.blocks[k];
    if (const double off = std::abs(state.angle - start.angle);
        off > start_tolerance + passed * std::abs(start.angular_velocity))
      throw table.wrong(0, fmt::format("block {} starts at an angle of {:.6g} rad: must be {:.6g}, clockwise "
                                       "positive, to {}",
                                       k + 1, state.angle, start.angle, start_tolerance));
    if (table.form->place.empty()) continue;
    const double speed = std::hypot(start.velocity_x, start.velocity_y);
    if (std::hypot(state.x - start.x, state.y - start.y) > tolerance + passed * speed)
      throw table.wrong(
          0, fmt::format("the centre of block {} starts at ({:.6g}, {:.6g}) m: must be at ({:.6g}, "
                         "{:.6g}) to {:.2g}",
                         k + 1, state.x, state.y, start.x, start.y, tolerance));
  }
}

/// Samples up to the scene's end, or to the first in which a block has toppled.
Trajectory trajectory_of(const MotionTable& table, const Setup& setup, double duration,
                         const std::vector<std::vector<BodyState>>& blocks) {
  Trajectory made;
  bool ended = false;
  for (std::size_t i = 0; i < table.times.size() && !ended; ++i) {
    if (table.times[i] > duration * (1 + 1e-9)) break;
    made.times.push_back(table.times[i]);
    for (const std::vector<BodyState>& states : blocks) {
      made.angles.push_back(states[i].angle);
      made.velocities.push_back(states[i].angular_velocity);
      if (!table.form->place.empty()) made.bodies.push_back(states[i]);
    }
    ended = has_ended(setup, made);
  }
  constexpr double steps = 1.5;
  if (const double last = made.times.back(); !ended && last < duration - steps * setup.dt)
    throw table.wrong(
        made.times.size() - 1,
        fmt::format("time = {}: must go on to {} s, where the scene ends, or to where a block topples", last,
                    duration));
  return made;
}

}  // namespace

TrajectoryFile read_trajectory(const std::filesystem::path& file, const Scene& scene) {
  MotionTable table = read_motion_table(file, scene);
  const double mean =
      (table.times.back() - table.times.front()) / static_cast<double>(table.times.size() - 1);
  const double dt = std::min(std::stod(fmt::format("{:.9g}", mean)), scene.duration);
  start_clock(dt, table.times);
  const Setup setup = set_up(scene, dt, {});
  auto blocks = block_states(table, setup);
  double height = std::numeric_limits<double>::infinity();
  for (const Placement& block : setup.blocks) height = std::min(height, block.height);
  if (!table.form->place.empty()) move_to_origin(setup, start_tolerance * height, blocks);
  require_start(table, setup, start_tolerance * height, blocks);
  return {file, checksum(file_text(file, largest_results)), dt,
          trajectory_of(table, setup, scene.duration, blocks)};
}

}  // namespace rockstack
