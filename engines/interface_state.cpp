#include "engines/interface_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analytic/scene/kinematics.hpp"

namespace rockstack {
namespace {

/// A face in its own axes: x along it from its middle, y out of the body.
struct Face {
  BlockPose middle;        ///< where the face's middle is
  double half_length = 0;  ///< m
  double outward = 1;      ///< +1: the top of its body, −1: the bottom
};

Point<double> along(const BlockPose& pose, double across, double up) {
  const Point<double> arm = turned(across, up, std::cos(pose.angle), std::sin(pose.angle));
  return {pose.x + arm.x(), pose.y + arm.y()};
}

Face face_of(const Block& block, const BlockPose& pose, double outward) {
  const Point<double> middle = along(pose, 0, outward * block.half_height);
  return {{middle.x(), middle.y(), pose.angle}, block.half_width, outward};
}

/// The face's end on one side.
Point<double> corner(const Face& face, double side) {
  return along(face.middle, side * face.half_length, 0);
}

/// A point in the face's axes.
Point<double> seen_from(const Face& face, const Point<double>& point) {
  const double x = point.x() - face.middle.x, y = point.y() - face.middle.y;
  const double cosine = std::cos(face.middle.angle), sine = std::sin(face.middle.angle);
  return {x * cosine - y * sine, face.outward * (x * sine + y * cosine)};
}

double deepest_corner(const Face& face, const Face& other) {
  double depth = -std::numeric_limits<double>::infinity();
  for (const double side : {-1.0, 1.0}) {
    const Point<double> place = seen_from(face, corner(other, side));
    if (std::abs(place.x()) <= face.half_length) depth = std::max(depth, -place.y());
  }
  return depth;
}

/// Of `upper`, a bottom, on `lower`, a top. `leaning`: −1 or 1.
double slip_of(const Face& lower, const Face& upper, double leaning) {
  const double on_lower = seen_from(lower, corner(upper, leaning)).x();
  if (leaning * on_lower <= lower.half_length) return on_lower - leaning * upper.half_length;
  return leaning * lower.half_length - seen_from(upper, corner(lower, leaning)).x();
}

}  // namespace

InterfaceState on_ground(const Block& block, const BlockPose& pose) {
  const Face ground{{}, std::numeric_limits<double>::infinity(), 1};
  const Face bottom = face_of(block, pose, -1);
  return {deepest_corner(ground, bottom), slip_of(ground, bottom, pose.angle < 0 ? -1 : 1)};
}

InterfaceState on_block(const Block& lower, const BlockPose& lower_pose, const Block& upper,
                        const BlockPose& upper_pose) {
  const Face top = face_of(lower, lower_pose, 1);
  const Face bottom = face_of(upper, upper_pose, -1);
  const double leaning = upper_pose.angle < lower_pose.angle ? -1 : 1;
  return {std::max(deepest_corner(top, bottom), deepest_corner(bottom, top)), slip_of(top, bottom, leaning)};
}

}  // namespace rockstack
