// A stack of blocks in Bullet by Bullet's headers alone, in the precision of the library that it is built
// with: nothing of this project is read here, so that its adapter can be held to it. What is not set stays as
// the library has it. Standard input has words:
//
//   solver sequential-impulse          (or nncg, mlcp-dantzig, mlcp-lemke, mlcp-pgs, nncg-of-impulses,
//                                       sequential-impulse-lets-go)
//   gravity 9.81  friction 10  reach 70  dt 0.001  steps 500
//   block 1.25 1.25 1 3906 834 834 1017 0 0.6 0.15
//     of each block from the bottom up: width, height, depth (m), mass (kg), moments of inertia about x, y
//     and z (kg m²), centre x, y (m), angle (rad)
//   set erp2 0.2                       (whatever Bullet can be told)
//   shake 0.5 -0.1                     (the ground's acceleration right and up, m/s², one a step)
//
// `reach` is half the edge of the box that is the ground. Standard output has a line a step, the start first:
// the angles in rad, clockwise positive; with `set along 1` the places along the ground, m.

#include <btBulletDynamicsCommon.h>

#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btLemkeSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <BulletDynamics/MLCPSolvers/btSolveProjectedGaussSeidel.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <string>
#include <vector>

extern btScalar gContactBreakingThreshold;

namespace {

struct Block {
  double width, height, depth, mass, about_x, about_y, about_z, x, y, angle;
};

struct Question {
  std::map<std::string, double> number{
      {"gravity", 0}, {"friction", 0}, {"reach", 0}, {"dt", 0}, {"steps", 0}};
  std::string solver;
  std::vector<Block> blocks;
  std::map<std::string, double> set;
  std::vector<btVector3> shaking;
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
      double x = 0, y = 0;
      in >> x >> y;
      question.shaking.emplace_back(btScalar(x), btScalar(y), btScalar(0));
    } else if (question.number.count(word) != 0) {
      in >> question.number[word];
    } else {
      return false;
    }
  }
  return in.eof();
}

/// NNCG with one change: its rows return the impulse that they applied. The library's return that impulse
/// over the effective mass, a velocity, which NNCG adds to impulses all the same.
class NncgOfImpulses : public btNNCGConstraintSolver {
  using Body = btSolverBody;
  static btScalar generic(Body& a, Body& b, const btSolverConstraint& row) {
    return library().getScalarConstraintRowSolverGeneric()(a, b, row) * row.m_jacDiagABInv;
  }
  static btScalar lower_limit(Body& a, Body& b, const btSolverConstraint& row) {
    return library().getScalarConstraintRowSolverLowerLimit()(a, b, row) * row.m_jacDiagABInv;
  }
  static btSequentialImpulseConstraintSolver& library() {
    static btSequentialImpulseConstraintSolver solver;
    return solver;
  }
  btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int body_count,
                                btPersistentManifold** manifolds, int manifold_count,
                                btTypedConstraint** constraints, int constraint_count,
                                const btContactSolverInfo& info, btIDebugDraw* drawer) override {
    m_resolveSingleConstraintRowGeneric = generic;
    m_resolveSingleConstraintRowLowerLimit = lower_limit;
    return btNNCGConstraintSolver::solveSingleIteration(iteration, bodies, body_count, manifolds,
                                                        manifold_count, constraints, constraint_count, info,
                                                        drawer);
  }
};

/// Sequential impulse with one change: after each sweep a contact point that nothing presses lets go of its
/// friction. The library passes over it, so that it keeps what an earlier sweep or a warm start gave it.
class LetsGo : public btSequentialImpulseConstraintSolver {
  btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int body_count,
                                btPersistentManifold** manifolds, int manifold_count,
                                btTypedConstraint** constraints, int constraint_count,
                                const btContactSolverInfo& info, btIDebugDraw* drawer) override {
    const btScalar rest = btSequentialImpulseConstraintSolver::solveSingleIteration(
        iteration, bodies, body_count, manifolds, manifold_count, constraints, constraint_count, info,
        drawer);
    for (int i = 0; i < m_tmpSolverContactFrictionConstraintPool.size(); ++i) {
      btSolverConstraint& row = m_tmpSolverContactFrictionConstraintPool[i];
      if (m_tmpSolverContactConstraintPool[row.m_frictionIndex].m_appliedImpulse > 0) continue;
      row.m_lowerLimit = row.m_upperLimit = 0;
      resolveSingleConstraintRowGeneric(m_tmpSolverBodyPool[row.m_solverBodyIdA],
                                        m_tmpSolverBodyPool[row.m_solverBodyIdB], row);
    }
    return rest;
  }
};

btSequentialImpulseConstraintSolver* make_solver(const Question& question) {
  if (question.solver == "nncg") return new btNNCGConstraintSolver;
  if (question.solver == "nncg-of-impulses") return new NncgOfImpulses;
  if (question.solver == "sequential-impulse-lets-go") return new LetsGo;
  if (question.solver == "mlcp-dantzig") return new btMLCPSolver(new btDantzigSolver);
  if (question.solver == "mlcp-lemke") return new btMLCPSolver(new btLemkeSolver);
  if (question.solver == "mlcp-pgs") return new btMLCPSolver(new btSolveProjectedGaussSeidel);
  return new btSequentialImpulseConstraintSolver;
}

