// The Open Dynamics Engine beside the exact model: what is set, and why.
//
// The same in both sets, as the question asks for it: each body in a planar joint, no auto-disable, no
// damping, no bounce. realign = 1 puts velocities and rotations back into the plane after every step, which
// the planar joint leaves to the user; its time counts. maxContacts = 8 is what dCollide may return for a
// pair (a box gives 4). contactApprox1 = 1 makes the scene's friction a coefficient; without it ODE takes the
// number as a force limit. ODE reports errors through handlers: an error throws from the call; a message (the
// solver's "s <= 0": it goes on with a step half solved) is counted as a warning, and the run goes on as it
// does for a user, who sees it printed. Which stacks bring it about follows no plain rule. In
// columns of 2 to 8 equal blocks that stand for 0.2 s, upright or turned by 1e-9 rad, at steps of 1e-2 to
// 1e-4 s and in both sets: blocks of 0.5 m × 1.2 m, at most once; of 1 m × 0.6 m, up to 29 times; of 1 m × 1
// m, from two on, never to at every step. In rocking columns of eight: in 9 steps of 30000 at most.
//
// Measured: Spanos et al. 2001's free rocking (both blocks released at 0.15 rad). "impact" is the first
// ground impact's error against the event-driven 0.60565 s in steps, "peak" the error of the second peak of
// the top block against 0.2008 rad, "cost" in µs a step. A free fall under semi-implicit Euler runs dt/2
// ahead, so −0.50 is the scheme's own impact. Where a cell is empty nothing was measured.
//
// clang-format off
//                            dt = 1e-2 s      1e-3 s           1e-4 s           1e-5 s
//                           impact  peak    impact  peak     impact  peak     impact  peak    cost
//   defaults (erp = 0.2)    -2.15 -0.0335   -0.58 +0.0043    -0.57 -0.0017    -0.72 -0.0006   4.8
//   erp = 0                                 -0.51 -0.0043    -0.52 +0.0012                    5.1
//   erp = 0.5                               -1.58 -0.0015    -1.85 -0.0063                    4.6
//   erp = 1                                -14.21 -0.0281   -15.82 -0.0331                    3.4
//   max correcting 0.01 m/s                 -0.58 +0.0015    -0.57 -0.0008                    4.8
//   maxContacts = 2                         -1.38 -0.0057    -1.39 -0.0189                    3.7
//   cfm = 0                 the solver fails in the second step
//   contactApprox1 = 0      the solver fails after 1.45 s (1e-3), 0.02 s (1e-4)
//   contactMu2 = 1                          -0.58 +0.0043    -0.57 -0.0017                    3.5
//     and erp = 0.1         -1.44 -0.0130   -0.79 -0.0058    -1.37 -0.0020                    3.5
//     and erp = 0.05        +0.19 -0.0342   -0.52 +0.0032    -0.55 +0.0008    -0.71 -0.0000   3.6
//     and erp = 0.03        -0.52 +0.0117   -0.35 +0.0026    -0.54 +0.0001                    3.6
//     and erp = 0.02        -0.49 -0.0082   -0.53 +0.0003    -0.54 -0.0001    -0.71 +0.0001   3.6
//     and erp = 0.01        -0.25 -0.0083   -0.53 +0.0000    -0.54 +0.0001    -0.70 +0.0001   3.6   tuned
//     and erp = 0.003       -0.35 -0.0081   -0.73 -0.0025    -0.55 +0.0002                    3.7
//   tuned, cfm = 1e-8                       -0.59 +0.0002    -1.18 -0.0015    -6.96 -0.0002   3.6
//   tuned, cfm = 1e-9                       -1.08 -0.0028    -0.57 +0.0007    -1.28 +0.0011   3.6
//   tuned, cfm = 1e-12                      -1.08 -0.0002    -0.54 +0.0002    -0.88 +0.0000   3.5
// clang-format on
//
// Tuned: erp = 0.01, because ODE corrects overlap through the velocities, which feeds energy in as erp grows,
// and with none an overlap stays; 0.01 to 0.02 serve alike. A single block hardly feels it: from erp = 0.001
// to 0.2 its quarter period keeps to 0.003 of a step, its velocity ratio to 0.001. contactMu2 = 1 gives
// contacts no friction across the plane, where nothing moves: the same digits with a third fewer rows.

