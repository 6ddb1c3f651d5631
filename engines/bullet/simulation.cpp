#include "engines/bullet/simulation.hpp"

#include <btBulletDynamicsCommon.h>

#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btLemkeSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <BulletDynamics/MLCPSolvers/btSolveProjectedGaussSeidel.h>
#include <algorithm>

namespace rockstack {
namespace {

btScalar scalar(double value) {
  return static_cast<btScalar>(value);
}

btVector3 vector(double x, double y, double z) {
  return {scalar(x), scalar(y), scalar(z)};
}

/// A shape that carries its own contact breaking threshold: no global of the library has to be written.
template <class Shape>
class Threshold : public Shape {
 public:
  template <class... Arguments>
  explicit Threshold(double breaking_factor, btScalar reach, const Arguments&... arguments)
      : Shape(arguments...), breaking_factor_(breaking_factor), reach_(reach, reach, reach) {}
  btScalar getContactBreakingThreshold(btScalar /*library_factor*/) const override {
    return scalar(breaking_factor_) * this->getAngularMotionDisc();
  }
  void getAabb(const btTransform& place, btVector3& least, btVector3& most) const override {
    Shape::getAabb(place, least, most);
    least -= reach_;
    most += reach_;
  }

 private:
  double breaking_factor_;
  btVector3 reach_;
};

/// A box; `reach`: by how much its bounds are larger, m.
std::unique_ptr<btCollisionShape> make_box(const btVector3& half, double breaking_factor, btScalar reach) {
  return std::make_unique<Threshold<btBoxShape>>(breaking_factor, reach, half);
}

/// Without a margin, as that would round the corners.
std::unique_ptr<btCollisionShape> make_hull(const btVector3& half, double breaking_factor, btScalar reach) {
  auto hull = std::make_unique<Threshold<btConvexHullShape>>(breaking_factor, reach);
  hull->setMargin(0);
  for (int corner = 0; corner < 8; ++corner) {
    const btVector3 side((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
    hull->addPoint(side * half);
  }
  return hull;
}

/// A shape whose middle is off its body's origin. Inside a compound the library looks for contacts between
/// bounds that overlap: the shape's reach as far as the contact breaking threshold.
class Shifted : public btCompoundShape {
 public:
  Shifted(std::unique_ptr<btCollisionShape> shape, btScalar threshold, const btVector3& middle)
      : btCompoundShape(false), shape_(std::move(shape)), threshold_(threshold) {
    addChildShape(btTransform(btQuaternion::getIdentity(), middle), shape_.get());
  }
  btScalar getContactBreakingThreshold(btScalar /*library_factor*/) const override { return threshold_; }

 private:
  std::unique_ptr<btCollisionShape> shape_;
  btScalar threshold_;
};

/// A block's shape by one of the functions above.
template <class Make>
std::unique_ptr<btCollisionShape> shape_of(const Placement& block, double breaking_factor, const Make& make) {
  const btVector3 half = vector(0.5 * block.width, 0.5 * block.height, 0.5 * block.depth);
  std::unique_ptr<btCollisionShape> shape = make(half, breaking_factor, 0);
  if (!is_eccentric(block)) return shape;
  const btScalar threshold = shape->getContactBreakingThreshold(0);
  return std::make_unique<Shifted>(make(half, breaking_factor, threshold), threshold,
                                   vector(-block.offset_x, -block.offset_y, 0));
}

void apply(const Parameters& parameters, btContactSolverInfo& info) {
  info.m_numIterations = static_cast<int>(parameters.at("numIterations"));
  info.m_erp2 = scalar(parameters.at("erp2"));
  info.m_globalCfm = scalar(parameters.at("globalCfm"));
  info.m_sor = scalar(parameters.at("sor"));
  info.m_splitImpulse = static_cast<int>(parameters.at("splitImpulse"));
  info.m_splitImpulsePenetrationThreshold = scalar(parameters.at("splitImpulsePenetrationThreshold"));
  info.m_splitImpulseTurnErp = scalar(parameters.at("splitImpulseTurnErp"));
  info.m_linearSlop = scalar(parameters.at("linearSlop"));
  info.m_warmstartingFactor = scalar(parameters.at("warmstartingFactor"));
  info.m_solverMode = static_cast<int>(parameters.at("solverMode"));
  info.m_restitutionVelocityThreshold = scalar(parameters.at("restitutionVelocityThreshold"));
  info.m_frictionERP = scalar(parameters.at("frictionERP"));
  info.m_leastSquaresResidualThreshold = scalar(parameters.at("leastSquaresResidualThreshold"));
}

/// What is inside a solver for complementarity problems; null in any other.
std::unique_ptr<btMLCPSolverInterface> make_algorithm(BulletSolver solver, const Parameters& parameters) {
  if (solver == BulletSolver::sequential_impulse || solver == BulletSolver::nncg) return nullptr;
  if (solver == BulletSolver::mlcp_dantzig) return std::make_unique<btDantzigSolver>();
  if (solver == BulletSolver::mlcp_lemke) {
    auto lemke = std::make_unique<btLemkeSolver>();
    lemke->m_maxLoops = static_cast<int>(parameters.at("maxLoops"));
    lemke->m_maxValue = scalar(parameters.at("maxValue"));
    return lemke;
  }
  auto projected = std::make_unique<btSolveProjectedGaussSeidel>();
  projected->m_leastSquaresResidualThreshold = scalar(parameters.at("leastSquaresResidualThreshold"));
  return projected;
}

std::unique_ptr<btSequentialImpulseConstraintSolver> make_solver(BulletSolver solver,
                                                                 btMLCPSolverInterface* algorithm) {
  if (algorithm != nullptr) return std::make_unique<btMLCPSolver>(algorithm);
  if (solver == BulletSolver::nncg) return std::make_unique<btNNCGConstraintSolver>();
  return std::make_unique<btSequentialImpulseConstraintSolver>();
}

/// A pair's coefficient, that of the interface under its upper body, which has it.
btScalar friction_of_pair(const btCollisionObject* a, const btCollisionObject* b) {
  return (a->getUserIndex() > b->getUserIndex() ? a : b)->getFriction();
}

/// What each body of a pair has: Bullet multiplies restitution, takes stiffness in series and adds damping.
struct Surface {
  btScalar restitution;
  btScalar stiffness, damping;  ///< N/m, N·s/m; both zero: none of its own
  int flags;
};

/// What makes a contact point a spring and a dashpot; cfm in s/kg.
struct Softness {
  double erp, cfm;
};

class BulletSimulation final : public ShakenSimulation {
 public:
  BulletSimulation(BulletSolver solver, const Setup& setup, const Parameters& parameters)
      : ShakenSimulation(setup, mass_factor(setup, parameters)),
        surface_{scalar(std::sqrt(parameters.at("restitution"))),
                 scalar(2 * mass_factor_ * parameters.at("contactStiffness")),
                 scalar(0.5 * mass_factor_ * parameters.at("contactDamping")),
                 parameters.at("frictionAnchor") != 0 ? btCollisionObject::CF_HAS_FRICTION_ANCHOR : 0},
        dispatcher_(&configuration_),
        algorithm_(make_algorithm(solver, parameters)),
        solver_(make_solver(solver, algorithm_.get())) {
    // One callback for all worlds, as pairs know all that it asks for.
    [[maybe_unused]] static const auto friction = gCalculateCombinedFrictionCallback = friction_of_pair;
    apply(parameters, world_.getSolverInfo());
    set_gravity(setup.gravity);
    const double breaking_factor = scalar(parameters.at("contactBreakingThreshold"));
    const auto shape = parameters.at("shape") != 0 ? make_hull : make_box;
    if (parameters.at("ground") != 0) {
      add_ground(std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), scalar(0)), {0, 0, 0});
    } else {
      const double reach = ground_reach(setup.blocks);
      add_ground(make_box(vector(reach, reach, reach), breaking_factor, 0), vector(0, -reach, 0));
    }
    for (std::size_t k = 0; k < setup.blocks.size(); ++k) {
      const Placement& block = setup.blocks[k];
      add_block(block, std::min(setup.friction[k], friction_clamp), shape_of(block, breaking_factor, shape));
    }
  }

  BodyState body(std::size_t k) const override {
    const btVector3& place = block(k).getWorldTransform().getOrigin();
    const btVector3& velocity = block(k).getLinearVelocity();
    const btMatrix3x3& turn = block(k).getWorldTransform().getBasis();
    return {place.x(),    place.y(),
            velocity.x(), velocity.y(),
            angles_[k],   -block(k).getAngularVelocity().z(),
            place.z(),    std::hypot(turn[0][2], turn[1][2])};
  }

  /// How often Bullet gave a problem up and took sequential impulse in its place.
  std::size_t warnings() const override {
    if (algorithm_ == nullptr) return 0;
    return static_cast<std::size_t>(static_cast<btMLCPSolver&>(*solver_).getNumFallbacks());
  }

  /// Bullet keeps a contact's impulses for a warm start alone.
  bool watch_contacts() override { return tells_impulses(); }

  std::vector<ContactPoint> contacts() const override {
    std::vector<ContactPoint> points;
    if (!tells_impulses()) return points;
    for (int pair = 0; pair < dispatcher_.getNumManifolds(); ++pair) {
      const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(pair);
      for (int i = 0; i < manifold.getNumContacts(); ++i) points.push_back(point_of(manifold, i));
    }
    return points;
  }

 private:
  bool tells_impulses() const { return (world_.getSolverInfo().m_solverMode & SOLVER_USE_WARMSTARTING) != 0; }

  /// Where a point of a body is at the step's end. The library leaves a moving ground where the step starts.
  btVector3 place_of(const btCollisionObject& body, const btVector3& point) const {
    const btVector3 place = body.getWorldTransform() * point;
    return &body == bodies_.front().get() ? place + scalar(dt()) * ground_velocity_ : place;
  }

  ContactPoint point_of(const btPersistentManifold& manifold, int i) const {
    const btManifoldPoint& found = manifold.getContactPoint(i);
    const btCollisionObject &a = *manifold.getBody0(), &b = *manifold.getBody1();
    const int number_a = a.getUserIndex(), number_b = b.getUserIndex();
    const Softness softness = softness_of(found);
    // A spring where all overlap is corrected, and through velocities.
    const btContactSolverInfo& info = world_.getSolverInfo();
    const bool split =
        info.m_splitImpulse != 0 && found.getDistance() <= info.m_splitImpulsePenetrationThreshold;
    const double stiffness = split || info.m_linearSlop != 0
                                 ? std::numeric_limits<double>::infinity()
                                 : contact_stiffness(softness.erp, softness.cfm, dt());
    const btScalar on_upper = scalar((number_a > number_b ? 1 : -1) / mass_factor_);
    const btVector3 impulse = on_upper * (found.getAppliedImpulse() * found.m_normalWorldOnB +
                                          found.m_appliedImpulseLateral1 * found.m_lateralFrictionDir1 +
                                          found.m_appliedImpulseLateral2 * found.m_lateralFrictionDir2);
    return {.interface = static_cast<std::size_t>(std::max(number_a, number_b) - 1),
            .along = (number_a > number_b ? found.m_localPointA : found.m_localPointB).x(),
            .gap_before = found.getDistance(),
            .gap = found.m_normalWorldOnB.dot(place_of(a, found.m_localPointA) -
                                              place_of(b, found.m_localPointB)),
            .normal = found.getAppliedImpulse() / mass_factor_,
            .tangential =
                std::hypot(found.m_appliedImpulseLateral1, found.m_appliedImpulseLateral2) / mass_factor_,
            .impulse_x = impulse.x(),
            .impulse_y = impulse.y(),
            .stiffness = stiffness / mass_factor_,
            .damping = contact_damping(softness.erp, softness.cfm) / mass_factor_};
  }

  /// A point with a spring has its own erp and cfm; complementarity problems take the world's cfm for all.
  Softness softness_of(const btManifoldPoint& point) const {
    const btContactSolverInfo& info = world_.getSolverInfo();
    Softness softness{info.m_erp2, info.m_globalCfm};
    if ((point.m_contactPointFlags & BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING) == 0) return softness;
    const double spring = dt() * point.m_combinedContactStiffness1;
    const double both = spring + point.m_combinedContactDamping1;
    softness.erp = spring / both;
    if (algorithm_ == nullptr) softness.cfm = 1 / both;
    return softness;
  }

  const btRigidBody& block(std::size_t k) const { return *bodies_[k + 1]; }

  void advance() override {
    world_.stepSimulation(scalar(dt()), 0);
    for (std::size_t k = 0; k < angles_.size(); ++k) {
      const btMatrix3x3& turn = block(k).getWorldTransform().getBasis();
      angles_[k] = unwrap(std::atan2(-turn[1][0], turn[0][0]), angles_[k]);
    }
  }

  void set_gravity(const BodyAcceleration& acceleration) override {
    world_.setGravity(vector(acceleration.x, acceleration.y, 0));
  }

  /// Changes velocities before the step: by forces a block at rest lifts off too fast, as if 3 ms before.
  void apply_load(std::size_t k, const BodyLoad& load) override {
    bodies_[k + 1]->applyCentralImpulse(scalar(dt()) * vector(load.x, load.y, 0));
    bodies_[k + 1]->applyTorqueImpulse(scalar(dt()) * vector(0, 0, -load.moment));
  }

  /// Its middle is at `start`, its face at y = 0.
  void add_ground(std::unique_ptr<btCollisionShape> shape, const btVector3& start) {
    shapes_.push_back(std::move(shape));
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shapes_.back().get());
    ground_start_ = start;
    info.m_startWorldTransform = btTransform(btQuaternion::getIdentity(), ground_start_);
    btRigidBody& ground = add(info, moves_ground() ? btCollisionObject::CF_KINEMATIC_OBJECT : 0);
    if (!moves_ground()) return;
    ground.setActivationState(DISABLE_DEACTIVATION);
    // Bullet takes a kinematic body's velocity from where it was a step ago; this comes after that.
    const auto give_velocity = [](btDynamicsWorld* world, btScalar) {
      auto& self = *static_cast<BulletSimulation*>(world->getWorldUserInfo());
      self.bodies_.front()->setLinearVelocity(self.ground_velocity_);
    };
    world_.setInternalTickCallback(give_velocity, this, true);
  }

