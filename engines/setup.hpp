#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace rockstack {

/// What an engine has to be told about one block at t = 0. SI units; x to the right, y up from the ground, z
/// towards the viewer, so that a clockwise angle is a negative turn about z.
struct Placement {
  double x = 0, y = 0;                      ///< centre of mass, m
  double velocity_x = 0, velocity_y = 0;    ///< of the centre of mass, m/s
  double angle = 0;                         ///< rad, clockwise positive
  double angular_velocity = 0;              ///< rad/s, clockwise positive
  double width = 0, height = 0, depth = 0;  ///< full sizes, m
  double offset_x = 0, offset_y = 0;  ///< of the centre of mass from the box's middle, to its right and up, m
  double mass = 0;                    ///< kg
  double inertia_about_x = 0, inertia_about_y = 0, inertia = 0;  ///< `inertia` is about z, kg·m²
};

/// Whether a block's centre of mass is off the middle of its box.
inline bool is_eccentric(const Placement& block) {
  return block.offset_x != 0 || block.offset_y != 0;
}

/// Acceleration that every body feels in the frame in which the engine works, m/s².
struct BodyAcceleration {
  double x = 0, y = 0;
};

/// How a ground that really moves does so over one time step: it starts at a displacement and has a constant
/// velocity that carries it to where it is at the end. SI units; x to the right, y up.
struct GroundStep {
  double x = 0, y = 0;                    ///< displacement at the step's start, m
  double velocity_x = 0, velocity_y = 0;  ///< m/s
};

/// A box that stands still beside the blocks, upright. SI units.
struct FixedBox {
  double x = 0, y = 0;                      ///< centre, m
  double width = 0, height = 0, depth = 0;  ///< full sizes, m
};

/// A point that a block holds, from its centre of mass, in its axes; or of the ground, block 0, from below
/// the middle of the stack. m, to the right and up.
struct BodyPoint {
  std::size_t block = 0;  ///< from 1, bottom to top
  double x = 0, y = 0;
};

/// A force at a point of a block, in a direction that stays.
struct AppliedPush {
  BodyPoint point;
  double direction_x = 1, direction_y = 0;  ///< of length 1, to the right and up
  std::vector<double> forces = {};          ///< mean over each step, N
};

/// A tendon or a damper between two points. It pulls them together by prestress + stiffness × (l − length −
/// what it has yielded) + damping × dl/dt, with l their distance; the first two by no less than 0 and no more
/// than yield.
struct AppliedRestraint {
  BodyPoint from, to;
  double length = 0;                                       ///< m
  double stiffness = 0;                                    ///< N/m; 0 of a damper
  double prestress = 0;                                    ///< N
  double yield = std::numeric_limits<double>::infinity();  ///< N
  double damping = 0;                                      ///< N·s/m
};

/// A scene as an engine is told it: boxes on the ground y = 0, and what every time step does to them.
struct Setup {
  std::vector<Placement> blocks;              ///< bottom to top
  std::vector<double> friction;               ///< Coulomb's coefficient of each interface, from the ground up
  std::vector<double> kinetic_friction = {};  ///< likewise of what slides; empty where it is the same
  BodyAcceleration gravity;                   ///< in the ground's axes
  std::vector<double> toppling_angles;        ///< of each block, rad: a run ends where |angle| is above it
  double dt = 0;                              ///< s
  std::size_t steps = 0;
  std::optional<FixedBox> wall = {};
  /// Gravity less the ground's mean acceleration, of each step; empty where every step has gravity alone.
  std::vector<BodyAcceleration> accelerations;
  /// Motion of the ground in each step, where it really moves; else empty.
  std::vector<GroundStep> ground;
  std::vector<AppliedPush> pushes = {};
  std::vector<AppliedRestraint> restraints = {};
  /// For how long blocks go on with their velocities before a step's loads are found, s: so that the force of
  /// a step belongs to places as the engine's scheme has them. See lookahead().
  double lookahead = 0;
};

/// Half a step less the engine's lead, in s: a force that goes with the place of a step's middle makes no
/// energy. Semi-implicit Euler has that place as a step begins.
inline double lookahead(double dt, double lead) {
  return (0.5 - lead) * dt;
}

/// The coefficient of each interface where it slides, of engines that have a second one.
inline const std::vector<double>& kinetic_friction_of(const Setup& setup) {
  return setup.kinetic_friction.empty() ? setup.friction : setup.kinetic_friction;
}

/// How far a ground with edges should go to each side, m: ten times all blocks in a row. There must be one.
inline double ground_reach(const std::vector<Placement>& blocks) {
  double reach = blocks.front().depth;
  for (const Placement& block : blocks) reach += block.width + block.height;
  return 10 * reach;
}

}  // namespace rockstack
