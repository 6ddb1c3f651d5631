#pragma once

namespace rockstack {

/// Where a block is and how it moves, in the frame in which the engine works: the ground's, or where the
/// ground really moves, that of its start. SI units; z is out of the plane.
struct BodyState {
  double x = 0, y = 0;                    ///< of the centre of mass, m
  double velocity_x = 0, velocity_y = 0;  ///< m/s
  double angle = 0;                       ///< rad, clockwise positive, unwrapped from the block's start
  double angular_velocity = 0;            ///< rad/s
  double z = 0;                           ///< m
  double tilt = 0;                        ///< sine of the angle out of the plane
};

/// What acts on a block over a step besides gravity and contact.
struct BodyLoad {
  double x = 0, y = 0;  ///< force through the centre of mass, to the right and up, N
  double moment = 0;    ///< clockwise, N·m
};

}  // namespace rockstack