#include "engines/ode/ode.hpp"

#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engines/parameters.hpp"
#include "engines/placement.hpp"

namespace rockstack {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

constexpr std::array settings{
    Setting{"erp", 0.2, 0.01, 0, 1},
    Setting{"cfm", 1e-10, 1e-10, 0, endless},
    Setting{"contactSurfaceLayer", 0, 0, 0, endless},
    Setting{"contactMaxCorrectingVel", endless, endless, 0, endless},
    Setting{"maxContacts", 8, 8, 1, 64, true},
    Setting{"contactApprox1", 1, 1, 0, 1, true},
    Setting{"contactMu2", 0, 1, 0, 1, true},
    Setting{"finiteRotationMode", 0, 0, 0, 1, true},
    Setting{"realign", 1, 1, 0, 1, true},
};

/// How many messages ODE has given on this thread.
std::size_t& messages() {
  thread_local std::size_t count = 0;
  return count;
}

std::string text_of(const char* format, std::va_list arguments) {
  std::array<char, 512> buffer{};
  std::vsnprintf(buffer.data(), buffer.size(), format, arguments);
  return buffer.data();
}

/// ODE ends the process when this returns, so it must throw.
void stop(int number, const char* format, std::va_list arguments) {
  throw std::runtime_error(fmt::format("ode: error {}: {}", number, text_of(format, arguments)));
}

/// ODE goes on with what its solver has so far.
void note(int, const char*, std::va_list) {
  ++messages();
}

void initialise() {
  static const bool ready = [] {
    dSetErrorHandler(stop);
    dSetDebugHandler(stop);
    dSetMessageHandler(note);
    return dInitODE2(0) != 0;
  }();
  if (!ready || dAllocateODEDataForThread(dAllocateMaskAll) == 0) {
    throw std::runtime_error("ode: the library could not be initialised");
  }
}

struct Destroy {
  void operator()(dWorldID world) const { dWorldDestroy(world); }
  void operator()(dSpaceID space) const { dSpaceDestroy(space); }
  void operator()(dJointGroupID group) const { dJointGroupDestroy(group); }
};

double angle_of(dBodyID body) {
  const dReal* turn = dBodyGetRotation(body);
  return std::atan2(-turn[4], turn[0]);
}

class OdeSimulation : public Simulation {
 public:
  OdeSimulation(Scene scene, double dt, const Parameters& parameters)
      : scene_(std::move(scene)),
        dt_(dt),
        contacts_(static_cast<std::size_t>(parameters.at("maxContacts"))),
        realign_(parameters.at("realign") != 0),
        world_(dWorldCreate()),
        space_(dSimpleSpaceCreate(nullptr)),
        group_(dJointGroupCreate(0)) {
    dWorldSetERP(world_.get(), parameters.at("erp"));
    dWorldSetCFM(world_.get(), parameters.at("cfm"));
    dWorldSetContactSurfaceLayer(world_.get(), parameters.at("contactSurfaceLayer"));
    dWorldSetContactMaxCorrectingVel(world_.get(), parameters.at("contactMaxCorrectingVel"));
    set_gravity({0, -scene_.gravity});
    set_surface(parameters);
    dCreatePlane(space_.get(), 0, 1, 0, 0);
    for (const Placement& placement : place(scene_))
      add_block(placement, parameters.at("finiteRotationMode") != 0);
  }