  void place_ground(const GroundStep& step) override {
    bodies_.front()->getWorldTransform().setOrigin(ground_start_ + vector(step.x, step.y, 0));
    ground_velocity_ = vector(step.velocity_x, step.velocity_y, 0);
  }

  /// `friction`: of the interface under it.
  void add_block(const Placement& placement, double friction, std::unique_ptr<btCollisionShape> shape) {
    shapes_.push_back(std::move(shape));
    btRigidBody::btRigidBodyConstructionInfo info(
        scalar(mass_factor_ * placement.mass), nullptr, shapes_.back().get(),
        mass_factor_ * vector(placement.inertia_about_x, placement.inertia_about_y, placement.inertia));
    info.m_friction = scalar(friction);
    info.m_startWorldTransform = btTransform(btQuaternion(btVector3(0, 0, 1), scalar(-placement.angle)),
                                             vector(placement.x, placement.y, 0));
    btRigidBody& body = add(info);
    body.setLinearFactor({1, 1, 0});
    body.setAngularFactor({0, 0, 1});
    body.setActivationState(DISABLE_DEACTIVATION);
    body.setLinearVelocity(vector(placement.velocity_x, placement.velocity_y, 0));
    body.setAngularVelocity(vector(0, 0, -placement.angular_velocity));
    angles_.push_back(placement.angle);
  }

