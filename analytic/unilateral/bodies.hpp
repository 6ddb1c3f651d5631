#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <vector>

#include "analytic/scene/scene.hpp"
#include "analytic/unilateral/joint.hpp"

namespace rockstack {

/// A block as a free body in the frame of the ground: its centre of mass from the middle of the ground's
/// interface, and its angle, clockwise positive; or the rates of the three. SI units.
struct BodyPlacement {
  double x = 0, y = 0, angle = 0;
};

/// Positions and velocities of all blocks, bottom to top.
struct Bodies {
  std::vector<BodyPlacement> at, rate;
};

/// Three numbers a block: x, y and angle.
using FreeVector = Eigen::VectorXd;

FreeVector vector_of(const std::vector<BodyPlacement>& placements);
std::vector<BodyPlacement> placements_of(const FreeVector& vector);

/// A point of one body over the face of another; −1 is the ground.
struct CornerOnFace {
  int face = -1;  ///< the body that has the face
  int body = 0;   ///< the body that has the point
  double x = 0;   ///< the point from the middle of its body, in that body's frame, m
  double y = 0;
  double upward = 1;  ///< 1 for the top face of the lower body, −1 for the bottom face of the upper one
};

/// The corner of the upper block of interface k (from 0) at an end, or of the lower one under its face.
CornerOnFace upper_corner(const std::vector<Block>& blocks, int interface, int side);
CornerOnFace lower_corner(const std::vector<Block>& blocks, int interface, int side);
/// The point whose gap and slip a joint holds: its pivot, or the middle of the upper block's face.
CornerOnFace held_point(const std::vector<Block>& blocks, int interface, const Joint& joint);

/// Half-sizes with the ground endless and without height.
double half_width_of(const std::vector<Block>& blocks, int body);
double half_height_of(const std::vector<Block>& blocks, int body);

/// The centre of mass of a body from its middle, m; the ground has none.
Eigen::Vector2d centre_of(const std::vector<Block>& blocks, int body);

/// The distance of a point from a face and its place along it, upper against lower body, with their gradients
/// and with the second derivatives that velocities alone make. m, m/s².
struct PointRows {
  double gap = 0, slip = 0;
  double gap_bias = 0, slip_bias = 0;
  Eigen::RowVectorXd gap_row, slip_row;
};

PointRows rows_of(const std::vector<Block>& blocks, const Bodies& bodies, const CornerOnFace& corner);

/// The offset of a joint that touches, from where its held point is.
double offset_of(const std::vector<Block>& blocks, const Bodies& bodies, int interface, const Joint& joint);

/// Puts every block that touches exactly onto its joint: sticking at its offset, sliding at the offset that
/// it has reached, which it notes. Velocities likewise. So roundings of the motion do not add up to gaps.
void place(const std::vector<Block>& blocks, std::vector<Joint>& joints, Bodies& bodies);

}  // namespace rockstack
