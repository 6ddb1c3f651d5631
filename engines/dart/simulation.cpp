#include "engines/dart/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <dart/collision/CollisionObject.hpp>
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/collision/fcl/FCLCollisionDetector.hpp>
#include <dart/constraint/BoxedLcpConstraintSolver.hpp>
#include <dart/constraint/ContactConstraint.hpp>
#include <dart/constraint/PgsBoxedLcpSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/PlanarJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/TranslationalJoint.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>
#include <utility>
#include <vector>

#include "engines/shaking.hpp"

namespace rockstack {
namespace {

using dart::constraint::ContactConstraint;
using dart::dynamics::BodyNode;
using Solver = dart::constraint::BoxedLcpConstraintSolver;

/// A contact of the step under way, where they are watched, in the axes of both bodies.
struct Touch {
  std::size_t interface = 0;
  const BodyNode *upper = nullptr, *lower = nullptr;
  Eigen::Vector3d on_upper, on_lower, normal;  ///< the normal points up
  double depth = 0, push = 0, across = 0;      ///< m, N, N
};

/// Half the edge of the ground: beyond where blocks may come.
double reach_of(const std::vector<Placement>& blocks) {
  double reach = blocks.front().depth;
  for (const Placement& block : blocks) reach += block.width + block.height;
  return 10 * reach;
}

std::unique_ptr<Solver> make_solver(DartSolver solver, const Parameters& parameters) {
  std::unique_ptr<Solver> made;
  if (solver == DartSolver::dantzig) {
    made = std::make_unique<Solver>();
  } else {
    auto pgs = std::make_shared<dart::constraint::PgsBoxedLcpSolver>();
    dart::constraint::PgsBoxedLcpSolver::Option option;
    option.mMaxIteration = static_cast<int>(parameters.at("MaxIteration"));
    option.mDeltaXThreshold = parameters.at("DeltaXThreshold");
    option.mRelativeDeltaXTolerance = parameters.at("RelativeDeltaXTolerance");
    pgs->setOption(option);
    made = std::make_unique<Solver>(pgs, nullptr);
  }
  if (parameters.at("collisionDetector") == 0) {
    made->setCollisionDetector(dart::collision::FCLCollisionDetector::create());
  } else {
    made->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
  }
  return made;
}

class DartSimulation : public Simulation {
 public:
  DartSimulation(DartSolver solver, const Setup& setup, const Parameters& parameters)
      : parameters_(parameters),
        mass_factor_(mass_factor(setup, parameters)),
        shaking_(setup),
        world_(dart::simulation::World::create()) {
    world_->setTimeStep(setup.dt);
    set_gravity(setup.gravity);
    add_ground(setup);
    for (std::size_t k = 0; k < setup.blocks.size(); ++k) {
      const bool top = k + 1 == setup.blocks.size();
      add_block(setup.blocks[k], setup.friction[k], setup.friction[top ? k : k + 1]);
    }
    world_->setConstraintSolver(make_solver(solver, parameters));
  }

  void step() override {
    const auto [ground, acceleration] = shaking_.next();
    if (ground) place_ground(*ground);
    if (acceleration) set_gravity(*acceleration);
    ContactConstraint::setErrorAllowance(parameters_.at("ErrorAllowance"));
    ContactConstraint::setErrorReductionParameter(parameters_.at("ErrorReductionParameter"));
    ContactConstraint::setMaxErrorReductionVelocity(parameters_.at("MaxErrorReductionVelocity"));
    ContactConstraint::setConstraintForceMixing(parameters_.at("ConstraintForceMixing"));
    std::vector<Eigen::Isometry3d> before;
    if (watched_) before = poses();
    world_->step();
    if (watched_) watch(before);
  }

  void read(std::span<double> angles, std::span<double> velocities) const override {
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      angles[k] = -blocks_[k]->getSkeleton()->getPosition(2);
      velocities[k] = -blocks_[k]->getSkeleton()->getVelocity(2);
    }
  }

  BodyState body(std::size_t k) const override {
    const auto block = blocks_[k]->getSkeleton();
    BodyState state;
    state.x = block->getPosition(0);
    state.y = block->getPosition(1);
    state.velocity_x = block->getVelocity(0);
    state.velocity_y = block->getVelocity(1);
    return state;
  }

  bool watch_contacts() override { return watched_ = true; }

  std::vector<ContactPoint> contacts() const override {
    std::vector<ContactPoint> points;
    for (const Touch& touch : touches_) points.push_back(point_of(touch));
    return points;
  }

 private:
  void set_gravity(const BodyAcceleration& acceleration) {
    world_->setGravity({acceleration.x, acceleration.y, 0});
  }

  void add_box(BodyNode* body, const Eigen::Vector3d& size, double height, double friction) const {
    auto* box = body->createShapeNodeWith<dart::dynamics::CollisionAspect, dart::dynamics::DynamicsAspect>(
        std::make_shared<dart::dynamics::BoxShape>(size));
    box->setRelativeTranslation({0, height, 0});
    box->getDynamicsAspect()->setFrictionCoeff(friction);
    box->getDynamicsAspect()->setRestitutionCoeff(parameters_.at("RestitutionCoeff"));
  }