  void step() override {
    if (is_shaken(scene_)) {
      const double start = static_cast<double>(steps_) * dt_;
      set_gravity(body_acceleration(scene_, start, static_cast<double>(steps_ + 1) * dt_));
    }
    const std::size_t before = messages();
    dJointGroupEmpty(group_.get());
    dSpaceCollide(space_.get(), this, &OdeSimulation::touch);
    if (dWorldStep(world_.get(), dt_) == 0) throw std::runtime_error("ode: a step ran out of memory");
    ++steps_;
    warnings_ += messages() - before;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      if (realign_) realign(bodies_[k]);
      angles_[k] = unwrap(angle_of(bodies_[k]), angles_[k]);
    }
  }

  void read(std::span<double> angles, std::span<double> velocities) const override {
    std::copy(angles_.begin(), angles_.end(), angles.begin());
    for (std::size_t k = 0; k < bodies_.size(); ++k) velocities[k] = -dBodyGetAngularVel(bodies_[k])[2];
  }

  std::size_t warnings() const override { return warnings_; }

 private:
  static void touch(void* data, dGeomID one, dGeomID other) {
    static_cast<OdeSimulation*>(data)->add_contacts(one, other);
  }

  void add_contacts(dGeomID one, dGeomID other) {
    const int count =
        dCollide(one, other, static_cast<int>(contacts_.size()), &contacts_.front().geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
      dContact& contact = contacts_[static_cast<std::size_t>(i)];
      contact.fdir1[0] = contact.geom.normal[1];
      contact.fdir1[1] = -contact.geom.normal[0];
      const dJointID joint = dJointCreateContact(world_.get(), group_.get(), &contact);
      dJointAttach(joint, dGeomGetBody(one), dGeomGetBody(other));
    }
  }

  void set_surface(const Parameters& parameters) {
    for (dContact& contact : contacts_) {
      contact.surface.mu = scene_.engine.friction;
      if (parameters.at("contactApprox1") != 0) contact.surface.mode |= dContactApprox1;
      if (parameters.at("contactMu2") != 0) contact.surface.mode |= dContactFDir1 | dContactMu2;
    }
  }

  void set_gravity(const BodyAcceleration& acceleration) {
    dWorldSetGravity(world_.get(), acceleration.x, acceleration.y, 0);
  }

  void add_block(const Placement& placement, bool finite) {
    const dBodyID body = dBodyCreate(world_.get());
    dMass mass;
    dMassSetParameters(&mass, placement.mass, 0, 0, 0, placement.inertia_about_x, placement.inertia_about_y,
                       placement.inertia, 0, 0, 0);
    dBodySetMass(body, &mass);
    const dGeomID box = dCreateBox(space_.get(), placement.width, placement.height, placement.depth);
    dGeomSetBody(box, body);
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
    const dReal* spin = dBodyGetAngularVel(body);
    dBodySetAngularVel(body, 0, 0, spin[2]);
    const dReal* now = dBodyGetQuaternion(body);
    const double length = std::hypot(now[0], now[3]);
    const dQuaternion planar{now[0] / length, 0, 0, now[3] / length};
    dBodySetQuaternion(body, planar);
  }

  Scene scene_;
  double dt_;
  std::size_t steps_ = 0;
  std::size_t warnings_ = 0;
  std::vector<double> angles_;
  std::vector<dContact> contacts_;
  bool realign_;
  std::vector<dBodyID> bodies_;
  std::unique_ptr<dxWorld, Destroy> world_;
  std::unique_ptr<dxSpace, Destroy> space_;
  std::unique_ptr<dxJointGroup, Destroy> group_;
};

class Ode : public Engine {
 public:
  std::string name() const override { return "ode"; }
  std::string solver() const override { return "step"; }
  std::string version() const override { return dODE_VERSION ", double precision"; }
  Parameters default_parameters() const override { return standard_values(settings); }
  Parameters tuned_parameters() const override { return tuned_values(settings); }
  std::unique_ptr<Simulation> start(const Scene& scene, double dt,
                                    const Parameters& parameters) const override {
    check(name(), settings, parameters, dt);
    initialise();
    return std::make_unique<OdeSimulation>(scene, dt, parameters);
  }
};

}  // namespace

std::unique_ptr<Engine> make_ode() {
  return std::make_unique<Ode>();
}

}  // namespace rockstack
