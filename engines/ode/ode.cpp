// ODE beside the exact model; README.md says what its contacts are and why its sets are as they are.

#include <fmt/format.h>
#include <ode/ode.h>

#include <cstdarg>
#include <cstdio>
#include <deque>
#include <stdexcept>

#include "analytic/scene/lists.hpp"
#include "engines/engine.hpp"

namespace rockstack {
namespace {

enum class OdeSolver { step, quickstep };

/// How many messages ODE has given on this thread.
thread_local std::size_t messages = 0;

/// ODE ends the process when this returns, so it must throw.
void stop(int number, const char* format, std::va_list arguments) {
  std::array<char, 512> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  throw std::runtime_error(fmt::format("ode: error {}: {}", number, text.data()));
}

/// Makes ODE ready on this thread. After a message it goes on with what its solver has so far.
void initialise() {
  static const bool ready = [] {
    dSetErrorHandler(stop);
    dSetDebugHandler(stop);
    dSetMessageHandler([](int, const char*, std::va_list) { ++messages; });
    return dInitODE2(0) != 0;
  }();
  if (!ready || dAllocateODEDataForThread(dAllocateMaskAll) == 0)
    throw std::runtime_error("ode: the library could not be initialised");
}

/// A contact of the step under way, where they are watched.
struct Touch {
  dContactGeom geom;
  dBodyID first, second;             ///< the normal points from the second to the first
  dVector3 on_first{}, on_second{};  ///< the point in their axes
  dJointFeedback feedback{};
};

/// A point of a body in the world; one that has no body does not move.
double height_along(const dReal* normal, dBodyID body, const dReal* point, const dReal* start) {
  dVector3 place{start[0], start[1], start[2]};
  if (body != nullptr) dBodyGetRelPointPos(body, point[0], point[1], point[2], place);
  return dCalcVectorDot3(normal, place);
}

class OdeSimulation final : public ShakenSimulation {
 public:
  OdeSimulation(OdeSolver solver, const Setup& setup, const Parameters& parameters)
      : ShakenSimulation(setup, mass_factor(setup, parameters)),
        solver_(solver),
        contacts_(static_cast<std::size_t>(parameters.at("maxContacts"))),
        realign_(parameters.at("realign") != 0) {
    dWorldSetERP(world_.get(), parameters.at("erp"));
    dWorldSetCFM(world_.get(), parameters.at("cfm"));
    dWorldSetContactSurfaceLayer(world_.get(), parameters.at("contactSurfaceLayer"));
    dWorldSetContactMaxCorrectingVel(world_.get(), parameters.at("contactMaxCorrectingVel"));
    if (solver_ == OdeSolver::quickstep) {
      dWorldSetQuickStepNumIterations(world_.get(),
                                      static_cast<int>(parameters.at("quickStepNumIterations")));
      dWorldSetQuickStepW(world_.get(), parameters.at("quickStepW"));
      // The solver takes its rows in random order.
      dRandSetSeed(static_cast<unsigned long>(parameters.at("randomSeed")));
    }
    set_gravity(setup.gravity);
    set_surface(setup, parameters);
    plane_ = dCreatePlane(space_.get(), 0, 1, 0, 0);
    if (moves_ground()) {  // a plane has no body of its own in ODE: its contacts are those of this one
      ground_ = dBodyCreate(world_.get());
      dBodySetKinematic(ground_);
    }
    if (setup.wall) add_wall(*setup.wall);
    for (const Placement& placement : setup.blocks)
      add_block(placement, parameters.at("finiteRotationMode") != 0);
  }

  BodyState body(std::size_t k) const override {
    const dReal *place = dBodyGetPosition(bodies_[k]), *velocity = dBodyGetLinearVel(bodies_[k]);
    const dReal* turn = dBodyGetRotation(bodies_[k]);
    return {place[0],    place[1],
            velocity[0], velocity[1],
            angles_[k],  -dBodyGetAngularVel(bodies_[k])[2],
            place[2],    std::hypot(turn[2], turn[6])};
  }

  std::size_t warnings() const override { return warnings_; }

