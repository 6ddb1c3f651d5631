// DART beside the exact model; README.md says what its contacts are and why its sets are as they are.

#include <algorithm>
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

#include "engines/engine.hpp"

namespace rockstack {
namespace {

enum class DartSolver { dantzig, pgs };

using dart::constraint::ContactConstraint;
using dart::dynamics::BodyNode;
using Solver = dart::constraint::BoxedLcpConstraintSolver;

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

class DartSimulation final : public ShakenSimulation {
 public:
  DartSimulation(DartSolver solver, const Setup& setup, const Parameters& parameters)
      : ShakenSimulation(setup, mass_factor(setup, parameters)),
        parameters_(parameters),
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

  BodyState body(std::size_t k) const override {
    const auto block = blocks_[k]->getSkeleton();
    return {block->getPosition(0), block->getPosition(1),  block->getVelocity(0),
            block->getVelocity(1), -block->getPosition(2), -block->getVelocity(2)};
  }

  std::vector<ContactPoint> contacts() const override { return contacts_; }

 private:
  void advance() override {
    ContactConstraint::setErrorAllowance(parameters_.at("ErrorAllowance"));
    ContactConstraint::setErrorReductionParameter(parameters_.at("ErrorReductionParameter"));
    ContactConstraint::setMaxErrorReductionVelocity(parameters_.at("MaxErrorReductionVelocity"));
    ContactConstraint::setConstraintForceMixing(parameters_.at("ConstraintForceMixing"));
    std::vector<Eigen::Isometry3d> before;
    if (watches_contacts()) before = poses();
    world_->step();
    if (watches_contacts()) watch(before);
  }

  void set_gravity(const BodyAcceleration& acceleration) override {
    world_->setGravity({acceleration.x, acceleration.y, 0});
  }

  void add_box(BodyNode* body, const Eigen::Vector3d& size, const Eigen::Vector3d& middle,
               double friction) const {
    auto* box = body->createShapeNodeWith<dart::dynamics::CollisionAspect, dart::dynamics::DynamicsAspect>(
        std::make_shared<dart::dynamics::BoxShape>(size));
    box->setRelativeTranslation(middle);
    box->getDynamicsAspect()->setFrictionCoeff(friction);
    // A pair has the product of both.
    box->getDynamicsAspect()->setRestitutionCoeff(std::sqrt(parameters_.at("RestitutionCoeff")));
  }

  void add_ground(const Setup& setup) {
    const auto skeleton = dart::dynamics::Skeleton::create("ground");
    if (moves_ground()) {
      const auto [joint, body] = skeleton->createJointAndBodyNodePair<dart::dynamics::TranslationalJoint>();
      joint->setActuatorType(dart::dynamics::Joint::VELOCITY);
      ground_ = body;
    } else {
      ground_ = skeleton->createJointAndBodyNodePair<dart::dynamics::WeldJoint>().second;
    }
    const double reach = ground_reach(setup.blocks);
    add_box(ground_, {2 * reach, 2, 2 * reach}, {0, -1, 0}, setup.friction.front());
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
    add_box(body, half, {-block.offset_x, -0.25 * block.height - block.offset_y, 0}, friction_below);
    add_box(body, half, {-block.offset_x, 0.25 * block.height - block.offset_y, 0}, friction_above);
    skeleton->setPositions(Eigen::Vector3d(block.x, block.y, -block.angle));
    skeleton->setVelocities(Eigen::Vector3d(block.velocity_x, block.velocity_y, -block.angular_velocity));
    world_->addSkeleton(skeleton);
    blocks_.push_back(body);
  }

  /// Until the step is over: the library clears forces then.
  void apply_load(std::size_t k, const BodyLoad& load) override {
    blocks_[k]->addExtForce({load.x, load.y, 0}, Eigen::Vector3d::Zero(), false, true);
    blocks_[k]->addExtTorque({0, 0, -load.moment}, false);
  }

