#include "engines/simbody/world.hpp"

#include <Simbody.h>

#include <algorithm>
#include <cmath>

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

SimTK::Body::Rigid body_of(const Placement& block, double mass_factor) {
  return SimTK::Body::Rigid(
      SimTK::MassProperties(mass_factor * block.mass, Vec3(0), mass_factor * SimTK::Inertia(block.inertia)));
}

/// A half space whose face is at the height y of its body, which lies below or above that.
SimTK::Transform face_at(double y, bool body_above) {
  return {SimTK::Rotation(SimTK::UnitVec3(0, body_above ? 1 : -1, 0), SimTK::XAxis), Vec3(0, y, 0)};
}

}  // namespace

struct SimbodyWorld::Content {
  Content(const Setup& setup, const Parameters& parameters);
  void add_contacts(const Setup& setup, const Parameters& parameters, std::vector<SimTK::Body>& bodies);
  ContactPoint point_of(const SimTK::ContactDetail& detail, std::size_t interface) const;

  double dt, mass_factor, stiffness, dissipation;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  SimTK::ContactTrackerSubsystem tracker{system};
  SimTK::CompliantContactSubsystem contact{system, tracker};
  SimTK::Force::Gravity gravity;
  std::vector<SimTK::MobilizedBody::Planar> blocks;
  std::unique_ptr<SimTK::Integrator> integrator;
};

SimbodyWorld::Content::Content(const Setup& setup, const Parameters& parameters)
    : dt(setup.dt),
      mass_factor(rockstack::mass_factor(setup, parameters)),
      stiffness(parameters.at("stiffness")),
      dissipation(parameters.at("dissipation")),
      gravity(forces, matter, Vec3(setup.gravity.x, setup.gravity.y, 0)) {
  contact.setTransitionVelocity(parameters.at("transition_velocity"));
  std::vector<SimTK::Body> bodies{matter.Ground().getBody()};
  for (const Placement& block : setup.blocks) bodies.push_back(body_of(block, mass_factor));
  add_contacts(setup, parameters, bodies);
  matter.Ground().updBody() = bodies[0];
  for (std::size_t k = 0; k < setup.blocks.size(); ++k) blocks.emplace_back(matter.Ground(), bodies[k + 1]);
  SimTK::State state = system.realizeTopology();
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const Placement& block = setup.blocks[k];
    blocks[k].setQ(state, Vec3(-block.angle, block.x, block.y));
    blocks[k].setU(state, Vec3(-block.angular_velocity, block.velocity_x, block.velocity_y));
  }
  integrator = make_integrator(parameters.at("integrator"), system);
  integrator->setAccuracy(parameters.at("accuracy"));
  integrator->setAllowInterpolation(false);
  integrator->initialize(state);
}

/// At each interface the block with the narrower face is a brick and the other body a half space. Surfaces
/// that share a clique never touch: so no brick meets a brick, and a half space meets that of its interface
/// alone.
void SimbodyWorld::Content::add_contacts(const Setup& setup, const Parameters& parameters,
                                         std::vector<SimTK::Body>& bodies) {
  const std::size_t count = setup.blocks.size();
  std::vector<SimTK::ContactCliqueId> cliques;
  const auto all = SimTK::ContactSurface::createNewContactClique();
  for (std::size_t k = 0; k < count; ++k) cliques.push_back(SimTK::ContactSurface::createNewContactClique());
  for (std::size_t k = 0; k < count; ++k) {
    const Placement& above = setup.blocks[k];
    const bool narrower_below = k > 0 && setup.blocks[k - 1].width < above.width;
    const Placement& narrow = narrower_below ? setup.blocks[k - 1] : above;
    const double face = k > 0 ? setup.blocks[k - 1].height / 2 : 0;
    const double friction = setup.friction[k];
    const SimTK::ContactMaterial material(parameters.at("stiffness"), dissipation, friction, friction);
    SimTK::ContactSurface plane(SimTK::ContactGeometry::HalfSpace(), material);
    plane.joinClique(cliques[k]);
    SimTK::ContactSurface brick(
        SimTK::ContactGeometry::Brick(Vec3(narrow.width, narrow.height, narrow.depth) / 2), material);
    brick.joinClique(all);
    for (std::size_t other = 0; other < count; ++other) {
      if (other != k) brick.joinClique(cliques[other]);
    }
    bodies[narrower_below ? k : k + 1].addContactSurface(SimTK::Transform(), brick);
    bodies[narrower_below ? k + 1 : k].addContactSurface(
        narrower_below ? face_at(-above.height / 2, true) : face_at(face, false), plane);
  }
}

ContactPoint SimbodyWorld::Content::point_of(const SimTK::ContactDetail& detail,
                                             std::size_t interface) const {
  const Vec3 place =
      blocks[interface].findStationAtGroundPoint(integrator->getState(), detail.getContactPoint());
  const double push = std::abs(SimTK::dot(detail.getForceOnSurface2(), detail.getContactNormal()));
  ContactPoint point;
  point.interface = interface;
  point.along = place[0];
  point.gap = -detail.getDeformation();
  point.gap_before = point.gap + dt * detail.getDeformationRate();
  point.normal = dt * push / mass_factor;
  point.tangential =
      dt *
      std::sqrt(
          std::max(0.0, SimTK::dot(detail.getForceOnSurface2(), detail.getForceOnSurface2()) - push * push)) /
      mass_factor;
  point.stiffness = stiffness / 2 / mass_factor;
  point.damping = point.stiffness * dissipation * detail.getDeformation();
  return point;
}

SimbodyWorld::SimbodyWorld(const Setup& setup, const Parameters& parameters)
    : content_(std::make_unique<Content>(setup, parameters)) {}

SimbodyWorld::~SimbodyWorld() = default;

void SimbodyWorld::step(const ShakingStep& shaking) {
  if (shaking.acceleration) {
    content_->gravity.setGravityVector(content_->integrator->updAdvancedState(),
                                       Vec3(shaking.acceleration->x, shaking.acceleration->y, 0));
  }
  const double time = static_cast<double>(++steps_) * content_->dt;
  while (content_->integrator->getTime() < time) content_->integrator->stepTo(time);
}

PlanarState SimbodyWorld::block(std::size_t k) const {
  const SimTK::State& state = content_->integrator->getState();
  const Vec3 place = content_->blocks[k].getQ(state), motion = content_->blocks[k].getU(state);
  return {place[1], place[2], place[0], motion[1], motion[2], motion[0]};
}

std::vector<ContactPoint> SimbodyWorld::contacts() const {
  const SimTK::State& state = content_->integrator->getState();
  content_->system.realize(state, SimTK::Stage::Dynamics);
  std::vector<ContactPoint> points;
  const SimTK::ContactSnapshot& touching = content_->tracker.getActiveContacts(state);
  for (int i = 0; i < touching.getNumContacts(); ++i) {
    const SimTK::Contact& contact = touching.getContact(i);
    const int upper =
        std::max(content_->tracker.getMobilizedBody(contact.getSurface1()).getMobilizedBodyIndex(),
                 content_->tracker.getMobilizedBody(contact.getSurface2()).getMobilizedBodyIndex());
    const std::size_t interface =
        static_cast<std::size_t>(upper - content_->blocks.front().getMobilizedBodyIndex());
    SimTK::ContactPatch patch;
    content_->contact.calcContactPatchDetailsById(state, contact.getContactId(), patch);
    for (int k = 0; k < patch.getNumDetails(); ++k)
      points.push_back(content_->point_of(patch.getContactDetail(k), interface));
  }
  return points;
}

}  // namespace rockstack
