// Chipmunk beside the exact model; README.md says what its contacts are and why its sets are as they are.

#include <chipmunk/chipmunk.h>
// Impulses of single contact points are told by the library here alone.
#include <chipmunk/chipmunk_structs.h>
#include <fmt/format.h>

#include <algorithm>

#include "engines/engine.hpp"

namespace rockstack {
namespace {

struct Destroy {
  void operator()(cpSpace* space) const { cpSpaceFree(space); }
  void operator()(cpBody* body) const { cpBodyFree(body); }
  void operator()(cpShape* shape) const { cpShapeFree(shape); }
};

/// A contact point of the step under way, where they are watched.
struct Touch {
  ContactPoint point;  ///< its impulses are those that the library remembers without applying them
  const cpArbiter* pair = nullptr;
  int number = 0;       ///< of the point among its pair's
  cpVect normal{0, 0};  ///< out of the lower body
};

class ChipmunkSimulation final : public ShakenSimulation {
 public:
  ChipmunkSimulation(const Setup& setup, const Parameters& parameters)
      : ShakenSimulation(setup), friction_(setup.friction), elasticity_(parameters.at("elasticity")) {
    cpSpaceSetIterations(space_.get(), static_cast<int>(parameters.at("iterations")));
    cpSpaceSetCollisionSlop(space_.get(), parameters.at("collisionSlop"));
    cpSpaceSetCollisionBias(space_.get(), parameters.at("collisionBias"));
    cpSpaceSetCollisionPersistence(space_.get(),
                                   static_cast<cpTimestamp>(parameters.at("collisionPersistence")));
    set_gravity(setup.gravity);
    cpCollisionHandler* handler = cpSpaceAddDefaultCollisionHandler(space_.get());
    // Called for a pair that touches, before the solver runs.
    handler->preSolveFunc = [](cpArbiter* pair, cpSpace*, cpDataPointer self) -> cpBool {
      static_cast<ChipmunkSimulation*>(self)->set_contact(pair);
      return cpTrue;
    };
    handler->userData = this;
    add_ground(ground_reach(setup.blocks));
    if (setup.wall) add_wall(*setup.wall);
    for (const Placement& placement : setup.blocks) add_block(placement);
  }

  BodyState body(std::size_t k) const override {
    const cpBody* block = bodies_[k + 1].get();
    const cpVect place = cpBodyGetPosition(block), velocity = cpBodyGetVelocity(block);
    return {
        place.x, place.y, velocity.x, velocity.y, -cpBodyGetAngle(block), -cpBodyGetAngularVelocity(block)};
  }

  std::vector<ContactPoint> contacts() const override {
    std::vector<ContactPoint> points;
    for (const Touch& touch : touches_) {
      const cpContact& solved = touch.pair->contacts[touch.number];
      ContactPoint& point = points.emplace_back(touch.point);
      point.normal = solved.jnAcc - point.normal;
      const double across = solved.jtAcc - point.tangential;
      point.tangential = std::abs(across);
      const cpVect impulse = cpvrotate(touch.normal, cpv(point.normal, across));
      point.impulse_x = impulse.x;
      point.impulse_y = impulse.y;
    }
    return points;
  }

 private:
  /// A pair's friction is that of the interface under its upper body; the library would take the product.
  void set_contact(cpArbiter* pair) {
    cpShape *shape = nullptr, *other = nullptr;
    cpArbiterGetShapes(pair, &shape, &other);
    // Bodies count from 0, the ground.
    const std::size_t a = cpShapeGetCollisionType(shape), b = cpShapeGetCollisionType(other);
    cpArbiterSetFriction(pair, friction_[std::max(a, b) - 1]);
    cpArbiterSetRestitution(pair, elasticity_);
    if (!watches_contacts()) return;
    const cpContactPointSet set = cpArbiterGetContactPointSet(pair);
    for (int i = 0; i < set.count; ++i) {
      const auto& found = set.points[i];
      Touch& touch = touches_.emplace_back(Touch{{}, pair, i, a > b ? cpvneg(set.normal) : set.normal});
      touch.point.interface = std::max(a, b) - 1;
      touch.point.along = a > b ? on_body(a, found.pointA).x : on_body(b, found.pointB).x;
      touch.point.gap_before =
          cpvdot(cpvsub(at_start(b, found.pointB), at_start(a, found.pointA)), set.normal);
      touch.point.gap = found.distance;
      if (cpArbiterIsFirstContact(pair) == 0) continue;
      touch.point.normal = pair->contacts[i].jnAcc;
      touch.point.tangential = pair->contacts[i].jtAcc;
    }
  }

  cpVect on_body(std::size_t number, cpVect point) const {
    return cpBodyWorldToLocal(bodies_[number].get(), point);
  }

