// A stack of blocks in Siconos by its kernel and numerics alone: nothing of this project is read here, so
// that its adapter can be held to it. What is not set stays as the library has it. Standard input has words:
//
//   solver nsgs                        (no other)
//   gravity 9.81  friction 1000  dt 0.001  steps 500
//   block 1.25 1.25 1 3906 834 834 1017 0 0.6 0.15
//     of each block from the bottom up: width, height, depth (m), mass (kg), moments of inertia about x, y
//     and z (kg m²), centre x, y (m), angle (rad)
//   set theta 1                        (whatever Siconos can be told)
//   shake 0.5 -0.1                     (the ground's acceleration right and up, m/s², one a step)
//
// Standard output has a line a step, the start first: the angles in rad, clockwise positive.

#include <SolverOptions.h>
#include <SiconosKernel.hpp>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// Null where another BLAS than OpenBLAS is in use, whose threads wait for each other over small matrices.
extern "C" void openblas_set_num_threads(int number) __attribute__((weak));

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
      Block block{};
      in >> block.width >> block.height >> block.depth >> block.mass >> block.about_x >> block.about_y;
      in >> block.about_z >> block.x >> block.y >> block.angle;
      question.blocks.push_back(block);
    } else if (word == "set") {
      in >> word;
      in >> question.set[word];
    } else if (word == "shake") {
      question.shaking.emplace_back();
      in >> question.shaking.back().first >> question.shaking.back().second;
    } else if (question.number.count(word) != 0) {
      in >> question.number[word];
    } else {
      return false;
    }
  }
  return in.eof();
}

/// A point of one body over a face of another, or of the ground where there is none. Angles turn to the left.
class PointOnFace : public LagrangianScleronomousR {
 public:
  /// The corner at (x, y) of body `corner`; the face at height `face_y` of the other one points up or down,
  /// by `up`, and reaches to `reach` on both sides.
  PointOnFace(unsigned corner, double x, double y, double face_y, double up, double reach)
      : corner_(corner), x_(x), y_(y), face_y_(face_y), up_(up), reach_(reach) {}

  void computeh(const BlockVector& q, BlockVector&, SiconosVector& y) override {
    const Place place = find(q);
    const double dx = place.x - place.face_x, dy = place.y - place.face_y;
    const double along = place.normal_y * dx - place.normal_x * dy;
    const double gap = place.normal_x * dx + place.normal_y * dy - face_y_ * up_;
    y.setValue(0, std::abs(along) <= reach_ ? gap : 1e3);
  }

  void computeJachq(const BlockVector& q, BlockVector&) override {
    const Place place = find(q);
    const double rows[2][2] = {{place.normal_x, place.normal_y}, {place.normal_y, -place.normal_x}};
    for (unsigned body = 0; body < q.size() / 3; ++body) {
      const double sign = body == corner_ ? 1 : -1;
      const double arm_x = place.x - q.getValue(3 * body), arm_y = place.y - q.getValue(3 * body + 1);
      for (unsigned row = 0; row < 2; ++row) {
        _jachq->setValue(row, 3 * body, sign * rows[row][0]);
        _jachq->setValue(row, 3 * body + 1, sign * rows[row][1]);
        _jachq->setValue(row, 3 * body + 2, sign * (rows[row][1] * arm_x - rows[row][0] * arm_y));
      }
    }
  }

 private:
  struct Place {
    double x, y, face_x, face_y, normal_x, normal_y;
  };

  Place find(const BlockVector& q) const {
    const unsigned own = 3 * corner_, other = 3 * (1 - corner_);
    const double c = std::cos(q.getValue(own + 2)), s = std::sin(q.getValue(own + 2));
    Place place{q.getValue(own) + (c * x_ - s * y_), q.getValue(own + 1) + (s * x_ + c * y_), 0, 0, 0, up_};
    if (q.size() == 3) return place;
    place.face_x = q.getValue(other);
    place.face_y = q.getValue(other + 1);
    place.normal_x = -up_ * std::sin(q.getValue(other + 2));
    place.normal_y = up_ * std::cos(q.getValue(other + 2));
    return place;
  }

  unsigned corner_;
  double x_, y_, face_y_, up_, reach_;
};

/// Without it the library writes where this program does.
void pass_over(int, Simulation*) {}

}  // namespace

