#include "engines/engine.hpp"

#include <Simbody.h>

#include <algorithm>

namespace rockstack {
namespace {

using SimTK::Vec3;

/// In the order of the setting's choices.
std::unique_ptr<SimTK::Integrator> make_integrator(double choice, const SimTK::System& system) {
  if (choice == 1) return std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system);
  if (choice == 2) return std::make_unique<SimTK::RungeKutta3Integrator>(system);
  if (choice == 3) return std::make_unique<SimTK::VerletIntegrator>(system);
  return std::make_unique<SimTK::CPodesIntegrator>(system, SimTK::CPodes::BDF);
}

/// Where the middle of a block's box is in its body, whose origin is the centre of mass.
Vec3 middle_of(const Placement& block) {
  return {-block.offset_x, -block.offset_y, 0};
}

/// A half space whose face is at the height y of its body, which lies below or above that.
SimTK::Transform face_at(double y, bool body_above) {
  return {SimTK::Rotation(SimTK::UnitVec3(0, body_above ? 1 : -1, 0), SimTK::XAxis), Vec3(0, y, 0)};
}

class SimbodySimulation final : public ShakenSimulation {
 public:
  SimbodySimulation(const Setup& setup, const Parameters& parameters)
      : ShakenSimulation(setup, mass_factor(setup, parameters)),
        stiffness_(parameters.at("stiffness")),
        dissipation_(parameters.at("dissipation")),
        gravity_(forces_, matter_, Vec3(setup.gravity.x, setup.gravity.y, 0)),
        loads_(forces_, matter_) {
    contact_.setTransitionVelocity(parameters.at("transition_velocity"));
    std::vector<SimTK::Body> bodies{matter_.Ground().getBody()};
    for (const Placement& block : setup.blocks)
      bodies.push_back(SimTK::Body::Rigid(SimTK::MassProperties(
          mass_factor_ * block.mass, Vec3(0), mass_factor_ * SimTK::Inertia(block.inertia))));
    add_contacts(setup, bodies);
    matter_.Ground().updBody() = bodies[0];
    for (std::size_t k = 0; k < setup.blocks.size(); ++k)
      blocks_.emplace_back(matter_.Ground(), bodies[k + 1]);
    SimTK::State state = system_.realizeTopology();
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      const Placement& block = setup.blocks[k];
      blocks_[k].setQ(state, Vec3(-block.angle, block.x, block.y));
      blocks_[k].setU(state, Vec3(-block.angular_velocity, block.velocity_x, block.velocity_y));
    }
    integrator_ = make_integrator(parameters.at("integrator"), system_);
    integrator_->setAccuracy(parameters.at("accuracy"));
    integrator_->setAllowInterpolation(false);
    integrator_->initialize(state);
  }

  BodyState body(std::size_t k) const override {
    const SimTK::State& now = integrator_->getState();
    const Vec3 place = blocks_[k].getQ(now), motion = blocks_[k].getU(now);
    return {place[1], place[2], motion[1], motion[2], -place[0], -motion[0]};
  }

  std::vector<ContactPoint> contacts() const override {
    const SimTK::State& state = integrator_->getState();
    system_.realize(state, SimTK::Stage::Dynamics);
    std::vector<ContactPoint> points;
    const SimTK::ContactSnapshot& touching = tracker_.getActiveContacts(state);
    for (int i = 0; i < touching.getNumContacts(); ++i) {
      const SimTK::Contact& contact = touching.getContact(i);
      const int one = tracker_.getMobilizedBody(contact.getSurface1()).getMobilizedBodyIndex();
      const int other = tracker_.getMobilizedBody(contact.getSurface2()).getMobilizedBodyIndex();
      const int upper = std::max(one, other);
      const std::size_t interface = static_cast<std::size_t>(upper - blocks_.front().getMobilizedBodyIndex());
      SimTK::ContactPatch patch;
      contact_.calcContactPatchDetailsById(state, contact.getContactId(), patch);
      for (int k = 0; k < patch.getNumDetails(); ++k)
        points.push_back(point_of(patch.getContactDetail(k), interface, other > one ? 1 : -1));
    }
    return points;
  }

 private:
  void set_gravity(const BodyAcceleration& acceleration) override {
    gravity_.setGravityVector(integrator_->updAdvancedState(), Vec3(acceleration.x, acceleration.y, 0));
  }

