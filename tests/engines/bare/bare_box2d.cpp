// A stack of blocks in Box2D by Box2D's headers alone: nothing of this project is read here, so that its
// adapter can be held to it. What is not set stays as the library has it. Standard input has words:
//
//   solver sequential-impulse
//   gravity 9.81  friction 1000  dt 0.001  steps 500
//   reach 30                           (half the ground's width, m)
//   block 1.25 1.25 1 3906 834 834 1017 0 0.6 0.15
//     of each block from the bottom up: width, height, depth (m), mass (kg), moments of inertia about x, y
//     and z (kg m²), centre x, y (m), angle (rad)
//   set velocityIterations 20          (whatever Box2D can be told)
//   shake 0.5 -0.1                     (the ground's acceleration right and up, m/s², one a step)
//
// Standard output has a line a step, the start first: the angles in rad, clockwise positive.

#include <box2d/box2d.h>

#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Block {
  double width, height, depth, mass, about_x, about_y, about_z, x, y, angle;
};

struct Question {
  std::map<std::string, double> number{
      {"gravity", 0}, {"friction", 0}, {"dt", 0}, {"steps", 0}, {"reach", 0}};
  std::string solver;
  std::vector<Block> blocks;
  std::map<std::string, double> set;
  std::vector<std::pair<double, double>> shaking;
};

bool read(std::istream& in, Question& question) {
  for (std::string word; in >> word;) {
    if (word == "solver") {
      in >> question.solver;
    } else if (word == "block") {
      Block& block = question.blocks.emplace_back();
      in >> block.width >> block.height >> block.depth >> block.mass >> block.about_x >> block.about_y;
      in >> block.about_z >> block.x >> block.y >> block.angle;
    } else if (word == "set") {
      in >> word;
      in >> question.set[word];
    } else if (word == "shake") {
      auto& [x, y] = question.shaking.emplace_back();
      in >> x >> y;
    } else if (question.number.count(word) != 0) {
      in >> question.number[word];
    } else {
      return false;
    }
  }
  return in.eof();
}

int velocity_iterations = 8, position_iterations = 3;
double length_unit = 1, radius = b2_polygonRadius, restitution = 0, threshold = 1;

void set_all(b2World& world, const Question& question) {
  const std::map<std::string, std::function<void(double)>> setters{
      {"velocityIterations", [](double v) { velocity_iterations = static_cast<int>(v); }},
      {"positionIterations", [](double v) { position_iterations = static_cast<int>(v); }},
      {"warmStarting", [&](double v) { world.SetWarmStarting(v != 0); }},
      {"continuousPhysics", [&](double v) { world.SetContinuousPhysics(v != 0); }},
      {"polygonRadius", [](double v) { radius = v; }},
      {"restitution", [](double v) { restitution = v; }},
      {"restitutionThreshold", [](double v) { threshold = v; }},
      {"lengthUnit", [](double v) { length_unit = v; }},
  };
  for (const auto& [name, value] : question.set) setters.at(name)(value);
}

/// A length in the library's unit.
float lengths(double metres) {
  return static_cast<float>(metres / length_unit);
}

/// The friction of two fixtures is the root of their product, so that both have the coefficient itself.
void add_box(b2Body& body, double width, double height, const b2Vec2& centre, double friction) {
  b2PolygonShape box;
  box.SetAsBox(lengths(0.5 * width), lengths(0.5 * height), centre, 0);
  box.m_radius = static_cast<float>(radius);
  b2FixtureDef fixture;
  fixture.shape = &box;
  fixture.friction = static_cast<float>(friction);
  fixture.restitution = static_cast<float>(restitution);
  fixture.restitutionThreshold = static_cast<float>(threshold);
  body.CreateFixture(&fixture);
}

std::vector<b2Body*> build(b2World& world, const Question& question) {
  const double reach = question.number.at("reach"), friction = question.number.at("friction");
  const b2BodyDef still;
  add_box(*world.CreateBody(&still), 2 * reach, 2, {0, -lengths(1)}, friction);
  std::vector<b2Body*> bodies;
  for (const Block& block : question.blocks) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position.Set(lengths(block.x), lengths(block.y));
    definition.angle = static_cast<float>(-block.angle);
    definition.allowSleep = false;
    b2Body* body = bodies.emplace_back(world.CreateBody(&definition));
    add_box(*body, block.width, block.height, b2Vec2_zero, friction);
    b2MassData mass;
    mass.mass = static_cast<float>(block.mass);
    mass.center.SetZero();
    mass.I = static_cast<float>(block.about_z / length_unit / length_unit);
    body->SetMassData(&mass);
  }
  return bodies;
}

void print(const std::vector<b2Body*>& bodies) {
  for (const b2Body* body : bodies) std::printf("%.17g ", -body->GetAngle());
  std::printf("\n");
}

}  // namespace

int main() {
  Question question;
  if (!read(std::cin, question)) return 2;
  const double gravity = question.number.at("gravity");
  b2World world({0, 0});
  set_all(world, question);
  world.SetGravity({0, -lengths(gravity)});
  const std::vector<b2Body*> bodies = build(world, question);
  print(bodies);
  for (std::size_t step = 0; step < static_cast<std::size_t>(question.number.at("steps")); ++step) {
    if (step < question.shaking.size()) {
      const auto& [x, y] = question.shaking[step];
      world.SetGravity({-lengths(x), -lengths(gravity + y)});
    }
    world.Step(static_cast<float>(question.number.at("dt")), velocity_iterations, position_iterations);
    print(bodies);
  }
}
