#include "engines/siconos/stack.hpp"

#include <SiconosConfig.h>
#include <SolverOptions.h>

#include <BlockVector.hpp>
#include <FrictionContact.hpp>
#include <Interaction.hpp>
#include <LagrangianLinearTIDS.hpp>
#include <LagrangianRheonomousR.hpp>
#include <MoreauJeanOSI.hpp>
#include <NewtonImpactFrictionNSL.hpp>
#include <NonSmoothDynamicalSystem.hpp>
#include <SimulationGraphs.hpp>
#include <TimeDiscretisation.hpp>
#include <TimeStepping.hpp>
#include <Topology.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

/// Null where another BLAS is in use.
extern "C" void openblas_set_num_threads(int number) __attribute__((weak));

namespace rockstack {
namespace {

/// Two vectors of a plane; angles turn to the left here, as in Siconos.
struct Vector {
  double x = 0, y = 0;
};

/// Where a body's axes are; those of the ground do not turn.
struct Frame {
  double x = 0, y = 0, angle = 0;
  Vector outward(const Vector& own) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * own.x - s * own.y, s * own.x + c * own.y};
  }
  Vector inward(const Vector& along) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * along.x + s * along.y, c * along.y - s * along.x};
  }
};

/// A corner of one body over a face of another, in the axes of each.
struct Touch {
  unsigned corner_body = 0;  ///< 0: the upper body, 1: what is under it
  Vector corner;
  double face = 0;        ///< height of the face
  double normal = 1;      ///< out of the face: up, or −1, down
  double half_width = 0;  ///< of the face; a corner beyond does not touch
};

/// A gap that no step closes, of a corner that has no face under it, m.
constexpr double apart = 1e9;

/// h(q, t): the gap of a corner over a face and its way along it.
class CornerOverFace : public LagrangianRheonomousR {
 public:
  CornerOverFace(const Touch& touch, const GroundStep& ground) : touch_(touch), ground_(ground) {
    _hDot = std::make_shared<SiconosVector>(2);
  }

  double gap(const BlockVector& q) const {
    const Frame face = frame(q, 1 - touch_.corner_body);
    const Vector point = corner(q);
    const Vector on_face = face.inward({point.x - face.x, point.y - face.y});
    return std::abs(on_face.x) <= touch_.half_width ? touch_.normal * (on_face.y - touch_.face) : apart;
  }

  /// Where the corner is along the lower face of the upper body, from its middle to the right, m.
  double along(const BlockVector& q) const {
    const Frame upper = frame(q, 0);
    const Vector point = corner(q);
    return upper.inward({point.x - upper.x, point.y - upper.y}).x;
  }

  void computeh(double, const BlockVector& q, BlockVector&, SiconosVector& y) override {
    y.setValue(0, gap(q));
  }

  /// The normal and the direction to its right, at the corner, of both bodies.
  void computeJachq(double, const BlockVector& q, BlockVector&) override {
    const Frame face = frame(q, 1 - touch_.corner_body);
    const Vector normal = face.outward({0, touch_.normal});
    const Vector rows[] = {normal, {normal.y, -normal.x}};
    const Vector point = corner(q);
    for (unsigned body = 0; 3 * body < q.size(); ++body) {
      const double sign = body == touch_.corner_body ? 1 : -1;
      const Frame own = frame(q, body);
      for (unsigned row = 0; row < 2; ++row) {
        const double turn = rows[row].y * (point.x - own.x) - rows[row].x * (point.y - own.y);
        _jachq->setValue(row, 3 * body, sign * rows[row].x);
        _jachq->setValue(row, 3 * body + 1, sign * rows[row].y);
        _jachq->setValue(row, 3 * body + 2, sign * turn);
      }
    }
  }

  /// What moves by itself is the ground, whose normal points up.
  void computehDot(double, const BlockVector& q, BlockVector&) override {
    if (q.size() > 3) return;
    _hDot->setValue(0, -ground_.velocity_y);
    _hDot->setValue(1, -ground_.velocity_x);
  }

 private:
  Frame frame(const BlockVector& q, unsigned body) const {
    if (3 * body >= q.size()) return {ground_.x, ground_.y, 0};
    return {q.getValue(3 * body), q.getValue(3 * body + 1), q.getValue(3 * body + 2)};
  }