  std::vector<ContactPoint> contacts() const override {
    return mapped(touches_, [this](const Touch& touch) { return point_of(touch); });
  }

 private:
  void add_contacts(dGeomID one, dGeomID other) {
    const dBodyID first = body_of(one), second = body_of(other);
    if (first == second) return;  // a wall on the ground
    const int count =
        dCollide(one, other, static_cast<int>(contacts_.size()), &contacts_.front().geom, sizeof(dContact));
    if (count == 0) return;
    const double limit = friction_limits_[std::max(number_of(first), number_of(second)) - 1];
    for (int i = 0; i < count; ++i) {
      dContact& contact = contacts_[static_cast<std::size_t>(i)];
      contact.surface.mu = limit;
      contact.fdir1[0] = contact.geom.normal[1];
      contact.fdir1[1] = -contact.geom.normal[0];
      const dJointID joint = dJointCreateContact(world_.get(), group_.get(), &contact);
      dJointAttach(joint, first, second);
      if (!watches_contacts()) continue;
      Touch& touch = touches_.emplace_back(Touch{contact.geom, first, second});
      const dReal* place = contact.geom.pos;
      if (first != nullptr) dBodyGetPosRelPoint(first, place[0], place[1], place[2], touch.on_first);
      if (second != nullptr) dBodyGetPosRelPoint(second, place[0], place[1], place[2], touch.on_second);
      dJointSetFeedback(joint, &touch.feedback);
    }
  }

  /// From 1, bottom to top; 0 is the ground.
  std::size_t number_of(dBodyID body) const {
    const auto found = std::ranges::find(bodies_, body);
    return found == bodies_.end() ? 0 : static_cast<std::size_t>(found - bodies_.begin()) + 1;
  }

  ContactPoint point_of(const Touch& touch) const {
    const auto first = number_of(touch.first), second = number_of(touch.second);
    const dReal *normal = touch.geom.normal, *force = touch.feedback.f1;
    const double push = dCalcVectorDot3(force, normal);
    const double impulse = dt() / mass_factor_, on_upper = first > second ? impulse : -impulse;
    return {.interface = std::max(first, second) - 1,
            .along = (first > second ? touch.on_first : touch.on_second)[0],
            .gap_before = -touch.geom.depth,
            .gap = -touch.geom.depth + height_along(normal, touch.first, touch.on_first, touch.geom.pos) -
                   height_along(normal, touch.second, touch.on_second, touch.geom.pos),
            .normal = impulse * std::abs(push),
            .tangential = impulse * std::hypot(force[0] - push * normal[0], force[1] - push * normal[1],
                                               force[2] - push * normal[2]),
            .impulse_x = on_upper * force[0],
            .impulse_y = on_upper * force[1],
            .stiffness = stiffness_ / mass_factor_,
            .damping = damping_ / mass_factor_};
  }

  /// With contactApprox1 ODE's friction is a coefficient; without it a force, here that of the whole weight.
  void set_surface(const Setup& setup, const Parameters& parameters) {
    const bool coefficient = parameters.at("contactApprox1") != 0;
    double weight = 0;
    for (const Placement& placement : setup.blocks)
      weight += mass_factor_ * placement.mass * std::hypot(setup.gravity.x, setup.gravity.y);
    const double stiffness = mass_factor_ * parameters.at("contactStiffness");
    const double damping = mass_factor_ * parameters.at("contactDamping");
    const double erp = parameters.at("erp"), cfm = parameters.at("cfm");
    stiffness_ = stiffness != 0 ? stiffness : contact_stiffness(erp, cfm, dt());
    damping_ = stiffness != 0 ? damping : contact_damping(erp, cfm);
    // A contact is a spring only where all of its overlap counts, and at any speed.
    if (parameters.at("contactSurfaceLayer") > 0 || std::isfinite(parameters.at("contactMaxCorrectingVel")))
      stiffness_ = std::numeric_limits<double>::infinity();
    friction_limits_ = setup.friction;
    for (double& limit : friction_limits_) limit *= coefficient ? 1 : weight;
    for (dContact& contact : contacts_) {
      if (coefficient) contact.surface.mode |= dContactApprox1;
      if (parameters.at("bounce") != 0) contact.surface.mode |= dContactBounce;
      contact.surface.bounce = parameters.at("bounce");
      contact.surface.bounce_vel = parameters.at("bounce_vel");
      if (parameters.at("contactMu2") != 0) contact.surface.mode |= dContactFDir1 | dContactMu2;
      if (parameters.at("slip1") != 0) contact.surface.mode |= dContactSlip1;
      contact.surface.slip1 = parameters.at("slip1") / mass_factor_;
      if (stiffness == 0 && damping == 0) continue;
      const double impulse = dt() * stiffness + damping;
      contact.surface.mode |= dContactSoftERP | dContactSoftCFM;
      contact.surface.soft_erp = dt() * stiffness / impulse;
      contact.surface.soft_cfm = 1 / impulse;
    }
  }

