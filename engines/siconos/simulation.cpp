#include "engines/engine.hpp"

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
#include <cstdlib>

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
  Vector seen(const Vector& point) const {
    const double c = std::cos(angle), s = std::sin(angle), along = point.x - x, up = point.y - y;
    return {c * along + s * up, c * up - s * along};
  }
};

/// A corner of one body over a face of another, in the axes of each, whose origins are centres of mass.
struct Touch {
  unsigned corner_body = 0;  ///< 0: the upper body, 1: what is under it
  Vector corner;
  Vector face;            ///< middle of the face
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
    const Vector on_face = frame(q, 1 - touch_.corner_body).seen(corner(q));
    const bool over = std::abs(on_face.x - touch_.face.x) <= touch_.half_width;
    return over ? touch_.normal * (on_face.y - touch_.face.y) : apart;
  }

  /// Where the corner is along the lower face of the upper body, from below its centre of mass, m.
  double along(const BlockVector& q) const { return frame(q, 0).seen(corner(q)).x; }

  /// On the upper body, of a force along the normal and to its right on the corner's.
  Vector on_upper(const BlockVector& q, double push, double right) const {
    const Vector normal = frame(q, 1 - touch_.corner_body).outward({0, touch_.normal});
    const double sign = touch_.corner_body == 0 ? 1 : -1;
    return {sign * (push * normal.x + right * normal.y), sign * (push * normal.y - right * normal.x)};
  }

  void computeh(double, const BlockVector& q, BlockVector&, SiconosVector& y) override {
    y.setValue(0, gap(q));
  }

  /// The normal and the direction to its right, at the corner, of both bodies.
  void computeJachq(double, const BlockVector& q, BlockVector&) override {
    const Vector normal = frame(q, 1 - touch_.corner_body).outward({0, touch_.normal});
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

/// A point of a block's box, from its middle in half sizes, in the block's axes.
Vector point_of(const Placement& block, double right, double up) {
  return {0.5 * right * block.width - block.offset_x, 0.5 * up * block.height - block.offset_y};
}

/// The corners that may touch at an interface: those of the upper block, and those of what is under it.
std::vector<Touch> touches(const Placement& upper, const Placement* lower) {
  // Aligned corners are off by their rounding.
  constexpr double margin = 1 + 1e-9;
  const double reach =
      lower == nullptr ? std::numeric_limits<double>::infinity() : 0.5 * lower->width * margin;
  const Vector top = lower == nullptr ? Vector{} : point_of(*lower, 0, 1);
  std::vector<Touch> list;
  for (const double side : {-1.0, 1.0}) {
    list.push_back({0, point_of(upper, side, -1), top, 1, reach});
    if (lower == nullptr) continue;
    list.push_back({1, point_of(*lower, side, 1), point_of(upper, 0, -1), -1, 0.5 * upper.width * margin});
  }
  return list;
}

/// Siconos tells of its solver's failures by a function for the whole process.
thread_local std::size_t failed_solutions = 0;

std::shared_ptr<SiconosVector> vector_of(double x, double y, double angle) {
  return std::make_shared<SiconosVector>(std::vector<double>{x, y, angle});
}

/// Each block is a dynamical system with three coordinates, each corner over a face an interaction.
class SiconosSimulation final : public ShakenSimulation {
 public:
  SiconosSimulation(const Setup& setup, const Parameters& parameters)
      : ShakenSimulation(setup, mass_factor(setup, parameters)),
        system_(std::make_shared<NonSmoothDynamicalSystem>(0, (static_cast<double>(setup.steps) + 2) * dt())),
        acceleration_(setup.gravity),
        loads_(setup.blocks.size()) {
    // OpenBLAS, where it is the BLAS, shares matrices of this size among threads that wait for each other.
    if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
    for (const Placement& block : setup.blocks) add_body(block);
    add_corners(setup, parameters.at("en"));
    add_scheme(parameters);
  }

  ~SiconosSimulation() override {
    // These point at each other.
    integrator_->setSimulationPtr(nullptr);
    integrator_->setDynamicalSystemsGraph(nullptr);
    problem_->setSimulationPtr(nullptr);
    simulation_->clear();
    system_->clear();
  }

  BodyState body(std::size_t k) const override {
    const SiconosVector &q = *bodies_[k]->q(), &v = *bodies_[k]->velocity();
    return {q.getValue(0), q.getValue(1), v.getValue(0), v.getValue(1), -q.getValue(2), -v.getValue(2)};
  }

  std::vector<ContactPoint> contacts() const override { return contacts_; }

  /// Steps in which the solver did not reach its tolerance.
  std::size_t warnings() const override { return failures_; }

 private:
  struct Corner {
    std::size_t interface;
    std::shared_ptr<CornerOverFace> relation;
    std::shared_ptr<Interaction> interaction;
    const BlockVector& places() const { return *interaction->linkToDSVariables()[LagrangianR::q0]; }
  };

  void add_body(const Placement& block) {
    const auto mass = std::make_shared<SimpleMatrix>(3, 3);
    mass->setValue(0, 0, mass_factor_ * block.mass);
    mass->setValue(1, 1, mass_factor_ * block.mass);
    mass->setValue(2, 2, mass_factor_ * block.inertia);
    bodies_.push_back(std::make_shared<LagrangianLinearTIDS>(
        vector_of(block.x, block.y, -block.angle),
        vector_of(block.velocity_x, block.velocity_y, -block.angular_velocity), mass));
    bodies_.back()->setFExtPtr(vector_of(0, 0, 0));
    system_->insertDynamicalSystem(bodies_.back());
  }

  void add_corners(const Setup& setup, double restitution) {
    for (std::size_t k = 0; k < setup.blocks.size(); ++k) {
      const auto law = std::make_shared<NewtonImpactFrictionNSL>(restitution, 0, setup.friction[k], 2);
      for (const Touch& touch : touches(setup.blocks[k], k == 0 ? nullptr : &setup.blocks[k - 1])) {
        const auto relation = std::make_shared<CornerOverFace>(touch, ground_);
        const auto interaction = std::make_shared<Interaction>(law, relation);
        corners_.push_back({k, relation, interaction});
        system_->link(interaction, bodies_[k], k == 0 ? nullptr : bodies_[k - 1]);
      }
    }
  }

  void add_scheme(const Parameters& parameters) {
    integrator_ = std::make_shared<MoreauJeanOSI>(parameters.at("theta"), parameters.at("gamma"));
    integrator_->setConstraintActivationThreshold(parameters.at("constraintActivationThreshold"));
    const std::shared_ptr<SolverOptions> options(solver_options_create(SICONOS_FRICTION_2D_NSGS),
                                                 [](SolverOptions* made) {
                                                   solver_options_delete(made);
                                                   std::free(made);  // it leaves the structure itself
                                                 });
    options->dparam[SICONOS_DPARAM_TOL] = parameters.at("SICONOS_DPARAM_TOL");
    options->iparam[SICONOS_IPARAM_MAX_ITER] = static_cast<int>(parameters.at("SICONOS_IPARAM_MAX_ITER"));
    problem_ = std::make_shared<FrictionContact>(2, options);
    problem_->setKeepLambdaAndYState(parameters.at("keepLambdaAndYState") != 0);
    simulation_ = std::make_shared<TimeStepping>(system_, std::make_shared<TimeDiscretisation>(0, dt()),
                                                 integrator_, problem_);
    simulation_->setCheckSolverFunction(
        [](int info, ::Simulation*) { failed_solutions += info != 0 ? 1 : 0; });
    simulation_->setWarnOnNonConvergence(false);
  }

  void set_gravity(const BodyAcceleration& acceleration) override { acceleration_ = acceleration; }

  /// A velocity is asked for at the step's end, and the next step's contacts are chosen there.
  void place_ground(const GroundStep& step) override {
    ground_ = step;
    ground_.x += dt() * step.velocity_x;
    ground_.y += dt() * step.velocity_y;
  }

  void apply_load(std::size_t k, const BodyLoad& load) override { loads_[k] = load; }

  void advance() override {
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      const double mass = bodies_[k]->mass()->getValue(0, 0);
      SiconosVector& force = *bodies_[k]->fExt();
      force.setValue(0, mass * acceleration_.x + loads_[k].x);
      force.setValue(1, mass * acceleration_.y + loads_[k].y);
      force.setValue(2, -loads_[k].moment);
    }
    std::vector<double> gaps;
    if (watches_contacts())
      for (const Corner& corner : corners_) gaps.push_back(corner.relation->gap(corner.places()));
    failed_solutions = 0;
    simulation_->computeOneStep();
    failures_ += failed_solutions;
    if (watches_contacts()) read_contacts(gaps);
    simulation_->nextStep();
  }

  /// Those that the step had a law for: Siconos's index set 1.
  void read_contacts(const std::vector<double>& gaps_before) {
    contacts_.clear();
    const auto touching = system_->topology()->indexSet(1);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Corner& corner = corners_[i];
      if (!touching->is_vertex(corner.interaction)) continue;
      const SiconosVector& impulse = *corner.interaction->lambda(1);
      const Vector on_upper = corner.relation->on_upper(corner.places(), impulse.getValue(0) / mass_factor_,
                                                        impulse.getValue(1) / mass_factor_);
      contacts_.push_back({corner.interface, corner.relation->along(corner.places()), gaps_before[i],
                           corner.relation->gap(corner.places()), impulse.getValue(0) / mass_factor_,
                           std::abs(impulse.getValue(1)) / mass_factor_, on_upper.x, on_upper.y});
    }
  }

  std::shared_ptr<NonSmoothDynamicalSystem> system_;
  std::vector<std::shared_ptr<LagrangianLinearTIDS>> bodies_;
  std::vector<Corner> corners_;
  std::shared_ptr<MoreauJeanOSI> integrator_;
  std::shared_ptr<FrictionContact> problem_;
  std::shared_ptr<TimeStepping> simulation_;
  BodyAcceleration acceleration_;
  std::vector<BodyLoad> loads_;  ///< over the step under way
  GroundStep ground_;            ///< where it is at the end of the step under way
  std::vector<ContactPoint> contacts_;
  std::size_t failures_ = 0;
};

}  // namespace

std::unique_ptr<Simulation> start_siconos(const Setup& setup, const Parameters& parameters) {
  return std::make_unique<SiconosSimulation>(setup, parameters);
}

}  // namespace rockstack
