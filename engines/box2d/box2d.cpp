// Box2D beside the exact model; README.md says what its contacts are and why its sets are as they are.

#include <box2d/box2d.h>

#include <algorithm>

#include "engines/engine.hpp"

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

/// A contact point, and which of its pair's it is.
struct Touch {
  ContactPoint point;
  const b2Contact* pair = nullptr;
  int number = 0;
  b2Vec2 normal{0, 0};  ///< from the pair's first body to its second, where the step starts
  double on_upper = 1;  ///< −1 where the upper body is the first
};

/// What the library tells of pairs that touch, and asks.
class Contacts : public b2ContactListener {
 public:
  Contacts(const std::vector<double>& friction, LengthUnit unit) : friction_(friction), unit_(unit) {}

  /// A pair's friction is that of the interface under its upper body, not the root of the product.
  void PreSolve(b2Contact* pair, const b2Manifold* /*before*/) override {
    b2Fixture *a = pair->GetFixtureA(), *b = pair->GetFixtureB();
    // From 0, the ground, bottom to top.
    b2Fixture& upper = *(a->GetUserData().pointer > b->GetUserData().pointer ? a : b);
    const std::size_t interface = upper.GetUserData().pointer - 1;
    pair->SetFriction(static_cast<float>(friction_[interface]));
    if (watched) watch_points(*pair, interface, *upper.GetBody());
  }

  /// Called once more for each sub-step that the library takes within a step.
  void PostSolve(b2Contact* pair, const b2ContactImpulse* impulse) override {
    if (!watched) return;
    b2WorldManifold solved;
    pair->GetWorldManifold(&solved);
    for (int i = 0; i < impulse->count; ++i) {
      Touch& touch = *find(*pair, i);
      ContactPoint& point = touch.point;
      const b2Vec2 total =
          impulse->normalImpulses[i] * touch.normal + impulse->tangentImpulses[i] * b2Cross(touch.normal, 1);
      point.impulse_x += touch.on_upper * unit_.from(total.x);
      point.impulse_y += touch.on_upper * unit_.from(total.y);
      point.gap = unit_.from(solved.separations[i]);
      point.normal += unit_.from(impulse->normalImpulses[i]);
      point.tangential += unit_.from(std::abs(impulse->tangentImpulses[i]));
    }
  }

  bool watched = false;
  std::vector<Touch> touches;  ///< of the step under way, where they are watched

 private:
  std::vector<Touch>::iterator find(const b2Contact& pair, int number) {
    return std::ranges::find_if(
        touches, [&](const Touch& touch) { return touch.pair == &pair && touch.number == number; });
  }

  void watch_points(const b2Contact& pair, std::size_t interface, const b2Body& upper) {
    b2WorldManifold found;
    pair.GetWorldManifold(&found);
    for (int i = 0; i < pair.GetManifold()->pointCount; ++i) {
      if (find(pair, i) != touches.end()) continue;
      const double on_upper = &upper == pair.GetFixtureB()->GetBody() ? 1 : -1;
      ContactPoint& point = touches.emplace_back(Touch{{}, &pair, i, found.normal, on_upper}).point;
      point.interface = interface;
      point.along = unit_.from(upper.GetLocalPoint(found.points[i]).x);
      point.gap_before = unit_.from(found.separations[i]);
      point.gap = point.gap_before;
    }
  }

  std::vector<double> friction_;
  LengthUnit unit_;
};

class Box2DSimulation final : public ShakenSimulation {
 public:
  Box2DSimulation(const Setup& setup, const Parameters& parameters)
      : ShakenSimulation(setup),
        unit_(parameters.at("lengthUnit")),
        velocity_iterations_(static_cast<int>(parameters.at("velocityIterations"))),
        position_iterations_(static_cast<int>(parameters.at("positionIterations"))),
        radius_(static_cast<float>(parameters.at("polygonRadius"))),
        contacts_(setup.friction, unit_) {
    fixture_.restitution = static_cast<float>(parameters.at("restitution"));
    fixture_.restitutionThreshold = static_cast<float>(parameters.at("restitutionThreshold"));
    world_.SetWarmStarting(parameters.at("warmStarting") != 0);
    world_.SetContinuousPhysics(parameters.at("continuousPhysics") != 0);
    world_.SetContactListener(&contacts_);
    set_gravity(setup.gravity);
    add_ground(ground_reach(setup.blocks));
    if (setup.wall) add_wall(*setup.wall);
    for (const Placement& placement : setup.blocks) add_block(placement);
  }

