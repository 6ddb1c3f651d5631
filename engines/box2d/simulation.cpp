#include "engines/box2d/simulation.hpp"

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engines/ground_reach.hpp"
#include "engines/shaking.hpp"

namespace rockstack {
namespace {

/// Numbers in the library's unit of length and back.
class LengthUnit {
 public:
  explicit LengthUnit(double metres) : metres_(metres) {}
  float to(double length) const { return static_cast<float>(length / metres_); }
  b2Vec2 to(double x, double y) const { return {to(x), to(y)}; }
  float to_inertia(double inertia) const { return static_cast<float>(inertia / metres_ / metres_); }
  double from(float length) const { return metres_ * length; }

 private:
  double metres_;
};

/// Both the same in both fixtures of a pair: the library takes the larger restitution, the lower threshold.
struct Surface {
  float radius, restitution, threshold;  ///< lengths in the library's unit
};

/// From 0, the ground, bottom to top.
std::size_t number_of(b2Fixture& fixture) {
  return fixture.GetUserData().pointer;
}

/// What the library tells of pairs that touch, and asks.
class Contacts : public b2ContactListener {
 public:
  Contacts(const std::vector<double>& friction, LengthUnit unit) : friction_(friction), unit_(unit) {}

  /// A pair's friction is that of the interface under its upper body; the library would take the root of the
  /// product.
  void PreSolve(b2Contact* pair, const b2Manifold* /*before*/) override {
    const std::size_t a = number_of(*pair->GetFixtureA()), b = number_of(*pair->GetFixtureB());
    const std::size_t interface = std::max(a, b) - 1;
    pair->SetFriction(static_cast<float>(friction_[interface]));
    if (watched_)
      watch_points(*pair, interface, *(a > b ? pair->GetFixtureA() : pair->GetFixtureB())->GetBody());
  }

  /// Called once more for each sub-step that the library takes within a step.
  void PostSolve(b2Contact* pair, const b2ContactImpulse* impulse) override {
    if (!watched_) return;
    b2WorldManifold solved;
    pair->GetWorldManifold(&solved);
    for (int i = 0; i < impulse->count; ++i) {
      ContactPoint& point = find(*pair, i)->point;
      point.gap = unit_.from(solved.separations[i]);
      point.normal += unit_.from(impulse->normalImpulses[i]);
      point.tangential += unit_.from(std::abs(impulse->tangentImpulses[i]));
    }
  }

  void watch() { watched_ = true; }
  void clear() { touches_.clear(); }
  std::vector<ContactPoint> points() const {
    std::vector<ContactPoint> list;
    list.reserve(touches_.size());
    for (const Touch& touch : touches_) list.push_back(touch.point);
    return list;
  }

 private:
  struct Touch {
    ContactPoint point;
    const b2Contact* pair = nullptr;
    int number = 0;  ///< of the point among its pair's
  };

  std::vector<Touch>::iterator find(const b2Contact& pair, int number) {
    return std::find_if(touches_.begin(), touches_.end(),
                        [&](const Touch& touch) { return touch.pair == &pair && touch.number == number; });
  }

  void watch_points(const b2Contact& pair, std::size_t interface, const b2Body& upper) {
    b2WorldManifold found;
    pair.GetWorldManifold(&found);
    for (int i = 0; i < pair.GetManifold()->pointCount; ++i) {
      if (find(pair, i) != touches_.end()) continue;
      ContactPoint& point = touches_.emplace_back(Touch{{}, &pair, i}).point;
      point.interface = interface;
      point.along = unit_.from(upper.GetLocalPoint(found.points[i]).x);
      point.gap_before = unit_.from(found.separations[i]);
      point.gap = point.gap_before;
    }
  }

  std::vector<double> friction_;
  LengthUnit unit_;
  bool watched_ = false;
  std::vector<Touch> touches_;
};

class Box2DSimulation : public Simulation {
 public:
  Box2DSimulation(const Setup& setup, const Parameters& parameters)
      : unit_(parameters.at("lengthUnit")),
        dt_(static_cast<float>(setup.dt)),
        velocity_iterations_(static_cast<int>(parameters.at("velocityIterations"))),
        position_iterations_(static_cast<int>(parameters.at("positionIterations"))),
        shaking_(setup),
        surface_{static_cast<float>(parameters.at("polygonRadius")),
                 static_cast<float>(parameters.at("restitution")),
                 static_cast<float>(parameters.at("restitutionThreshold"))},
        contacts_(setup.friction, unit_) {
    world_.SetWarmStarting(parameters.at("warmStarting") != 0);
    world_.SetContinuousPhysics(parameters.at("continuousPhysics") != 0);
    world_.SetContactListener(&contacts_);
    set_gravity(setup.gravity);
    add_ground(ground_reach(setup.blocks));
    for (const Placement& placement : setup.blocks) add_block(placement);
  }

