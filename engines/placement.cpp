#include "engines/placement.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "analytic/scene/kinematics.hpp"

namespace rockstack {
namespace {

Placement shape_of(const Block& block, double depth) {
  Placement placement;
  placement.width = 2 * block.half_width;
  placement.height = 2 * block.half_height;
  placement.depth = depth;
  placement.mass = block.mass;
  placement.inertia = block.inertia;
  placement.inertia_about_x = rectangle_inertia(block.mass, 0.5 * depth, block.half_height);
  placement.inertia_about_y = rectangle_inertia(block.mass, block.half_width, 0.5 * depth);
  return placement;
}

Vector<double> vector_of(const std::vector<double>& values) {
  return Vector<double>::Map(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Says what engines have no equivalent of, rather than leave it out.
void require_for_engines(const Scene& scene) {
  if (!scene.restitution.empty())
    throw std::runtime_error("restitution: must be left out for engines, whose impacts have no such ratio");
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    if (scene.blocks[k].offset_x != 0 || scene.blocks[k].offset_y != 0)
      throw std::runtime_error(
          "blocks." + std::to_string(k + 1) +
          ".center_of_mass: must be left out for engines, which are given uniform boxes");
  }
}

/// What slip at the start adds to the velocity of each centre: that of its own interface and of all below.
Points<double> slip_motions(const Stack<double>& stack, const InitialState& initial) {
  Points<double> motions = Points<double>::Zero(2, stack.size());
  Point<double> carried = Point<double>::Zero();
  for (int k = 0; k < stack.size() && !initial.slip_velocities.empty(); ++k) {
    const int along = face(stack, k);
    const double angle = along < 0 ? 0 : initial.angles[static_cast<std::size_t>(along)];
    carried +=
        turned(initial.slip_velocities[static_cast<std::size_t>(k)], 0.0, std::cos(angle), std::sin(angle));
    motions.col(k) = carried;
  }
  return motions;
}

}  // namespace

std::vector<Placement> place(const Scene& scene) {
  require_for_engines(scene);
  const Vector<double> angles = vector_of(scene.initial.angles);
  const Vector<double> velocities = vector_of(scene.initial.velocities);
  const Pattern pattern = pattern_of(relative(angles), relative(velocities));
  const Stack<double> stack = make_stack<double>(scene);
  const Chain<double> chain = make_chain(stack, pattern, angles);
  const Points<double> middles = centres(chain);
  const Points<double> motions = centre_velocities(chain, velocities) + slip_motions(stack, scene.initial);

  std::vector<Placement> placements;
  for (Eigen::Index k = 0; k < angles.size(); ++k) {
    Placement placement = shape_of(scene.blocks[static_cast<std::size_t>(k)], scene.engine.depth);
    placement.x = middles(0, k);
    placement.y = middles(1, k);
    placement.velocity_x = motions(0, k);
    placement.velocity_y = motions(1, k);
    placement.angle = angles[k];
    placement.angular_velocity = velocities[k];
    placements.push_back(placement);
  }
  return placements;
}

BodyAcceleration body_acceleration(const Scene& scene) {
  const Gravity gravity = gravity_of(scene);
  return {gravity.along, -gravity.across};
}

BodyAcceleration body_acceleration(const Scene& scene, double from, double to) {
  const BodyAcceleration still = body_acceleration(scene);
  return {still.x - mean_acceleration(scene.horizontal, from, to),
          still.y - mean_acceleration(scene.vertical, from, to)};
}

}  // namespace rockstack
