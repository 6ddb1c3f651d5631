#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "engines/contact_point.hpp"

namespace rockstack {

/// Where a block's centre is and how it moves, in the frame in which the engine works: the ground's, or
/// where the ground really moves, that of its start. SI units; z is out of the plane.
struct BodyState {
  double x = 0, y = 0;                    ///< m
  double velocity_x = 0, velocity_y = 0;  ///< m/s
  double z = 0;                           ///< m
  double tilt = 0;                        ///< sine of the angle out of the plane
};

/// A scene inside an engine, ready to step. Blocks count from 0, bottom to top.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Advances by one time step; ground motion enters as its mean over the step.
  virtual void step() = 0;

  /// Writes the angles (rad, clockwise positive, from the rotation, unwrapped from the block's start) and
  /// angular velocities (rad/s) of all blocks.
  virtual void read(std::span<double> angles, std::span<double> velocities) const = 0;

  virtual BodyState body(std::size_t block) const = 0;

  /// Lets contacts() tell what every step from now on makes of its contacts, at some cost.
  /// @return whether the engine can.
  virtual bool watch_contacts() { return false; }

  /// The contacts of the last step; none before the first, or where they are not watched.
  virtual std::vector<ContactPoint> contacts() const { return {}; }

  /// How often the engine has said that its solver failed in a step that it then went on from.
  virtual std::size_t warnings() const { return 0; }
};

/// The angle that differs from `wrapped` by whole turns and lies next to `last`, rad.
inline double unwrap(double wrapped, double last) {
  return last + std::remainder(wrapped - last, 2 * std::numbers::pi);
}

}  // namespace rockstack