  void place_ground(const GroundStep& step) override {
    const auto skeleton = ground_->getSkeleton();
    const Eigen::Vector3d velocity{step.velocity_x, step.velocity_y, 0};
    skeleton->setPositions(Eigen::Vector3d(step.x, step.y, 0));
    skeleton->setVelocities(velocity);
    skeleton->setCommands(velocity);
  }

  /// From 1, bottom to top; 0 is the ground.
  std::size_t number_of(const BodyNode* body) const {
    const auto found = std::ranges::find(blocks_, body);
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
    contacts_.clear();
    for (const dart::collision::Contact& contact : world_->getLastCollisionResult().getContacts()) {
      if (dart::collision::Contact::isZeroNormal(contact.normal)) continue;
      const auto [lower, upper] = std::minmax(
          {number_of(owner(contact.collisionObject1)), number_of(owner(contact.collisionObject2))});
      const Eigen::Vector3d on_upper = before[upper].inverse() * contact.point;
      const Eigen::Vector3d on_lower = before[lower].inverse() * contact.point;
      const double side = contact.normal.dot(before[upper].translation() - contact.point);
      const Eigen::Vector3d up = side < 0 ? Eigen::Vector3d(-contact.normal) : contact.normal;
      const Eigen::Vector3d apart =
          body_of(upper)->getWorldTransform() * on_upper - body_of(lower)->getWorldTransform() * on_lower;
      const double impulse = dt() / mass_factor_;
      const double on_body = number_of(owner(contact.collisionObject1)) == upper ? impulse : -impulse;
      // Across the plane nothing moves, and DART's forces there mean nothing.
      const double across = contact.force[0] * contact.normal[1] - contact.force[1] * contact.normal[0];
      contacts_.push_back({upper - 1, on_upper[0], -contact.penetrationDepth,
                           -contact.penetrationDepth + up.dot(apart),
                           impulse * std::abs(contact.force.dot(contact.normal)), impulse * std::abs(across),
                           on_body * contact.force[0], on_body * contact.force[1]});
    }
  }

  Parameters parameters_;
  dart::simulation::WorldPtr world_;
  BodyNode* ground_ = nullptr;
  std::vector<BodyNode*> blocks_;
  std::vector<ContactPoint> contacts_;  ///< of the last step, where they are watched
};

std::vector<Setting> settings_of(DartSolver solver) {
  std::vector<Setting> settings{
      {.name = "collisionDetector", .choices = {"fcl", "dart"}, .tuned = 1},
      {.name = "ErrorAllowance", .unit = "m"},
      {.name = "ErrorReductionParameter", .default_value = 0.01, .most = 1},
      {.name = "MaxErrorReductionVelocity", .unit = "m/s", .default_value = 1e-3},
      {.name = "ConstraintForceMixing", .default_value = 1e-5, .least = 1e-9, .most = 1},
      {.name = "RestitutionCoeff", .most = 1, .role = SettingRole::restitution},
      {.name = "unitMass", .unit = "kg", .most = 1e12},
      shaking_setting(),
  };
  if (solver == DartSolver::pgs) {
    settings.push_back(count_setting("MaxIteration", 30, 300));
    settings.push_back({.name = "DeltaXThreshold", .unit = "N s", .default_value = 1e-6});
    settings.push_back({.name = "RelativeDeltaXTolerance", .default_value = 1e-3, .tuned = 1e-6, .most = 1});
  }
  return settings;
}

Engine with(DartSolver solver) {
  return {{.name = "dart",
           .solver = solver == DartSolver::dantzig ? "dantzig" : "pgs",
           .version = DART_VERSION ", double precision",
           .licence = "BSD-2-Clause",
           .capabilities = {.applied_forces = true, .planar = true, .center_of_mass = true},
           .settings = settings_of(solver)},
          [solver](const Setup& setup, const Parameters& parameters) {
            return std::make_unique<DartSimulation>(solver, setup, parameters);
          }};
}

}  // namespace

std::vector<Engine> make_dart() {
  return {with(DartSolver::dantzig), with(DartSolver::pgs)};
}

}  // namespace rockstack
