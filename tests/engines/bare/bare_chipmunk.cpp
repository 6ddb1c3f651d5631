// A stack of blocks in Chipmunk by Chipmunk's headers alone: nothing of this project is read here, so that
// its adapter can be held to it. What is not set stays as the library has it. Standard input has words:
//
//   solver sequential-impulse
//   gravity 9.81  friction 1000  dt 0.001  steps 500
//   reach 30                           (half the ground's width, m)
//   block 1.25 1.25 1 3906 834 834 1017 0 0.6 0.15
//     of each block from the bottom up: width, height, depth (m), mass (kg), moments of inertia about x, y
//     and z (kg m²), centre x, y (m), angle (rad)
//   set iterations 20                  (whatever Chipmunk can be told)
//   shake 0.5 -0.1                     (the ground's acceleration right and up, m/s², one a step)
//
// Standard output has a line a step, the start first: the angles in rad, clockwise positive.

#include <chipmunk/chipmunk.h>
#include <unistd.h>

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

double elasticity = 0, friction = 0;

void set_all(cpSpace* space, const Question& question) {
  const std::map<std::string, std::function<void(double)>> setters{
      {"iterations", [&](double v) { cpSpaceSetIterations(space, static_cast<int>(v)); }},
      {"collisionSlop", [&](double v) { cpSpaceSetCollisionSlop(space, v); }},
      {"collisionBias", [&](double v) { cpSpaceSetCollisionBias(space, v); }},
      {"collisionPersistence",
       [&](double v) { cpSpaceSetCollisionPersistence(space, static_cast<cpTimestamp>(v)); }},
      {"elasticity", [](double v) { elasticity = v; }},
  };
  for (const auto& [name, value] : question.set) setters.at(name)(value);
  friction = question.number.at("friction");
}

cpBool rub(cpArbiter* pair, cpSpace*, void*) {
  cpArbiterSetFriction(pair, friction);
  cpArbiterSetRestitution(pair, elasticity);
  return cpTrue;
}

std::vector<cpBody*> build(cpSpace* space, const Question& question) {
  const double reach = question.number.at("reach");
  cpSpaceAddShape(space, cpSegmentShapeNew(cpSpaceGetStaticBody(space), cpv(-reach, 0), cpv(reach, 0), 0));
  std::vector<cpBody*> bodies;
  for (const Block& block : question.blocks) {
    cpBody* body = bodies.emplace_back(cpSpaceAddBody(space, cpBodyNew(block.mass, block.about_z)));
    cpBodySetPosition(body, cpv(block.x, block.y));
    cpBodySetAngle(body, -block.angle);
    cpSpaceAddShape(space, cpBoxShapeNew(body, block.width, block.height, 0));
  }
  cpSpaceAddDefaultCollisionHandler(space)->preSolveFunc = rub;
  return bodies;
}

void print(std::FILE* out, const std::vector<cpBody*>& bodies) {
  for (const cpBody* body : bodies) std::fprintf(out, "%.17g ", -cpBodyGetAngle(body));
  std::fprintf(out, "\n");
}

}  // namespace

int main() {
  Question question;
  if (!read(std::cin, question)) return 2;
  // A library built for finding errors greets on the standard output.
  std::FILE* out = ::fdopen(::dup(STDOUT_FILENO), "w");
  if (out == nullptr || std::freopen("/dev/null", "w", stdout) == nullptr) return 1;
  cpSpace* space = cpSpaceNew();
  set_all(space, question);
  const std::vector<cpBody*> bodies = build(space, question);
  const double gravity = question.number.at("gravity");
  cpSpaceSetGravity(space, cpv(0, -gravity));
  print(out, bodies);
  for (std::size_t step = 0; step < static_cast<std::size_t>(question.number.at("steps")); ++step) {
    if (step < question.shaking.size())
      cpSpaceSetGravity(space, cpv(-question.shaking[step].first, -gravity - question.shaking[step].second));
    cpSpaceStep(space, question.number.at("dt"));
    print(out, bodies);
  }
  std::fclose(out);
}