  dBodyID body_of(dGeomID geometry) const {
    return geometry == plane_ || geometry == wall_ ? ground_ : dGeomGetBody(geometry);
  }

  void place_ground(const GroundStep& step) override {
    dBodySetPosition(ground_, step.x, step.y, 0);
    dBodySetLinearVel(ground_, step.velocity_x, step.velocity_y, 0);
    dGeomPlaneSetParams(plane_, 0, 1, 0, step.y);
    if (wall_ != nullptr) dGeomSetPosition(wall_, wall_start_.x + step.x, wall_start_.y + step.y, 0);
  }

  /// A wall is the ground's, as the plane is.
  void add_wall(const FixedBox& wall) {
    wall_start_ = wall;
    wall_ = dCreateBox(space_.get(), wall.width, wall.height, wall.depth);
    dGeomSetPosition(wall_, wall.x, wall.y, 0);
  }

  void advance() override {
    const auto solve = solver_ == OdeSolver::step ? dWorldStep : dWorldQuickStep;
    const std::size_t before = messages;
    dJointGroupEmpty(group_.get());
    touches_.clear();
    dSpaceCollide(space_.get(), this, [](void* self, dGeomID one, dGeomID other) {
      static_cast<OdeSimulation*>(self)->add_contacts(one, other);
    });
    if (solve(world_.get(), dt()) == 0) throw std::runtime_error("ode: a step ran out of memory");
    warnings_ += messages - before;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      if (realign_) realign(bodies_[k]);
      const dReal* turn = dBodyGetRotation(bodies_[k]);
      angles_[k] = unwrap(std::atan2(-turn[4], turn[0]), angles_[k]);
    }
  }

  void set_gravity(const BodyAcceleration& acceleration) override {
    dWorldSetGravity(world_.get(), acceleration.x, acceleration.y, 0);
  }

  void apply_load(std::size_t k, const BodyLoad& load) override {
    dBodyAddForce(bodies_[k], load.x, load.y, 0);
    dBodyAddTorque(bodies_[k], 0, 0, -load.moment);
  }

  void add_block(const Placement& placement, bool finite) {
    const dBodyID body = dBodyCreate(world_.get());
    dMass mass;
    dMassSetParameters(&mass, mass_factor_ * placement.mass, 0, 0, 0,
                       mass_factor_ * placement.inertia_about_x, mass_factor_ * placement.inertia_about_y,
                       mass_factor_ * placement.inertia, 0, 0, 0);
    dBodySetMass(body, &mass);
    const dGeomID box = dCreateBox(space_.get(), placement.width, placement.height, placement.depth);
    dGeomSetBody(box, body);
    if (is_eccentric(placement)) dGeomSetOffsetPosition(box, -placement.offset_x, -placement.offset_y, 0);
    dMatrix3 turn;
    dRFromAxisAndAngle(turn, 0, 0, 1, -placement.angle);
    dBodySetRotation(body, turn);
    dBodySetPosition(body, placement.x, placement.y, 0);
    dBodySetLinearVel(body, placement.velocity_x, placement.velocity_y, 0);
    dBodySetAngularVel(body, 0, 0, -placement.angular_velocity);
    dBodySetFiniteRotationMode(body, finite);
    dJointAttach(dJointCreatePlane2D(world_.get(), nullptr), body, nullptr);
    bodies_.push_back(body);
    angles_.push_back(placement.angle);
  }

