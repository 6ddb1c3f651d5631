#include "tests/analytic/unilateral/momentum_laws.hpp"

#include <cmath>
#include <limits>

namespace rockstack::testing {
namespace {

/// A face of a block, or of the ground, −1.
struct Face {
  double height;  ///< over its body's centre, m
  double half_width;
  double angle;
  Point<double> middle;

  Face(const Scene& scene, const Poses<>& at, int owner, double over_centre)
      : height(over_centre),
        half_width(owner < 0 ? std::numeric_limits<double>::infinity() : scene.blocks[owner].half_width),
        angle(pose_of(at, owner).angle),
        middle(pose_of(at, owner).x + over_centre * std::sin(angle),
               pose_of(at, owner).y + over_centre * std::cos(angle)) {}

  Point<double> along() const { return {std::cos(angle), -std::sin(angle)}; }
  Point<double> across() const { return {std::sin(angle), std::cos(angle)}; }
};

Face top_of_lower(const Scene& scene, const Poses<>& at, int k) {
  return {scene, at, k - 1, k == 0 ? 0 : scene.blocks[k - 1].half_height};
}

Face bottom_of_upper(const Scene& scene, const Poses<>& at, int k) {
  return {scene, at, k, -scene.blocks[k].half_height};
}

/// The velocity of the block above an interface against what is below, at a point.
Point<double> relative_velocity(const Bodies<>& bodies, int k, const Point<double>& point) {
  const auto of = [&](int body) -> Point<double> {
    const Pose<> at = pose_of(bodies.pose, body), rate = pose_of(bodies.velocity, body);
    return {rate.x + rate.angle * (point.y() - at.y), rate.y - rate.angle * (point.x() - at.x)};
  };
  return of(k) - of(k - 1);
}

/// Coulomb's and Signorini's laws of one interface on one face.
bool obeys_on_face(const Change& change, int k, double friction, const Point<double>& impulse, double torque,
                   const Face& face) {
  const double rounding = 1e-6 * change.scale;
  const double normal = impulse.dot(face.across()), tangential = impulse.dot(face.along());
  if (normal < -rounding || std::abs(tangential) > friction * normal + rounding) return false;
  if (normal < 100 * rounding) return true;
  // The torque about the origin tells the line that the impulse acts along.
  const Point<double>& middle = face.middle;
  const double place = -(torque - (middle.y() * impulse.x() - middle.x() * impulse.y())) / normal;
  if (std::abs(place) > face.half_width + 1e-4) return false;
  const Point<double> velocity =
      relative_velocity({change.at, change.rate}, k, middle + place * face.along());
  const double slip = velocity.dot(face.along());
  if (std::abs(slip) < 1e-4) return true;
  return std::abs(tangential + std::copysign(friction * normal, slip)) <= 10 * rounding;
}

/// Whether no corner of one block goes into the face of its neighbour by more than roundings before the next
/// event. `outward`: 1 for a top face.
bool stays_out(const Scene& scene, const Bodies<>& bodies, int k, int owner, double corner_height,
               const Face& face, int outward, const Approach& harmless) {
  const bool flat = std::abs(relative_angle(bodies.pose, k)) < 1e-9;
  const Face own(scene, bodies.pose, owner, corner_height);
  for (const int side : {-1, 1}) {
    const Point<double> corner = own.middle + side * own.half_width * own.along();
    const double beyond = std::abs((corner - face.middle).dot(face.along())) - face.half_width;
    const double gap = outward * (corner - face.middle).dot(face.across());
    // What is apart by more than roundings of its coordinates has not met yet.
    const double roundings =
        8 * std::numeric_limits<double>::epsilon() * (std::abs(corner.y()) + 2 * std::abs(corner_height));
    if (beyond > (flat ? 1e-9 : -1e-6) || std::abs(gap) > roundings) continue;
    const double approach = -relative_velocity(bodies, k, corner).dot(face.across());
    if (approach > harmless.speed && approach * harmless.time > 2 * roundings) return false;
  }
  return true;
}

}  // namespace

bool obeys_laws(const Scene& scene, const Change& change) {
  Point<double> impulse(0, 0);
  double torque = 0;
  for (int k = static_cast<int>(scene.blocks.size()) - 1; k >= 0; --k) {
    const Block& block = scene.blocks[k];
    const Pose<>&at = change.at[k], &turn = change.of_rates[k];
    const Point<double> momentum = block.mass * (Point<double>(turn.x, turn.y) - change.free);
    impulse += momentum;
    torque += block.inertia * turn.angle + at.y * momentum.x() - at.x * momentum.y();
    const auto obeys_on = [&](const Face& face) {
      return obeys_on_face(change, k, scene.friction[k], impulse, torque, face);
    };
    if (!obeys_on(top_of_lower(scene, change.at, k)) &&
        (k == 0 || !obeys_on(bottom_of_upper(scene, change.at, k))))
      return false;
  }
  return true;
}

bool nothing_approaches(const Scene& scene, const Bodies<>& bodies, const Approach& harmless) {
  for (int k = 0; k < static_cast<int>(scene.blocks.size()); ++k) {
    const Face lower = top_of_lower(scene, bodies.pose, k), upper = bottom_of_upper(scene, bodies.pose, k);
    if (!stays_out(scene, bodies, k, k, upper.height, lower, 1, harmless)) return false;
    if (k > 0 && !stays_out(scene, bodies, k, k - 1, lower.height, upper, -1, harmless)) return false;
  }
  return true;
}

Poses<> difference(const Poses<>& one, const Poses<>& other) {
  return poses_of<double>(vector_of(one) - vector_of(other));
}

ImpactTally impacts_by_momenta(const Scene& scene, const History& history) {
  double mass = 0, height = 0;
  for (const Block& block : scene.blocks) mass += block.mass, height += 2 * block.half_height;
  const double fall = std::sqrt(scene.gravity * height);
  ImpactTally tally;
  for (std::size_t k = 0; k < history.events.size(); ++k) {
    const Event& event = history.events[k];
    const double next = k + 1 < history.events.size() ? history.events[k + 1].time : scene.duration;
    const Bodies<> after = bodies_after(event);
    const Poses<> change = difference(after.velocity, bodies_before(event).velocity);
    double scale = 0;
    for (std::size_t body = 0; body < change.size(); ++body)
      scale += scene.blocks[body].mass * std::hypot(change[body].x, change[body].y);
    if (scale < 1e-3 * mass * fall) continue;
    ++tally.impacts;
    if (!obeys_laws(scene, {after.pose, after.velocity, change, {0, 0}, scale}) ||
        !nothing_approaches(scene, after, {1e-9 * fall, next - event.time}))
      ++tally.broken;
  }
  return tally;
}

}  // namespace rockstack::testing
