#include "analytic/unilateral/contact_chatter.hpp"

#include <cmath>
#include <limits>

namespace rockstack {

ContactChatter::ContactChatter(const FrictionStack& stack, double gravity, double resolution)
    : stack_(stack), resolution_(resolution > 0 ? resolution : std::numeric_limits<double>::epsilon()) {
  double height = 0;
  for (const Block& block : stack.blocks) height += 2 * block.half_height;
  rate_ = gravity / height;
  settling_speed_ = 500 * std::min(resolution_, std::numeric_limits<double>::epsilon()) * std::sqrt(rate_);
}

bool ContactChatter::negligibly_open(const Joint& joint, double angle, double angle_rate) const {
  return joint.pivots() && std::abs(angle_rate) <= settling_speed_ &&
         std::abs(angle) * rate_ <= settling_speed_ * settling_speed_;
}

bool ContactChatter::parts_slowly(int interface, const Joint& touching, const Joint& mode,
                                  const Bodies& after, const FreeVector& acceleration) const {
  const auto slow = [&](double speed, double back, double unit) {
    return speed <= settling_speed_ * unit || speed * speed <= -2 * resolution_ * unit * back;
  };
  const auto lower = [&](const FreeVector& vector, int at) {
    return interface == 0 ? 0 : vector[Eigen::Index{3} * interface - 3 + at];
  };
  const FreeVector rates = vector_of(after.rate);
  if (mode.pivots() && touching.touch == Touch::flat) {
    const double speed = std::abs(rates[Eigen::Index{3} * interface + 2] - lower(rates, 2));
    return slow(speed, mode.side() * (acceleration[Eigen::Index{3} * interface + 2] - lower(acceleration, 2)),
                1);
  }
  if (mode.touches() || !touching.touches()) return false;
  const double width = 2 * half_width_of(stack_.blocks, interface);
  for (const int side : {-1, 1}) {
    if (touching.pivots() && side != touching.side()) continue;
    Joint end = touching;
    end.touch = static_cast<Touch>(side);
    if (touching.touch == Touch::flat)
      end.corner_below = corner_is_below(stack_, interface, touching.offset, side);
    const PointRows rows = rows_of(stack_.blocks, after, held_point(stack_.blocks, interface, end));
    if (!slow(rows.gap_row.dot(rates), rows.gap_row.dot(acceleration) + rows.gap_bias, width)) return false;
  }
  return true;
}

std::vector<Joint> ContactChatter::without_slow(const std::vector<Joint>& touching,
                                                const std::vector<Joint>& mode, const Bodies& after,
                                                const FreeVector& free) const {
  const FreeVector acceleration = respond(stack_, mode, after, free, Sought::accelerations).motion;
  const FreeVector rates = vector_of(after.rate);
  std::vector<Joint> result = mode;
  for (int k = 0; k < stack_.size(); ++k) {
    const auto index = static_cast<std::size_t>(k);
    if (!parts_slowly(k, touching[index], mode[index], after, acceleration)) continue;
    Joint& joint = result[index];
    const int slip = joint.slip;
    joint = touching[index];
    joint.slip = slip;
    if (mode[index].touches()) continue;
    const double speed =
        rows_of(stack_.blocks, after, held_point(stack_.blocks, k, joint)).slip_row.dot(rates);
    const double still = settling_speed_ * half_width_of(stack_.blocks, k);
    joint.slip = (speed > still) - (speed < -still);
  }
  return result;
}

}  // namespace rockstack