  BodyState body(std::size_t k) const override {
    const b2Body& block = *bodies_[k + 1];
    const b2Vec2 &place = block.GetPosition(), &velocity = block.GetLinearVelocity();
    return {unit_.from(place.x),    unit_.from(place.y), unit_.from(velocity.x),
            unit_.from(velocity.y), -block.GetAngle(),   -block.GetAngularVelocity()};
  }

  bool watch_contacts() override { return contacts_.watched = true; }

  std::vector<ContactPoint> contacts() const override {
    std::vector<ContactPoint> points;
    for (const Touch& touch : contacts_.touches) points.push_back(touch.point);
    return points;
  }

 private:
  void advance() override {
    contacts_.touches.clear();
    world_.Step(static_cast<float>(dt()), velocity_iterations_, position_iterations_);
  }

  void set_gravity(const BodyAcceleration& acceleration) override {
    world_.SetGravity(unit_.to(acceleration.x, acceleration.y));
  }

  void apply_load(std::size_t k, const BodyLoad& load) override {
    bodies_[k + 1]->ApplyForceToCenter(unit_.to(load.x, load.y), true);
    bodies_[k + 1]->ApplyTorque(unit_.to_inertia(-load.moment), true);
  }

  /// A box whose upper face is at y = 0.
  void add_ground(double reach) {
    b2BodyDef definition;
    if (moves_ground()) definition.type = b2_kinematicBody;
    add(definition, 2 * reach, 2 * reach, unit_.to(0, -reach));
  }

  /// A wall is a shape of the ground's body, whose number it has.
  void add_wall(const FixedBox& wall) {
    fixture_.userData.pointer = 0;
    add_box(*bodies_.front(), wall.width, wall.height, unit_.to(wall.x, wall.y));
  }

  void place_ground(const GroundStep& step) override {
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
    b2Body& body = add(definition, placement.width, placement.height,
                       unit_.to(-placement.offset_x, -placement.offset_y));
    b2MassData mass;
    mass.mass = static_cast<float>(placement.mass);
    mass.center.SetZero();
    mass.I = unit_.to_inertia(placement.inertia);
    body.SetMassData(&mass);
  }

  /// `centre`: of the box, from the body's origin, in the library's unit.
  b2Body& add(b2BodyDef& definition, double width, double height, const b2Vec2& centre) {
    definition.allowSleep = false;
    fixture_.userData.pointer = bodies_.size();
    bodies_.push_back(world_.CreateBody(&definition));
    add_box(*bodies_.back(), width, height, centre);
    return *bodies_.back();
  }

  void add_box(b2Body& body, double width, double height, const b2Vec2& centre) {
    b2PolygonShape box;
    box.SetAsBox(unit_.to(0.5 * width), unit_.to(0.5 * height), centre, 0);
    box.m_radius = radius_;
    fixture_.shape = &box;
    body.CreateFixture(&fixture_);
  }

  LengthUnit unit_;
  int velocity_iterations_, position_iterations_;
  float radius_;          ///< of all boxes' skins, in the library's unit
  b2FixtureDef fixture_;  ///< of all: of a pair the library takes the larger restitution, the lower threshold
  Contacts contacts_;
  b2World world_{{0, 0}};
  std::vector<b2Body*> bodies_;  ///< the world's: ground first, then bottom to top
};

}  // namespace

std::vector<Engine> make_box2d() {
  return {
      {{.name = "box2d",
        .solver = "sequential-impulse",
        .version = BOX2D_VERSION ", single precision",
        .licence = "MIT",
        .capabilities = {.wall = true,
                         .applied_forces = true,
                         .single_precision = true,
                         .planar = true,
                         .center_of_mass = true},
        .settings =
            {count_setting("velocityIterations", 8, 50),
             {.name = "positionIterations", .default_value = 3, .most = 1e6, .whole = true},
             switch_setting("warmStarting", true, true),
             switch_setting("continuousPhysics", true, false),
             {.name = "polygonRadius", .default_value = b2_polygonRadius, .tuned = 0, .most = 1e3},
             {.name = "restitution", .most = 1, .role = SettingRole::restitution},
             {.name = "restitutionThreshold", .default_value = 1, .role = SettingRole::restitution_threshold},
             {.name = "lengthUnit",
              .unit = "m",
              .default_value = 1,
              .tuned = 0.02,
              .least = 1e-6,
              .most = 1e6},
             shaking_setting()}},
       [](const Setup& setup, const Parameters& parameters) {
         return std::make_unique<Box2DSimulation>(setup, parameters);
       }}};
}

}  // namespace rockstack
