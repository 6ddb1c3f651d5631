// A stack of blocks in DART by DART's headers alone: nothing of this project is read here, so that its
// adapter can be held to it. What is not set stays as the library has it. Standard input has words:
//
//   solver dantzig                     (or pgs)
//   gravity 9.81  friction 1000  dt 0.001  steps 500
//   block 1.25 1.25 1 3906 834 834 1017 0 0.6 0.15
//     of each block from the bottom up: width, height, depth (m), mass (kg), moments of inertia about x, y
//     and z (kg m²), centre x, y (m), angle (rad)
//   set ErrorReductionParameter 0.1    (whatever DART can be told)
//   shake 0.5 -0.1                     (the ground's acceleration right and up, m/s², one a step)
//
// Standard output has a line a step, the start first: the angles in rad, clockwise positive.

#include <cmath>
#include <cstdio>
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/collision/fcl/FCLCollisionDetector.hpp>
#include <dart/constraint/BoxedLcpConstraintSolver.hpp>
#include <dart/constraint/ContactConstraint.hpp>
#include <dart/constraint/PgsBoxedLcpSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/PlanarJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Block {
  double width, height, depth, mass, about_x, about_y, about_z, x, y, angle;
};

struct Question {
  std::map<std::string, double> number{
      {"gravity", 0}, {"friction", 0}, {"dt", 0}, {"steps", 0}, {"reach", 0}};
  std::string solver;
  std::vector<Block> blocks;
  std::map<std::string, double> set;
  std::vector<std::pair<double, double>> shaking;
};

bool read(std::istream& in, Question& question) {
  for (std::string word; in >> word;) {
    if (word == "solver") {
      in >> question.solver;
    } else if (word == "block") {
      Block& block = question.blocks.emplace_back();
      in >> block.width >> block.height >> block.depth >> block.mass >> block.about_x >> block.about_y;
      in >> block.about_z >> block.x >> block.y >> block.angle;
    } else if (word == "set") {
      in >> word;
      in >> question.set[word];
    } else if (word == "shake") {
      auto& [x, y] = question.shaking.emplace_back();
      in >> x >> y;
    } else if (question.number.count(word) != 0) {
      in >> question.number[word];
    } else {
      return false;
    }
  }
  return in.eof();
}

void add_box(dart::dynamics::BodyNode* body, const Eigen::Vector3d& size, double height, double friction) {
  const auto shape = std::make_shared<dart::dynamics::BoxShape>(size);
  auto* node =
      body->createShapeNodeWith<dart::dynamics::CollisionAspect, dart::dynamics::DynamicsAspect>(shape);
  node->setRelativeTranslation({0, height, 0});
  node->getDynamicsAspect()->setFrictionCoeff(friction);
}

/// Two boxes a block, its lower and its upper half.
dart::dynamics::SkeletonPtr skeleton_of(const std::string& name, const Block& block, double friction) {
  auto skeleton = dart::dynamics::Skeleton::create(name);
  dart::dynamics::PlanarJoint::Properties plane;
  plane.setXYPlane();
  const auto [joint, body] =
      skeleton->createJointAndBodyNodePair<dart::dynamics::PlanarJoint>(nullptr, plane);
  body->setInertia(
      dart::dynamics::Inertia(block.mass, 0, 0, 0, block.about_x, block.about_y, block.about_z, 0, 0, 0));
  for (const double half : {-0.25, 0.25})
    add_box(body, {block.width, 0.5 * block.height, block.depth}, half * block.height, friction);
  joint->setPositions(Eigen::Vector3d(block.x, block.y, -block.angle));
  return skeleton;
}

}  // namespace

int main() {
  Question question;
  if (!read(std::cin, question)) return 2;
  const auto set = [&](const char* name, double default_value) {
    return question.set.count(name) != 0 ? question.set.at(name) : default_value;
  };
  const double friction = question.number.at("friction"), gravity = question.number.at("gravity");
  const auto world = dart::simulation::World::create();
  world->setTimeStep(question.number.at("dt"));
  world->setGravity({0, -gravity, 0});
  const auto ground = dart::dynamics::Skeleton::create("ground");
  const auto floor = ground->createJointAndBodyNodePair<dart::dynamics::WeldJoint>().second;
  const double reach = question.number.at("reach");
  add_box(floor, {2 * reach, 2, 2 * reach}, -1, friction);
  world->addSkeleton(ground);
  std::vector<dart::dynamics::SkeletonPtr> blocks;
  for (const Block& block : question.blocks)
    world->addSkeleton(blocks.emplace_back(skeleton_of(std::to_string(blocks.size()), block, friction)));
  using dart::constraint::ContactConstraint;
  if (question.set.count("ErrorReductionParameter") != 0)
    ContactConstraint::setErrorReductionParameter(question.set.at("ErrorReductionParameter"));
  if (question.set.count("ErrorAllowance") != 0)
    ContactConstraint::setErrorAllowance(question.set.at("ErrorAllowance"));
  if (question.set.count("MaxErrorReductionVelocity") != 0)
    ContactConstraint::setMaxErrorReductionVelocity(question.set.at("MaxErrorReductionVelocity"));
  if (question.set.count("ConstraintForceMixing") != 0)
    ContactConstraint::setConstraintForceMixing(question.set.at("ConstraintForceMixing"));
  std::unique_ptr<dart::constraint::BoxedLcpConstraintSolver> solver;
  if (question.solver == "pgs") {
    auto pgs = std::make_shared<dart::constraint::PgsBoxedLcpSolver>();
    dart::constraint::PgsBoxedLcpSolver::Option option;
    option.mMaxIteration = static_cast<int>(set("MaxIteration", option.mMaxIteration));
    option.mDeltaXThreshold = set("DeltaXThreshold", option.mDeltaXThreshold);
    option.mRelativeDeltaXTolerance = set("RelativeDeltaXTolerance", option.mRelativeDeltaXTolerance);
    pgs->setOption(option);
    solver = std::make_unique<dart::constraint::BoxedLcpConstraintSolver>(pgs, nullptr);
  } else {
    solver = std::make_unique<dart::constraint::BoxedLcpConstraintSolver>();
  }
  if (set("collisionDetector", 0) == 0)
    solver->setCollisionDetector(dart::collision::FCLCollisionDetector::create());
  else
    solver->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
  world->setConstraintSolver(std::move(solver));
  const auto print = [&] {
    for (const auto& block : blocks) std::printf("%.17g ", -block->getPosition(2));
    std::printf("\n");
  };
  print();
  for (std::size_t step = 0; step < static_cast<std::size_t>(question.number.at("steps")); ++step) {
    if (step < question.shaking.size()) {
      const auto& [x, y] = question.shaking[step];
      world->setGravity({-x, -gravity - y, 0});
    }
    world->step();
    print();
  }
}
