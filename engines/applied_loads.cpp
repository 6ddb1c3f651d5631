#include "engines/applied_loads.hpp"

#include "analytic/scene/lists.hpp"
#include "analytic/scene/restraint_law.hpp"

namespace rockstack {
namespace {

Point<double> arm_of(const BodyPoint& point) {
  return {point.x, point.y};
}

/// Blocks count from 0 there; −1 is the ground.
int body_of(const BodyPoint& point) {
  return static_cast<int>(point.block) - 1;
}

RestraintLaw<double> law_of(const AppliedRestraint& given) {
  RestraintLaw<double> law;
  law.from = body_of(given.from);
  law.to = body_of(given.to);
  law.from_arm = arm_of(given.from);
  law.to_arm = arm_of(given.to);
  law.length = given.length;
  law.stiffness = given.stiffness;
  law.prestress = given.prestress;
  law.yield = given.yield;
  law.damping = given.damping;
  return law;
}

/// Bodies as they start a step, moved on by their velocities for a while.
struct MovedBodies {
  const std::vector<BodyState>& blocks;
  const GroundStep& ground;
  double time;  ///< s

  PointMotion<double> point(int body, const Point<double>& own) const {
    if (body < 0) {
      const Point<double> velocity{ground.velocity_x, ground.velocity_y};
      return {Point<double>(ground.x, ground.y) + own + time * velocity, velocity, own};
    }
    const BodyState& block = blocks[static_cast<std::size_t>(body)];
    const double angle = block.angle + time * block.angular_velocity;
    const Point<double> velocity{block.velocity_x, block.velocity_y};
    const Point<double> arm = turned(own.x(), own.y(), std::cos(angle), std::sin(angle));
    return {Point<double>(block.x, block.y) + time * velocity + arm,
            velocity + block.angular_velocity * quarter_turned<double>(arm), arm};
  }
};

}  // namespace

struct AppliedLoads::Parts {
  std::vector<AppliedPush> pushes;
  std::vector<RestraintLaw<double>> restraints;
  double lookahead;
};

AppliedLoads::AppliedLoads(const Setup& setup)
    : parts_(new Parts{setup.pushes, mapped(setup.restraints, law_of), setup.lookahead}) {}

AppliedLoads::~AppliedLoads() = default;

bool AppliedLoads::any() const {
  return !parts_->pushes.empty() || !parts_->restraints.empty();
}

std::vector<BodyLoad> AppliedLoads::over_step(std::size_t step, const std::vector<BodyState>& blocks,
                                              const GroundStep& ground) {
  std::vector<BodyLoad> loads(blocks.size());
  const auto add = [&](int body, const Point<double>& force, double moment) {
    BodyLoad& load = loads[static_cast<std::size_t>(body)];
    load.x += force.x();
    load.y += force.y();
    load.moment += moment;
  };
  const MovedBodies bodies{blocks, ground, parts_->lookahead};
  for (const AppliedPush& push : parts_->pushes) {
    const double size = step < push.forces.size() ? push.forces[step] : 0;
    const Point<double> force{size * push.direction_x, size * push.direction_y};
    const Point<double> arm = bodies.point(body_of(push.point), arm_of(push.point)).arm;
    add(body_of(push.point), force, quarter_turned(arm).dot(force));
  }
  const auto motion_of = [&](int body, const Point<double>& arm) { return bodies.point(body, arm); };
  for (RestraintLaw<double>& law : parts_->restraints)
    law.follow((motion_of(law.to, law.to_arm).place - motion_of(law.from, law.from_arm).place).norm());
  each_restraint(parts_->restraints, motion_of, add);
  return loads;
}

}  // namespace rockstack
