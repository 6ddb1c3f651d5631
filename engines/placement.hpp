#pragma once

#include <vector>

#include "analytic/scene/scene.hpp"

namespace rockstack {

/// What an engine has to be told about one block at t = 0. SI units; x to the right, y up from the ground, z
/// towards the viewer, so that a clockwise angle is a negative turn about z.
struct Placement {
  double x = 0, y = 0;                                           ///< centre, m
  double velocity_x = 0, velocity_y = 0;                         ///< of the centre, m/s
  double angle = 0;                                              ///< rad, clockwise positive
  double angular_velocity = 0;                                   ///< rad/s, clockwise positive
  double width = 0, height = 0, depth = 0;                       ///< full sizes, m
  double mass = 0;                                               ///< kg
  double inertia_about_x = 0, inertia_about_y = 0, inertia = 0;  ///< `inertia` is about z, kg·m²
};

/// Bottom to top: pivots touch, centres move as the pattern and the slips of the initial state make them.
/// @throws std::runtime_error for a restitution, or a centre of mass off a block's middle, in one line.
std::vector<Placement> place(const Scene& scene);

/// Acceleration that every body feels in the ground's frame, m/s².
struct BodyAcceleration {
  double x = 0, y = 0;
};

/// Gravity alone, in the axes of the ground.
BodyAcceleration body_acceleration(const Scene& scene);

/// Gravity less the mean ground acceleration over [from, to], from < to.
BodyAcceleration body_acceleration(const Scene& scene, double from, double to);

/// True where a ground motion makes body_acceleration() change with time.
inline bool is_shaken(const Scene& scene) {
  return !scene.horizontal.empty() || !scene.vertical.empty();
}

/// The angle that differs from `wrapped` by whole turns and lies next to `last`, rad.
double unwrap(double wrapped, double last);

}  // namespace rockstack