  void add_ground(const Setup& setup) {
    const auto skeleton = dart::dynamics::Skeleton::create("ground");
    if (shaking_.moves_ground()) {
      const auto [joint, body] = skeleton->createJointAndBodyNodePair<dart::dynamics::TranslationalJoint>();
      joint->setActuatorType(dart::dynamics::Joint::VELOCITY);
      ground_ = body;
    } else {
      ground_ = skeleton->createJointAndBodyNodePair<dart::dynamics::WeldJoint>().second;
    }
    const double reach = reach_of(setup.blocks);
    add_box(ground_, {2 * reach, 2, 2 * reach}, -1, setup.friction.front());
    world_->addSkeleton(skeleton);
  }

  void add_block(const Placement& block, double friction_below, double friction_above) {
    // DART writes to standard output where names are the same.
    const auto skeleton = dart::dynamics::Skeleton::create(std::to_string(blocks_.size()));
    dart::dynamics::PlanarJoint::Properties plane;
    plane.setXYPlane();
    BodyNode* body = skeleton->createJointAndBodyNodePair<dart::dynamics::PlanarJoint>(nullptr, plane).second;
    body->setInertia(
        dart::dynamics::Inertia(mass_factor_ * block.mass, 0, 0, 0, mass_factor_ * block.inertia_about_x,
                                mass_factor_ * block.inertia_about_y, mass_factor_ * block.inertia, 0, 0, 0));
    const Eigen::Vector3d half{block.width, 0.5 * block.height, block.depth};
    add_box(body, half, -0.25 * block.height, friction_below);
    add_box(body, half, 0.25 * block.height, friction_above);
    skeleton->setPositions(Eigen::Vector3d(block.x, block.y, -block.angle));
    skeleton->setVelocities(Eigen::Vector3d(block.velocity_x, block.velocity_y, -block.angular_velocity));
    world_->addSkeleton(skeleton);
    blocks_.push_back(body);
  }

  /// Contacts are found where ground and blocks are at the step's start; the velocity carries both on.
  void place_ground(const GroundStep& step) {
    const auto skeleton = ground_->getSkeleton();
    const Eigen::Vector3d velocity{step.velocity_x, step.velocity_y, 0};
    skeleton->setPositions(Eigen::Vector3d(step.x, step.y, 0));
    skeleton->setVelocities(velocity);
    skeleton->setCommands(velocity);
  }

  /// From 1, bottom to top; 0 is the ground.
  std::size_t number_of(const BodyNode* body) const {
    const auto found = std::find(blocks_.begin(), blocks_.end(), body);
    return found == blocks_.end() ? 0 : static_cast<std::size_t>(found - blocks_.begin()) + 1;
  }

  const BodyNode* body_of(std::size_t number) const { return number == 0 ? ground_ : blocks_[number - 1]; }

  std::vector<Eigen::Isometry3d> poses() const {
    std::vector<Eigen::Isometry3d> list{ground_->getWorldTransform()};
    for (const BodyNode* block : blocks_) list.push_back(block->getWorldTransform());
    return list;
  }

  static const BodyNode* owner(const dart::collision::CollisionObject* object) {
    return object->getShapeFrame()->asShapeNode()->getBodyNodePtr();
  }

  void watch(const std::vector<Eigen::Isometry3d>& before) {
    touches_.clear();
    for (const dart::collision::Contact& contact : world_->getLastCollisionResult().getContacts()) {
      if (dart::collision::Contact::isZeroNormal(contact.normal)) continue;
      const auto [lower, upper] = std::minmax(
          {number_of(owner(contact.collisionObject1)), number_of(owner(contact.collisionObject2))});
      Touch& touch = touches_.emplace_back();
      touch.interface = upper - 1;
      touch.upper = body_of(upper);
      touch.lower = body_of(lower);
      touch.on_upper = before[upper].inverse() * contact.point;
      touch.on_lower = before[lower].inverse() * contact.point;
      const double side = contact.normal.dot(before[upper].translation() - contact.point);
      touch.normal = side < 0 ? Eigen::Vector3d(-contact.normal) : contact.normal;
      touch.depth = contact.penetrationDepth;
      touch.push = std::abs(contact.force.dot(contact.normal));
      // Across the plane nothing moves, and DART's forces there mean nothing.
      touch.across = std::abs(contact.force[0] * contact.normal[1] - contact.force[1] * contact.normal[0]);
    }
  }

  ContactPoint point_of(const Touch& touch) const {
    ContactPoint point;
    point.interface = touch.interface;
    point.along = touch.on_upper[0];
    point.gap_before = -touch.depth;
    const Eigen::Vector3d apart =
        touch.upper->getWorldTransform() * touch.on_upper - touch.lower->getWorldTransform() * touch.on_lower;
    point.gap = point.gap_before + touch.normal.dot(apart);
    const double impulse = world_->getTimeStep() / mass_factor_;
    point.normal = impulse * touch.push;
    point.tangential = impulse * touch.across;
    return point;
  }

  Parameters parameters_;
  double mass_factor_;  ///< of every mass; no angle depends on it
  Shaking shaking_;
  bool watched_ = false;
  dart::simulation::WorldPtr world_;
  BodyNode* ground_ = nullptr;
  std::vector<BodyNode*> blocks_;
  std::vector<Touch> touches_;
};

}  // namespace

std::string dart_version() {
  return DART_VERSION;
}

std::unique_ptr<Simulation> start_dart(DartSolver solver, const Setup& setup, const Parameters& parameters) {
  return std::make_unique<DartSimulation>(solver, setup, parameters);
}

}  // namespace rockstack
