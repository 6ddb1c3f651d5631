#include "analytic/unilateral/bodies.hpp"

namespace rockstack {
namespace {

using Plane = Eigen::Vector2d;

/// A body vector turned clockwise by an angle.
Plane turned(const Plane& vector, double angle) {
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  return {vector.x() * cosine + vector.y() * sine, vector.y() * cosine - vector.x() * sine};
}

/// Velocity of a point at an arm at unit clockwise rate.
Plane quarter_turned(const Plane& arm) {
  return {arm.y(), -arm.x()};
}

BodyPlacement placement(const std::vector<BodyPlacement>& placements, int body) {
  return body < 0 ? BodyPlacement{} : placements[static_cast<std::size_t>(body)];
}

/// How a joint's slip coordinate, that of its held point, differs from its offset.
double slip_from_offset(const std::vector<Block>& blocks, int interface, const Joint& joint) {
  if (joint.corner_below && joint.pivots()) return -joint.side() * half_width_of(blocks, interface - 1);
  return joint.side() * half_width_of(blocks, interface);
}

}  // namespace

FreeVector vector_of(const std::vector<BodyPlacement>& placements) {
  FreeVector vector(3 * static_cast<Eigen::Index>(placements.size()));
  for (std::size_t k = 0; k < placements.size(); ++k)
    vector.segment<3>(3 * static_cast<Eigen::Index>(k)) << placements[k].x, placements[k].y,
        placements[k].angle;
  return vector;
}

std::vector<BodyPlacement> placements_of(const FreeVector& vector) {
  std::vector<BodyPlacement> placements(static_cast<std::size_t>(vector.size() / 3));
  for (std::size_t k = 0; k < placements.size(); ++k) {
    const auto first = 3 * static_cast<Eigen::Index>(k);
    placements[k] = {vector[first], vector[first + 1], vector[first + 2]};
  }
  return placements;
}

double half_width_of(const std::vector<Block>& blocks, int body) {
  return body < 0 ? std::numeric_limits<double>::infinity()
                  : blocks[static_cast<std::size_t>(body)].half_width;
}

double half_height_of(const std::vector<Block>& blocks, int body) {
  return body < 0 ? 0 : blocks[static_cast<std::size_t>(body)].half_height;
}

Eigen::Vector2d centre_of(const std::vector<Block>& blocks, int body) {
  if (body < 0) return {0, 0};
  const Block& block = blocks[static_cast<std::size_t>(body)];
  return {block.offset_x, block.offset_y};
}

CornerOnFace upper_corner(const std::vector<Block>& blocks, int interface, int side) {
  return {interface - 1, interface, side * half_width_of(blocks, interface),
          -half_height_of(blocks, interface), 1};
}

CornerOnFace lower_corner(const std::vector<Block>& blocks, int interface, int side) {
  const int lower = interface - 1;
  return {interface, lower, side * half_width_of(blocks, lower), half_height_of(blocks, lower), -1};
}

CornerOnFace held_point(const std::vector<Block>& blocks, int interface, const Joint& joint) {
  if (joint.pivots() && joint.corner_below) return lower_corner(blocks, interface, joint.side());
  return upper_corner(blocks, interface, joint.side());
}

PointRows rows_of(const std::vector<Block>& blocks, const Bodies& bodies, const CornerOnFace& corner) {
  const BodyPlacement face = placement(bodies.at, corner.face);
  const BodyPlacement face_rate = placement(bodies.rate, corner.face);
  const BodyPlacement body = placement(bodies.at, corner.body);
  const BodyPlacement body_rate = placement(bodies.rate, corner.body);
  const Plane tangent = turned({1, 0}, face.angle);
  const Plane normal = turned({0, 1}, face.angle);
  const Plane arm = turned(Plane(corner.x, corner.y) - centre_of(blocks, corner.body), body.angle);
  const Plane turn = quarter_turned(arm);
  const Plane apart = Plane(body.x - face.x, body.y - face.y) + arm;
  const Plane speed = Plane(body_rate.x - face_rate.x, body_rate.y - face_rate.y) + turn * body_rate.angle;
  const Plane bend = -arm * (body_rate.angle * body_rate.angle);
  // From the centre of mass of the face's body.
  const double along = apart.dot(tangent);
  const double above = apart.dot(normal);
  const Plane centre = centre_of(blocks, corner.face);
  const double turning = face_rate.angle;
  const double along_rate = speed.dot(tangent) - turning * above;
  const double above_rate = speed.dot(normal) + turning * along;
  const double sign = corner.upward;
  PointRows rows;
  rows.gap = sign * (above + centre.y()) - half_height_of(blocks, corner.face);
  rows.slip = sign * (along + centre.x());
  rows.gap_bias = sign * (bend.dot(normal) + turning * speed.dot(tangent) + turning * along_rate);
  rows.slip_bias = sign * (bend.dot(tangent) - turning * speed.dot(normal) - turning * above_rate);
  rows.gap_row = rows.slip_row = Eigen::RowVectorXd::Zero(3 * static_cast<Eigen::Index>(blocks.size()));
  if (corner.body >= 0) {
    rows.gap_row.segment<3>(Eigen::Index{3} * corner.body) << sign * normal.x(), sign * normal.y(),
        sign * normal.dot(turn);
    rows.slip_row.segment<3>(Eigen::Index{3} * corner.body) << sign * tangent.x(), sign * tangent.y(),
        sign * tangent.dot(turn);
  }
  if (corner.face >= 0) {
    rows.gap_row.segment<3>(Eigen::Index{3} * corner.face) << -sign * normal.x(), -sign * normal.y(),
        sign * along;
    rows.slip_row.segment<3>(Eigen::Index{3} * corner.face) << -sign * tangent.x(), -sign * tangent.y(),
        -sign * above;
  }
  return rows;
}

double offset_of(const std::vector<Block>& blocks, const Bodies& bodies, int interface, const Joint& joint) {
  return rows_of(blocks, bodies, held_point(blocks, interface, joint)).slip -
         slip_from_offset(blocks, interface, joint);
}

void place(const std::vector<Block>& blocks, std::vector<Joint>& joints, Bodies& bodies) {
  for (int k = 0; k < static_cast<int>(blocks.size()); ++k) {
    const auto block = static_cast<std::size_t>(k);
    Joint& joint = joints[block];
    if (!joint.touches()) continue;
    const CornerOnFace point = held_point(blocks, k, joint);
    double slip_rate = 0;
    if (joint.slip != 0) {
      const PointRows rows = rows_of(blocks, bodies, point);
      slip_rate = rows.slip_row.dot(vector_of(bodies.rate));
      joint.offset = rows.slip - slip_from_offset(blocks, k, joint);
    }
    const BodyPlacement lower = placement(bodies.at, k - 1);
    const BodyPlacement lower_rate = placement(bodies.rate, k - 1);
    BodyPlacement& upper = bodies.at[block];
    BodyPlacement& upper_rate = bodies.rate[block];
    if (joint.touch == Touch::flat) {
      upper.angle = lower.angle;
      upper_rate.angle = lower_rate.angle;
    }
    const double lower_top = half_height_of(blocks, k - 1);
    const double upper_bottom = -half_height_of(blocks, k);
    const bool below = point.upward < 0;
    // The contact point from the middle of either block.
    const double on_upper = below ? point.x - joint.offset : point.x;
    const double on_lower = below ? point.x : point.x + joint.offset;
    const Plane lower_arm = turned(Plane(on_lower, lower_top) - centre_of(blocks, k - 1), lower.angle);
    const Plane upper_arm = turned(Plane(on_upper, upper_bottom) - centre_of(blocks, k), upper.angle);
    const Plane tangent = turned({1, 0}, below ? upper.angle : lower.angle);
    upper.x = lower.x + (lower_arm.x() - upper_arm.x());
    upper.y = lower.y + (lower_arm.y() - upper_arm.y());
    const Plane change = quarter_turned(lower_arm) * lower_rate.angle -
                         quarter_turned(upper_arm) * upper_rate.angle + tangent * slip_rate;
    upper_rate.x = lower_rate.x + change.x();
    upper_rate.y = lower_rate.y + change.y();
  }
}

}  // namespace rockstack