  btRigidBody& add(btRigidBody::btRigidBodyConstructionInfo& info, int flags = 0) {
    info.m_restitution = surface_.restitution;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& body = *bodies_.back();
    body.setCollisionFlags((flags != 0 ? flags : body.getCollisionFlags()) | surface_.flags);
    if (surface_.stiffness != 0 || surface_.damping != 0)
      body.setContactStiffnessAndDamping(surface_.stiffness, surface_.damping);
    body.setUserIndex(static_cast<int>(bodies_.size()) - 1);
    world_.addRigidBody(&body);
    return body;
  }

  std::vector<double> angles_;
  btVector3 ground_start_{0, 0, 0}, ground_velocity_{0, 0, 0};
  Surface surface_;
  // The world comes last: it is the first to go and still needs the others then.
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  std::unique_ptr<btMLCPSolverInterface> algorithm_;
  std::unique_ptr<btSequentialImpulseConstraintSolver> solver_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;  ///< ground first, then bottom to top
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, solver_.get(), &configuration_};
};

}  // namespace

std::unique_ptr<Simulation> start_bullet(BulletSolver solver, const Setup& setup,
                                         const Parameters& parameters) {
  return std::make_unique<BulletSimulation>(solver, setup, parameters);
}

}  // namespace rockstack