int main() {
  Question question;
  if (!read(std::cin, question)) return 2;
  const double dt = question.number.at("dt"), steps = question.number.at("steps");
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
  const auto set = [&](const char* name, double default_value) {
    return question.set.count(name) != 0 ? question.set.at(name) : default_value;
  };
  const auto nsds = std::make_shared<NonSmoothDynamicalSystem>(0, (steps + 2) * dt);
  std::vector<std::shared_ptr<LagrangianLinearTIDS>> bodies;
  for (const Block& block : question.blocks) {
    const auto q = std::make_shared<SiconosVector>(3), v = std::make_shared<SiconosVector>(3);
    q->setValue(0, block.x);
    q->setValue(1, block.y);
    q->setValue(2, -block.angle);
    const auto mass = std::make_shared<SimpleMatrix>(3, 3);
    mass->setValue(0, 0, block.mass);
    mass->setValue(1, 1, block.mass);
    mass->setValue(2, 2, block.about_z);
    const auto body = std::make_shared<LagrangianLinearTIDS>(q, v, mass);
    body->setFExtPtr(std::make_shared<SiconosVector>(3));
    nsds->insertDynamicalSystem(body);
    bodies.push_back(body);
  }
  const auto law =
      std::make_shared<NewtonImpactFrictionNSL>(set("en", 0), 0, question.number.at("friction"), 2);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Block& upper = question.blocks[k];
    for (const double side : {-1., 1.}) {
      const double margin = 1 + 1e-9;
      const double reach = k == 0 ? 1e300 : 0.5 * question.blocks[k - 1].width * margin;
      const double face = k == 0 ? 0 : 0.5 * question.blocks[k - 1].height;
      const auto on = std::make_shared<Interaction>(
          law,
          std::make_shared<PointOnFace>(0, side * 0.5 * upper.width, -0.5 * upper.height, face, 1, reach));
      if (k == 0) {
        nsds->link(on, bodies[k]);
        continue;
      }
      nsds->link(on, bodies[k], bodies[k - 1]);
      const Block& lower = question.blocks[k - 1];
      const auto under = std::make_shared<Interaction>(
          law, std::make_shared<PointOnFace>(1, side * 0.5 * lower.width, 0.5 * lower.height,
                                             -0.5 * upper.height, -1, 0.5 * upper.width * margin));
      nsds->link(under, bodies[k], bodies[k - 1]);
    }
  }
  const auto integrator = std::make_shared<MoreauJeanOSI>(set("theta", 0.5), set("gamma", 0.5));
  integrator->setConstraintActivationThreshold(set("constraintActivationThreshold", 0));
  const auto problem = std::make_shared<FrictionContact>(2, SICONOS_FRICTION_2D_NSGS);
  problem->setKeepLambdaAndYState(set("keepLambdaAndYState", 1) != 0);
  SolverOptions& options = *problem->numericsSolverOptions();
  options.dparam[SICONOS_DPARAM_TOL] = set("SICONOS_DPARAM_TOL", options.dparam[SICONOS_DPARAM_TOL]);
  options.iparam[SICONOS_IPARAM_MAX_ITER] =
      static_cast<int>(set("SICONOS_IPARAM_MAX_ITER", options.iparam[SICONOS_IPARAM_MAX_ITER]));
  const auto simulation =
      std::make_shared<TimeStepping>(nsds, std::make_shared<TimeDiscretisation>(0, dt), integrator, problem);
  simulation->setCheckSolverFunction(&pass_over);
  simulation->setWarnOnNonConvergence(false);
  const auto print = [&] {
    for (const auto& body : bodies) std::printf("%.17g ", -body->q()->getValue(2));
    std::printf("\n");
  };
  print();
  for (std::size_t step = 0; step < static_cast<std::size_t>(steps); ++step) {
    const bool shaken = step < question.shaking.size();
    for (const auto& body : bodies) {
      const double mass = body->mass()->getValue(0, 0);
      body->fExt()->setValue(0, shaken ? -mass * question.shaking[step].first : 0);
      body->fExt()->setValue(
          1, -mass * (question.number.at("gravity") + (shaken ? question.shaking[step].second : 0)));
    }
    simulation->computeOneStep();
    print();
    simulation->nextStep();
  }
}