  Vector corner(const BlockVector& q) const {
    const Frame own = frame(q, touch_.corner_body);
    const Vector arm = own.outward(touch_.corner);
    return {own.x + arm.x, own.y + arm.y};
  }

  Touch touch_;
  const GroundStep& ground_;
};

/// The corners that may touch at an interface: those of the upper block, and those of what is under it.
std::vector<Touch> touches(const Placement& upper, const Placement* lower) {
  // Aligned corners are off by their rounding.
  constexpr double margin = 1 + 1e-9;
  const double endless = std::numeric_limits<double>::infinity();
  std::vector<Touch> list;
  for (const double side : {-0.5, 0.5}) {
    list.push_back({0,
                    {side * upper.width, -0.5 * upper.height},
                    lower == nullptr ? 0 : 0.5 * lower->height,
                    1,
                    lower == nullptr ? endless : 0.5 * lower->width * margin});
    if (lower == nullptr) continue;
    list.push_back(
        {1, {side * lower->width, 0.5 * lower->height}, -0.5 * upper.height, -1, 0.5 * upper.width * margin});
  }
  return list;
}

/// Siconos tells of its solver's failures by a function for the whole process.
thread_local std::size_t failed_solutions = 0;

void note(int info, ::Simulation*) {
  failed_solutions += info != 0 ? 1 : 0;
}

/// OpenBLAS, where it is the BLAS, shares matrices of this size among threads that wait for each other.
void use_one_thread() {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
}

/// solver_options_delete() leaves the structure itself.
void destroy(SolverOptions* options) {
  solver_options_delete(options);
  std::free(options);
}

std::shared_ptr<SiconosVector> vector_of(double x, double y, double angle) {
  auto vector = std::make_shared<SiconosVector>(3);
  vector->setValue(0, x);
  vector->setValue(1, y);
  vector->setValue(2, angle);
  return vector;
}

}  // namespace

struct SiconosStack::Parts {
  struct Corner {
    std::size_t interface;
    std::shared_ptr<CornerOverFace> relation;
    std::shared_ptr<Interaction> interaction;
    const BlockVector& places() const { return *interaction->linkToDSVariables()[LagrangianR::q0]; }
  };

  ~Parts() {
    // These point at each other.
    integrator->setSimulationPtr(nullptr);
    integrator->setDynamicalSystemsGraph(nullptr);
    problem->setSimulationPtr(nullptr);
    simulation->clear();
    system->clear();
  }

  std::shared_ptr<NonSmoothDynamicalSystem> system;
  std::vector<std::shared_ptr<LagrangianLinearTIDS>> bodies;
  std::vector<Corner> corners;
  std::shared_ptr<MoreauJeanOSI> integrator;
  std::shared_ptr<FrictionContact> problem;
  std::shared_ptr<TimeStepping> simulation;
  BodyAcceleration acceleration;
  GroundStep ground;  ///< where it is at the end of the step under way
};

SiconosStack::SiconosStack(const Setup& setup, const Parameters& parameters)
    : blocks_(setup.blocks),
      mass_factor_(mass_factor(setup, parameters)),
      dt_(setup.dt),
      parts_(std::make_unique<Parts>()) {
  use_one_thread();
  const double end = (static_cast<double>(setup.steps) + 2) * dt_;
  parts_->system = std::make_shared<NonSmoothDynamicalSystem>(0, end);
  parts_->acceleration = setup.gravity;
  add_bodies(setup);
  add_corners(setup, parameters.at("en"));
  add_scheme(parameters);
}

SiconosStack::~SiconosStack() = default;

void SiconosStack::add_bodies(const Setup& setup) {
  for (const Placement& block : setup.blocks) {
    const auto mass = std::make_shared<SimpleMatrix>(3, 3);
    mass->setValue(0, 0, mass_factor_ * block.mass);
    mass->setValue(1, 1, mass_factor_ * block.mass);
    mass->setValue(2, 2, mass_factor_ * block.inertia);
    const auto body = std::make_shared<LagrangianLinearTIDS>(
        vector_of(block.x, block.y, -block.angle),
        vector_of(block.velocity_x, block.velocity_y, -block.angular_velocity), mass);
    body->setFExtPtr(vector_of(0, 0, 0));
    parts_->system->insertDynamicalSystem(body);
    parts_->bodies.push_back(body);
  }
}

