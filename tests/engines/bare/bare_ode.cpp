// A stack of blocks in ODE by ODE's headers alone: nothing of this project is read here, so that its adapter
// can be held to it. What is not set stays as the library has it. Standard input has words:
//
//   solver step                        (or quickstep)
//   gravity 9.81  friction 1000  dt 0.001  steps 500
//   block 1.25 1.25 1 3906 834 834 1017 0 0.6 0.15
//     of each block from the bottom up: width, height, depth (m), mass (kg), moments of inertia about x, y
//     and z (kg m²), centre x, y (m), angle (rad)
//   set erp 0.01                       (whatever ODE can be told)
//   shake 0.5 -0.1                     (the ground's acceleration right and up, m/s², one a step)
//
// Standard output has a line a step, the start first: the angles in rad, clockwise positive.

#include <ode/ode.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace {

struct Block {
  double width, height, depth, mass, about_x, about_y, about_z, x, y, angle;
};

struct Question {
  std::map<std::string, double> number{{"gravity", 0}, {"friction", 0}, {"dt", 0}, {"steps", 0}};
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

dWorldID world;
dSpaceID space;
dJointGroupID contacts;
dSurfaceParameters surface;
int most_contacts = 8;
bool realign = true;

void set_all(const Question& question) {
  double stiffness = 0, damping = 0, coefficient = 1;
  const std::map<std::string, std::function<void(double)>> setters{
      {"erp", [](double v) { dWorldSetERP(world, v); }},
      {"cfm", [](double v) { dWorldSetCFM(world, v); }},
      {"contactSurfaceLayer", [](double v) { dWorldSetContactSurfaceLayer(world, v); }},
      {"contactMaxCorrectingVel", [](double v) { dWorldSetContactMaxCorrectingVel(world, v); }},
      {"quickStepNumIterations",
       [](double v) { dWorldSetQuickStepNumIterations(world, static_cast<int>(v)); }},
      {"quickStepW", [](double v) { dWorldSetQuickStepW(world, v); }},
      {"maxContacts", [](double v) { most_contacts = static_cast<int>(v); }},
      {"realign", [](double v) { realign = v != 0; }},
      {"contactApprox1", [&](double v) { coefficient = v; }},
      {"contactMu2", [](double v) { surface.mode |= v != 0 ? dContactMu2 | dContactFDir1 : 0; }},
      {"bounce", [](double v) { surface.mode |= dContactBounce, surface.bounce = v; }},
      {"slip1", [](double v) { surface.mode |= dContactSlip1, surface.slip1 = v; }},
      {"contactStiffness", [&](double v) { stiffness = v; }},
      {"contactDamping", [&](double v) { damping = v; }},
  };
  for (const auto& [name, value] : question.set) setters.at(name)(value);
  surface.mu = question.number.at("friction");
  if (coefficient != 0) {
    surface.mode |= dContactApprox1;
  } else {
    for (const Block& block : question.blocks) coefficient += block.mass * question.number.at("gravity");
    surface.mu *= coefficient;
  }
  if (stiffness > 0) {
    const double h = question.number.at("dt");
    surface.mode |= dContactSoftERP | dContactSoftCFM;
    surface.soft_erp = h * stiffness / (h * stiffness + damping);
    surface.soft_cfm = 1 / (h * stiffness + damping);
  }
}

std::vector<dBodyID> build(const Question& question) {
  dCreatePlane(space, 0, 1, 0, 0);
  std::vector<dBodyID> bodies;
  for (const Block& block : question.blocks) {
    const dBodyID body = bodies.emplace_back(dBodyCreate(world));
    dMass mass;
    dMassSetParameters(&mass, block.mass, 0, 0, 0, block.about_x, block.about_y, block.about_z, 0, 0, 0);
    dBodySetMass(body, &mass);
    dGeomSetBody(dCreateBox(space, block.width, block.height, block.depth), body);
    dBodySetPosition(body, block.x, block.y, 0);
    const dQuaternion turn{std::cos(0.5 * block.angle), 0, 0, -std::sin(0.5 * block.angle)};
    dBodySetQuaternion(body, turn);
    dJointAttach(dJointCreatePlane2D(world, nullptr), body, nullptr);
  }
  return bodies;
}

void touch(void*, dGeomID one, dGeomID other) {
  std::vector<dContact> found(static_cast<std::size_t>(most_contacts));
  const int count = dCollide(one, other, most_contacts, &found[0].geom, sizeof(dContact));
  for (int i = 0; i < count; ++i) {
    dContact& contact = found[static_cast<std::size_t>(i)];
    contact.surface = surface;
    contact.fdir1[0] = contact.geom.normal[1];
    contact.fdir1[1] = -contact.geom.normal[0];
    dJointAttach(dJointCreateContact(world, contacts, &contact), dGeomGetBody(one), dGeomGetBody(other));
  }
}

/// Turns about the z axis alone stay.
void put_back(dBodyID body) {
  const dQuaternion turn{dBodyGetQuaternion(body)[0], 0, 0, dBodyGetQuaternion(body)[3]};
  dBodySetQuaternion(body, turn);
  dBodySetAngularVel(body, 0, 0, dBodyGetAngularVel(body)[2]);
}

void print(const std::vector<dBodyID>& bodies) {
  for (const dBodyID body : bodies) {
    const dReal* turn = dBodyGetQuaternion(body);
    std::printf("%.17g ", -2 * std::atan2(turn[3], turn[0]));
  }
  std::printf("\n");
}

}  // namespace

int main() {
  Question question;
  if (!read(std::cin, question)) return 2;
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  dRandSetSeed(0);
  world = dWorldCreate();
  space = dSimpleSpaceCreate(nullptr);
  contacts = dJointGroupCreate(0);
  set_all(question);
  const std::vector<dBodyID> bodies = build(question);
  const double gravity = question.number.at("gravity");
  dWorldSetGravity(world, 0, -gravity, 0);
  print(bodies);
  for (std::size_t step = 0; step < static_cast<std::size_t>(question.number.at("steps")); ++step) {
    if (step < question.shaking.size()) {
      dWorldSetGravity(world, -question.shaking[step].first, -gravity - question.shaking[step].second, 0);
    }
    dSpaceCollide(space, nullptr, touch);
    const auto advance = question.solver == "step" ? dWorldStep : dWorldQuickStep;
    advance(world, question.number.at("dt"));
    dJointGroupEmpty(contacts);
    for (const dBodyID body : bodies) {
      if (realign) put_back(body);
    }
    print(bodies);
  }
}