  /// Coordinates are the angle, anticlockwise, and those of the centre of mass.
  void apply_load(std::size_t k, const BodyLoad& load) override {
    SimTK::State& state = integrator_->updAdvancedState();
    for (const auto& [coordinate, force] : {std::pair{0, -load.moment}, {1, load.x}, {2, load.y}})
      loads_.setOneMobilityForce(state, blocks_[k], SimTK::MobilizerUIndex(coordinate), force);
  }

  void advance() override {
    const double time = static_cast<double>(steps()) * dt();
    while (integrator_->getTime() < time) integrator_->stepTo(time);
  }

  /// At each interface the block with the narrower face is a brick and the other body a half space. Surfaces
  /// that share a clique never touch: no brick meets a brick, a half space that of its interface alone.
  void add_contacts(const Setup& setup, std::vector<SimTK::Body>& bodies) {
    const std::size_t count = setup.blocks.size();
    std::vector<SimTK::ContactCliqueId> cliques;
    const auto all = SimTK::ContactSurface::createNewContactClique();
    for (std::size_t k = 0; k < count; ++k)
      cliques.push_back(SimTK::ContactSurface::createNewContactClique());
    for (std::size_t k = 0; k < count; ++k) {
      const Placement& above = setup.blocks[k];
      const bool narrower_below = k > 0 && setup.blocks[k - 1].width < above.width;
      const Placement& narrow = narrower_below ? setup.blocks[k - 1] : above;
      const double face = k > 0 ? setup.blocks[k - 1].height / 2 + middle_of(setup.blocks[k - 1])[1] : 0;
      const SimTK::ContactMaterial material(stiffness_, dissipation_, setup.friction[k],
                                            kinetic_friction_of(setup)[k]);
      SimTK::ContactSurface plane(SimTK::ContactGeometry::HalfSpace(), material);
      plane.joinClique(cliques[k]);
      SimTK::ContactSurface brick(
          SimTK::ContactGeometry::Brick(Vec3(narrow.width, narrow.height, narrow.depth) / 2), material);
      brick.joinClique(all);
      for (std::size_t other = 0; other < count; ++other)
        if (other != k) brick.joinClique(cliques[other]);
      bodies[narrower_below ? k : k + 1].addContactSurface(middle_of(narrow), brick);
      bodies[narrower_below ? k + 1 : k].addContactSurface(
          narrower_below ? face_at(middle_of(above)[1] - above.height / 2, true) : face_at(face, false),
          plane);
    }
  }

  /// `on_upper`: 1 where the upper body has the contact's second surface, −1 where it has the first.
  ContactPoint point_of(const SimTK::ContactDetail& detail, std::size_t interface, double on_upper) const {
    const Vec3 place =
        blocks_[interface].findStationAtGroundPoint(integrator_->getState(), detail.getContactPoint());
    const Vec3& force = detail.getForceOnSurface2();
    const double push = std::abs(SimTK::dot(force, detail.getContactNormal()));
    ContactPoint point;
    point.interface = interface;
    point.along = place[0];
    point.gap = -detail.getDeformation();
    point.gap_before = point.gap + dt() * detail.getDeformationRate();
    point.normal = dt() * push / mass_factor_;
    point.tangential = dt() * std::sqrt(std::max(0.0, SimTK::dot(force, force) - push * push)) / mass_factor_;
    point.impulse_x = on_upper * dt() * force[0] / mass_factor_;
    point.impulse_y = on_upper * dt() * force[1] / mass_factor_;
    point.stiffness = stiffness_ / 2 / mass_factor_;
    point.damping = point.stiffness * dissipation_ * detail.getDeformation();
    return point;
  }

  double stiffness_, dissipation_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::ContactTrackerSubsystem tracker_{system_};
  SimTK::CompliantContactSubsystem contact_{system_, tracker_};
  SimTK::Force::Gravity gravity_;
  SimTK::Force::DiscreteForces loads_;
  std::vector<SimTK::MobilizedBody::Planar> blocks_;
  std::unique_ptr<SimTK::Integrator> integrator_;
};

}  // namespace

std::unique_ptr<Simulation> start_simbody(const Setup& setup, const Parameters& parameters) {
  return std::make_unique<SimbodySimulation>(setup, parameters);
}

}  // namespace rockstack