void set_all(const std::map<std::string, double>& set, btContactSolverInfo& info) {
  const std::map<std::string, btScalar*> numbers{
      {"erp2", &info.m_erp2},
      {"frictionERP", &info.m_frictionERP},
      {"globalCfm", &info.m_globalCfm},
      {"sor", &info.m_sor},
      {"splitImpulsePenetrationThreshold", &info.m_splitImpulsePenetrationThreshold},
      {"splitImpulseTurnErp", &info.m_splitImpulseTurnErp},
      {"linearSlop", &info.m_linearSlop},
      {"warmstartingFactor", &info.m_warmstartingFactor},
      {"restitutionVelocityThreshold", &info.m_restitutionVelocityThreshold},
      {"contactBreakingThreshold", &gContactBreakingThreshold}};
  const std::map<std::string, int*> counts{{"numIterations", &info.m_numIterations},
                                           {"splitImpulse", &info.m_splitImpulse},
                                           {"solverMode", &info.m_solverMode}};
  for (const auto& [name, value] : set) {
    if (numbers.count(name) != 0) *numbers.at(name) = btScalar(value);
    if (counts.count(name) != 0) *counts.at(name) = int(value);
  }
}

class Stack {
 public:
  explicit Stack(const Question& question) : question_(question) {
    set_all(question.set, world_.getSolverInfo());
    world_.setGravity(btVector3(0, -number("gravity"), 0));
    btCollisionShape* ground = new btBoxShape(btVector3(1, 1, 1) * number("reach"));
    if (set("ground") != 0) ground = new btStaticPlaneShape(btVector3(0, 1, 0), 0);
    add(0, btVector3(0, 0, 0), ground,
        btTransform(btQuaternion::getIdentity(), btVector3(0, set("ground") != 0 ? 0 : -number("reach"), 0)));
    build();
  }

  void step(std::size_t at) {
    if (at < question_.shaking.size()) {
      world_.setGravity(btVector3(0, -number("gravity"), 0) - question_.shaking[at]);
    }
    world_.stepSimulation(number("dt"), 0);
  }

  void print() const {
    for (const btRigidBody* body : blocks_) {
      const btMatrix3x3& turn = body->getWorldTransform().getBasis();
      const double angle = std::atan2(double(turn[0][1]), double(turn[1][1]));
      std::printf("%.17g ", set("along") != 0 ? double(body->getWorldTransform().getOrigin().x()) : angle);
    }
    std::printf("\n");
  }

 private:
  btScalar number(const char* name) const { return btScalar(question_.number.at(name)); }
  double set(const char* name) const { return question_.set.count(name) != 0 ? question_.set.at(name) : 0; }

  void build() {
    for (const Block& block : question_.blocks) {
      const btVector3 half(btScalar(block.width / 2), btScalar(block.height / 2), btScalar(block.depth / 2));
      const btTransform place(btQuaternion(btVector3(0, 0, 1), btScalar(-block.angle)),
                              btVector3(btScalar(block.x), btScalar(block.y), 0));
      btRigidBody* body = add(
          block.mass, btVector3(btScalar(block.about_x), btScalar(block.about_y), btScalar(block.about_z)),
          shape(half), place);
      body->setLinearFactor(btVector3(1, 1, 0));
      body->setAngularFactor(btVector3(0, 0, 1));
      body->setActivationState(DISABLE_DEACTIVATION);
      blocks_.push_back(body);
    }
  }

  btCollisionShape* shape(const btVector3& half) const {
    if (set("shape") == 0) return new btBoxShape(half);
    btConvexHullShape* hull = new btConvexHullShape;
    hull->setMargin(0);
    for (const int z : {-1, 1}) {
      for (const int y : {-1, 1}) {
        for (const int x : {-1, 1}) hull->addPoint(btVector3(btScalar(x), btScalar(y), btScalar(z)) * half);
      }
    }
    return hull;
  }

  btRigidBody* add(double mass, const btVector3& inertia, btCollisionShape* shape, const btTransform& place) {
    btRigidBody::btRigidBodyConstructionInfo info(btScalar(mass), nullptr, shape, inertia);
    info.m_startWorldTransform = place;
    btRigidBody* body = new btRigidBody(info);
    body->setFriction(btSqrt(number("friction")));
    body->setRestitution(btScalar(std::sqrt(set("restitution"))));
    if (set("contactStiffness") != 0) {
      body->setContactStiffnessAndDamping(btScalar(2 * set("contactStiffness")),
                                          btScalar(set("contactDamping") / 2));
    }
    if (set("frictionAnchor") != 0) {
      body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_HAS_FRICTION_ANCHOR);
    }
    world_.addRigidBody(body);
    return body;
  }

  Question question_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, make_solver(question_), &configuration_};
  std::vector<btRigidBody*> blocks_;
};

}  // namespace

int main() {
  Question question;
  if (!read(std::cin, question)) return 2;
  Stack stack(question);
  stack.print();
  for (std::size_t step = 0; step < std::size_t(question.number.at("steps")); ++step) {
    stack.step(step);
    stack.print();
  }
}