  /// Where a point of a body was when the step began.
  cpVect at_start(std::size_t number, cpVect point) const {
    return cpTransformPoint(starts_[number], on_body(number, point));
  }

  void advance() override {
    if (watches_contacts()) {
      touches_.clear();
      starts_.clear();
      for (const auto& body : bodies_) starts_.push_back(body->transform);
    }
    cpSpaceStep(space_.get(), dt());
  }

  void set_gravity(const BodyAcceleration& acceleration) override {
    cpSpaceSetGravity(space_.get(), cpv(acceleration.x, acceleration.y));
  }

  void apply_load(std::size_t k, const BodyLoad& load) override {
    cpBodySetForce(bodies_[k + 1].get(), cpv(load.x, load.y));
    cpBodySetTorque(bodies_[k + 1].get(), -load.moment);
  }

  /// A segment without thickness; a body of its own, which can move.
  void add_ground(double reach) {
    cpBody* body = add_body(moves_ground() ? cpBodyNewKinematic() : cpBodyNewStatic());
    add_shape(cpSegmentShapeNew(body, cpv(-reach, 0), cpv(reach, 0), 0));
    if (!moves_ground()) return;
    cpBodySetUserData(body, this);
    // All bodies move before contacts are found: velocities are solved for the next step.
    cpBodySetVelocityUpdateFunc(body, [](cpBody* ground, cpVect, cpFloat, cpFloat) {
      const auto& self = *static_cast<const ChipmunkSimulation*>(cpBodyGetUserData(ground));
      if (const GroundStep* next = self.next_ground())
        cpBodySetVelocity(ground, cpv(next->velocity_x, next->velocity_y));
    });
  }

  /// A wall is a shape of the ground's body, whose number it has.
  void add_wall(const FixedBox& wall) {
    const cpBB box = cpBBNewForExtents(cpv(wall.x, wall.y), wall.width / 2, wall.height / 2);
    add_shape(cpBoxShapeNew2(bodies_.front().get(), box, 0));
  }

  void place_ground(const GroundStep& step) override {
    cpBodySetPosition(bodies_.front().get(), cpv(step.x, step.y));
    cpBodySetVelocity(bodies_.front().get(), cpv(step.velocity_x, step.velocity_y));
  }

  void add_block(const Placement& placement) {
    cpBody* body = add_body(cpBodyNew(placement.mass, placement.inertia));
    cpBodySetPosition(body, cpv(placement.x, placement.y));
    cpBodySetAngle(body, -placement.angle);
    cpBodySetVelocity(body, cpv(placement.velocity_x, placement.velocity_y));
    cpBodySetAngularVelocity(body, -placement.angular_velocity);
    const cpVect middle = cpv(-placement.offset_x, -placement.offset_y);
    add_shape(
        cpBoxShapeNew2(body, cpBBNewForExtents(middle, 0.5 * placement.width, 0.5 * placement.height), 0));
  }

  cpBody* add_body(cpBody* body) {
    bodies_.emplace_back(body);
    return cpSpaceAddBody(space_.get(), body);
  }

  void add_shape(cpShape* shape) {
    shapes_.emplace_back(shape);
    cpShapeSetCollisionType(shape, bodies_.size() - 1);
    cpSpaceAddShape(space_.get(), shape);
  }

  std::vector<double> friction_;
  double elasticity_;
  std::vector<Touch> touches_;
  std::vector<cpTransform> starts_;  ///< of each body in the last step
  // The space comes last: it is the first to go and still needs the others then.
  std::vector<std::unique_ptr<cpBody, Destroy>> bodies_;  ///< ground first, then bottom to top
  std::vector<std::unique_ptr<cpShape, Destroy>> shapes_;
  std::unique_ptr<cpSpace, Destroy> space_{cpSpaceNew()};
};

}  // namespace

std::vector<Engine> make_chipmunk() {
  const double bias = std::pow(1 - 0.1F, 60);
  return {{{.name = "chipmunk",
            .solver = "sequential-impulse",
            .version = fmt::format("{}, double precision", cpVersionString),
            .licence = "MIT",
            .capabilities =
                {.wall = true, .applied_forces = true, .planar = true, .center_of_mass = true, .lead = -0.5},
            .settings = {count_setting("iterations", 10, 50),
                         {.name = "collisionSlop", .unit = "m", .default_value = 0.1F, .tuned = 1e-4},
                         {.name = "collisionBias", .default_value = bias, .most = 1},
                         count_setting("collisionPersistence", 3, 3),
                         {.name = "elasticity", .most = 1, .role = SettingRole::restitution},
                         shaking_setting()}},
           [](const Setup& setup, const Parameters& parameters) {
             return std::make_unique<ChipmunkSimulation>(setup, parameters);
           }}};
}

}  // namespace rockstack