  void step() override {
    const auto [ground, acceleration] = shaking_.next();
    if (ground) place_ground(*ground);
    if (acceleration) set_gravity(*acceleration);
    contacts_.clear();
    world_.Step(dt_, velocity_iterations_, position_iterations_);
  }

  void read(std::span<double> angles, std::span<double> velocities) const override {
    for (std::size_t k = 0; k + 1 < bodies_.size(); ++k) {
      angles[k] = -bodies_[k + 1]->GetAngle();
      velocities[k] = -bodies_[k + 1]->GetAngularVelocity();
    }
  }

  BodyState body(std::size_t k) const override {
    const b2Vec2& place = bodies_[k + 1]->GetPosition();
    const b2Vec2& velocity = bodies_[k + 1]->GetLinearVelocity();
    return {.x = unit_.from(place.x),
            .y = unit_.from(place.y),
            .velocity_x = unit_.from(velocity.x),
            .velocity_y = unit_.from(velocity.y)};
  }

  bool watch_contacts() override {
    contacts_.watch();
    return true;
  }

  std::vector<ContactPoint> contacts() const override { return contacts_.points(); }

 private:
  void set_gravity(const BodyAcceleration& acceleration) {
    world_.SetGravity(unit_.to(acceleration.x, acceleration.y));
  }

  /// A box whose upper face is at y = 0.
  void add_ground(double reach) {
    b2BodyDef definition;
    if (shaking_.moves_ground()) definition.type = b2_kinematicBody;
    add(definition, 2 * reach, 2 * reach, unit_.to(0, -reach));
  }

  /// Contacts are found where ground and blocks are at the step's start; the velocity carries both on.
  void place_ground(const GroundStep& step) {
    bodies_.front()->SetTransform(unit_.to(step.x, step.y), 0);
    bodies_.front()->SetLinearVelocity(unit_.to(step.velocity_x, step.velocity_y));
  }

  void add_block(const Placement& placement) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = unit_.to(placement.x, placement.y);
    definition.angle = static_cast<float>(-placement.angle);
    definition.linearVelocity = unit_.to(placement.velocity_x, placement.velocity_y);
    definition.angularVelocity = static_cast<float>(-placement.angular_velocity);
    b2Body& body = add(definition, placement.width, placement.height, b2Vec2_zero);
    b2MassData mass;
    mass.mass = static_cast<float>(placement.mass);
    mass.center.SetZero();
    mass.I = unit_.to_inertia(placement.inertia);
    body.SetMassData(&mass);
  }

  /// `centre`: of the box, from the body's origin, in the library's unit.
  b2Body& add(b2BodyDef& definition, double width, double height, const b2Vec2& centre) {
    definition.allowSleep = false;
    b2PolygonShape box;
    box.SetAsBox(unit_.to(0.5 * width), unit_.to(0.5 * height), centre, 0);
    box.m_radius = surface_.radius;
    b2FixtureDef fixture;
    fixture.shape = &box;
    fixture.restitution = surface_.restitution;
    fixture.restitutionThreshold = surface_.threshold;
    fixture.userData.pointer = bodies_.size();
    bodies_.push_back(world_.CreateBody(&definition));
    bodies_.back()->CreateFixture(&fixture);
    return *bodies_.back();
  }

  LengthUnit unit_;
  float dt_;
  int velocity_iterations_, position_iterations_;
  Shaking shaking_;
  Surface surface_;
  Contacts contacts_;
  b2World world_{{0, 0}};
  std::vector<b2Body*> bodies_;  ///< the world's: ground first, then bottom to top
};

}  // namespace

std::unique_ptr<Simulation> start_box2d(const Setup& setup, const Parameters& parameters) {
  return std::make_unique<Box2DSimulation>(setup, parameters);
}

}  // namespace rockstack