void SiconosStack::add_corners(const Setup& setup, double restitution) {
  for (std::size_t k = 0; k < setup.blocks.size(); ++k) {
    const auto law = std::make_shared<NewtonImpactFrictionNSL>(restitution, 0, setup.friction[k], 2);
    for (const Touch& touch : touches(setup.blocks[k], k == 0 ? nullptr : &setup.blocks[k - 1])) {
      const auto relation = std::make_shared<CornerOverFace>(touch, parts_->ground);
      const auto interaction = std::make_shared<Interaction>(law, relation);
      parts_->corners.push_back({k, relation, interaction});
      if (k == 0) {
        parts_->system->link(interaction, parts_->bodies[k]);
      } else {
        parts_->system->link(interaction, parts_->bodies[k], parts_->bodies[k - 1]);
      }
    }
  }
}

void SiconosStack::add_scheme(const Parameters& parameters) {
  parts_->integrator = std::make_shared<MoreauJeanOSI>(parameters.at("theta"), parameters.at("gamma"));
  parts_->integrator->setConstraintActivationThreshold(parameters.at("constraintActivationThreshold"));
  const std::shared_ptr<SolverOptions> options(solver_options_create(SICONOS_FRICTION_2D_NSGS), &destroy);
  options->dparam[SICONOS_DPARAM_TOL] = parameters.at("SICONOS_DPARAM_TOL");
  options->iparam[SICONOS_IPARAM_MAX_ITER] = static_cast<int>(parameters.at("SICONOS_IPARAM_MAX_ITER"));
  parts_->problem = std::make_shared<FrictionContact>(2, options);
  parts_->problem->setKeepLambdaAndYState(parameters.at("keepLambdaAndYState") != 0);
  parts_->simulation = std::make_shared<TimeStepping>(
      parts_->system, std::make_shared<TimeDiscretisation>(0, dt_), parts_->integrator, parts_->problem);
  parts_->simulation->setCheckSolverFunction(&note);
  parts_->simulation->setWarnOnNonConvergence(false);
}

void SiconosStack::step(const ShakingStep& shaking) {
  if (shaking.acceleration) parts_->acceleration = *shaking.acceleration;
  if (shaking.ground) {
    // A velocity is asked for at the step's end, and the next step's contacts are chosen there.
    parts_->ground = *shaking.ground;
    parts_->ground.x += dt_ * shaking.ground->velocity_x;
    parts_->ground.y += dt_ * shaking.ground->velocity_y;
  }
  for (const auto& body : parts_->bodies) {
    const double mass = body->mass()->getValue(0, 0);
    body->fExt()->setValue(0, mass * parts_->acceleration.x);
    body->fExt()->setValue(1, mass * parts_->acceleration.y);
  }
  std::vector<double> gaps;
  if (watched_) {
    for (const Parts::Corner& corner : parts_->corners) gaps.push_back(corner.relation->gap(corner.places()));
  }
  failed_solutions = 0;
  parts_->simulation->computeOneStep();
  failures_ += failed_solutions;
  if (watched_) read_contacts(gaps);
  parts_->simulation->nextStep();
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    const SiconosVector &q = *parts_->bodies[k]->q(), &v = *parts_->bodies[k]->velocity();
    blocks_[k].x = q.getValue(0);
    blocks_[k].y = q.getValue(1);
    blocks_[k].angle = -q.getValue(2);
    blocks_[k].velocity_x = v.getValue(0);
    blocks_[k].velocity_y = v.getValue(1);
    blocks_[k].angular_velocity = -v.getValue(2);
  }
}

/// Those that the step had a law for: Siconos's index set 1.
void SiconosStack::read_contacts(const std::vector<double>& gaps_before) {
  contacts_.clear();
  const auto touching = parts_->system->topology()->indexSet(1);
  for (std::size_t i = 0; i < parts_->corners.size(); ++i) {
    const Parts::Corner& corner = parts_->corners[i];
    if (!touching->is_vertex(corner.interaction)) continue;
    const SiconosVector& impulse = *corner.interaction->lambda(1);
    ContactPoint point;
    point.interface = corner.interface;
    point.along = corner.relation->along(corner.places());
    point.gap_before = gaps_before[i];
    point.gap = corner.relation->gap(corner.places());
    point.normal = impulse.getValue(0) / mass_factor_;
    point.tangential = std::abs(impulse.getValue(1)) / mass_factor_;
    contacts_.push_back(point);
  }
}

}  // namespace rockstack