  /// The planar joint holds positions only; the rotation is put back into the plane by hand.
  static void realign(dBodyID body) {
    dBodySetAngularVel(body, 0, 0, dBodyGetAngularVel(body)[2]);
    const dReal* now = dBodyGetQuaternion(body);
    const double length = std::hypot(now[0], now[3]);
    const dQuaternion planar{now[0] / length, 0, 0, now[3] / length};
    dBodySetQuaternion(body, planar);
  }

  OdeSolver solver_;
  std::size_t warnings_ = 0;
  std::vector<double> angles_;
  std::vector<dContact> contacts_;
  std::vector<double> friction_limits_;  ///< of interfaces: coefficients, or N in the library's own masses
  bool realign_;
  double stiffness_ = 0, damping_ = 0;  ///< of each contact point, in those masses
  std::deque<Touch> touches_;           ///< ODE writes into them while it steps
  dGeomID plane_ = nullptr;
  dGeomID wall_ = nullptr;  ///< where there is one
  FixedBox wall_start_;
  dBodyID ground_ = nullptr;  ///< where it really moves
  std::vector<dBodyID> bodies_;
  std::unique_ptr<dxWorld, void (*)(dWorldID)> world_{dWorldCreate(), dWorldDestroy};
  std::unique_ptr<dxSpace, void (*)(dSpaceID)> space_{dSimpleSpaceCreate(nullptr), dSpaceDestroy};
  std::unique_ptr<dxJointGroup, void (*)(dJointGroupID)> group_{dJointGroupCreate(0), dJointGroupDestroy};
};

std::vector<Setting> settings_of(OdeSolver solver) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  std::vector<Setting> settings{
      {.name = "erp", .default_value = 0.2, .tuned = 0.01, .most = 1},
      {.name = "cfm", .unit = "s/kg", .default_value = 1e-10, .tuned = 1e-6},
      {.name = "contactSurfaceLayer", .unit = "m"},
      {.name = "contactMaxCorrectingVel", .unit = "m/s", .default_value = endless},
      {.name = "maxContacts", .default_value = 8, .least = 1, .most = 64, .whole = true},
      switch_setting("contactApprox1", true, true),
      switch_setting("contactMu2", false, true),
      switch_setting("finiteRotationMode", false, false),
      {.name = "bounce", .most = 1, .role = SettingRole::restitution},
      {.name = "bounce_vel", .unit = "m/s", .role = SettingRole::restitution_threshold},
      {.name = "contactStiffness", .unit = "N/m", .most = stiffest},
      {.name = "contactDamping", .unit = "N s/m", .most = stiffest},
      {.name = "slip1", .unit = "m/(N s)"},
      {.name = "unitMass", .unit = "kg", .tuned = 1, .most = 1e12},
      switch_setting("realign", true, true),
      shaking_setting(),
  };
  if (solver == OdeSolver::quickstep) {
    settings.push_back(count_setting("quickStepNumIterations", 20, 100));
    settings.push_back({.name = "quickStepW", .default_value = 1.3, .most = 2});
    settings.push_back({.name = "randomSeed", .most = 4294967295.0, .whole = true});
  }
  return settings;
}

Engine with(OdeSolver solver) {
  return {{.name = "ode",
           .solver = solver == OdeSolver::step ? "step" : "quickstep",
           .version = dODE_VERSION ", double precision",
           .licence = "BSD-3-Clause OR LGPL-2.1-or-later",
           .capabilities = {.wall = true, .applied_forces = true, .center_of_mass = true},
           .settings = settings_of(solver)},
          [solver](const Setup& setup, const Parameters& parameters) {
            initialise();
            return std::make_unique<OdeSimulation>(solver, setup, parameters);
          }};
}

}  // namespace

std::vector<Engine> make_ode() {
  return {with(OdeSolver::step), with(OdeSolver::quickstep)};
}

}  // namespace rockstack
