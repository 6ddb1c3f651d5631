#include "comparisons/suites/trajectory_axes.hpp"

#include <algorithm>
#include <array>

namespace rockstack {
namespace {

/// How far a motion in these axes is from one of the blocks in their plane, m: at the start, where the blocks
/// stand to each other and are turned, and a little where the lowest is; later out of the plane.
double distance_from_plane(const TrajectoryAxes& axes, const std::vector<SpatialBody>& bodies,
                           const std::vector<Placement>& blocks) {
  constexpr double own_origin = 1e-3;  // share that counts of where the lowest block is
  const BodyState base = axes.seen(bodies.front());
  double distance = own_origin * std::hypot(base.x - blocks.front().x, base.y - blocks.front().y);
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const BodyState state = axes.seen(bodies[k]);
    const Placement& block = blocks[k];
    distance += std::hypot(state.x - base.x - (block.x - blocks.front().x),
                           state.y - base.y - (block.y - blocks.front().y)) +
                block.height * std::abs(unwrap(state.angle, block.angle) - block.angle);
  }
  double apart = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyState state = axes.seen(bodies[i]);
    apart = std::max(apart, std::abs(state.z - base.z) + blocks[i % blocks.size()].height * state.tilt);
  }
  return distance + apart;
}

}  // namespace

BodyState TrajectoryAxes::seen(const SpatialBody& body) const {
  const Eigen::Vector3d out = right.cross(up);
  const Eigen::Vector3d along = body.turn * right, across = body.turn * out;
  return {.x = right.dot(body.place),
          .y = up.dot(body.place),
          .velocity_x = right.dot(body.velocity),
          .velocity_y = up.dot(body.velocity),
          .angle = -std::atan2(up.dot(along), right.dot(along)),
          .angular_velocity = -out.dot(body.spin),
          .z = out.dot(body.place),
          .tilt = std::hypot(right.dot(across), up.dot(across))};
}

TrajectoryAxes find_axes(const std::vector<SpatialBody>& bodies, const std::vector<Placement>& blocks) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  const std::array<TrajectoryAxes, 3> all{{{x, y}, {x, z}, {y, z}}};
  return *std::ranges::min_element(
      all, {}, [&](const TrajectoryAxes& axes) { return distance_from_plane(axes, bodies, blocks); });
}

}  // namespace rockstack
