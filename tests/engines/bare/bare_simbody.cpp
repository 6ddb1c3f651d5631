// A stack of blocks in Simbody by Simbody's headers alone: nothing of this project is read here, so that its
// adapter can be held to it. What is not set stays as the library has it. Standard input has words:
//
//   solver compliant                   (there is one)
//   gravity 9.81  friction 1000  dt 0.001  steps 500  reach 100
//   block 1.25 1.25 1 3906 834 834 1017 0 0.6 0.15
//     of each block from the bottom up: width, height, depth (m), mass (kg), moments of inertia about x, y
//     and z (kg m²), centre x, y (m), angle (rad)
//   set accuracy 1e-4                  (whatever Simbody can be told)
//   shake 0.5 -0.1                     (the ground's acceleration right and up, m/s², one a step)
//
// Standard output has a line a step, the start first: the angles in rad, clockwise positive.

#include <Simbody.h>

#include <cstddef>
#include <cstdio>
#include <exception>
#include <iostream>
#include <map>
#include <memory>
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
  std::vector<Block> blocks;
  std::map<std::string, double> set;
  std::vector<std::pair<double, double>> shaking;

  double setting(const std::string& name, double default_value) const {
    const auto found = set.find(name);
    return found == set.end() ? default_value : found->second;
  }
};

bool read(std::istream& in, Question& question) {
  for (std::string word; in >> word;) {
    if (word == "solver") {
      in >> word;
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

using SimTK::MobilizedBody;
using SimTK::Transform;
using SimTK::Vec3;

/// The library's half spaces lie on the positive side of their x axis.
Transform half_space(double y, bool above) {
  return {SimTK::Rotation(SimTK::UnitVec3(0, above ? 1 : -1, 0), SimTK::XAxis), Vec3(0, y, 0)};
}

class Stack {
 public:
  explicit Stack(const Question& question)
      : matter_(system_),
        forces_(system_),
        tracker_(system_),
        contact_(system_, tracker_),
        gravity_(forces_, matter_, Vec3(0, -question.number.at("gravity"), 0)),
        bricks_(SimTK::ContactSurface::createNewContactClique()),
        half_spaces_(SimTK::ContactSurface::createNewContactClique()) {
    contact_.setTransitionVelocity(question.setting("transition_velocity", 0.01));
    for (std::size_t k = 0; k < question.blocks.size(); ++k)
      cliques_.push_back(SimTK::ContactSurface::createNewContactClique());
    std::vector<SimTK::Body::Rigid> bodies;
    for (const Block& block : question.blocks) {
      bodies.emplace_back(SimTK::MassProperties(block.mass, Vec3(0),
                                                SimTK::Inertia(block.about_x, block.about_y, block.about_z)));
    }
    const SimTK::ContactMaterial material(question.setting("stiffness", 1e8),
                                          question.setting("dissipation", 1), question.number.at("friction"),
                                          question.number.at("friction"));
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const Block& upper = question.blocks[k];
      const bool narrow = k > 0 && question.blocks[k - 1].width < upper.width;
      const Block& lower = question.blocks[k == 0 ? 0 : k - 1];
      SimTK::Body& below = k == 0 ? matter_.Ground().updBody() : bodies[k - 1];
      if (narrow) {
        add_half_space(bodies[k], half_space(-upper.height / 2, true), material, k);
        add_brick(below, lower, material, k);
      } else {
        add_half_space(below, half_space(k == 0 ? 0 : lower.height / 2, false), material, k);
        add_brick(bodies[k], upper, material, k);
      }
    }
    for (const SimTK::Body::Rigid& body : bodies)
      blocks_.emplace_back(matter_.Ground(), Transform(), body, Transform());
    state_ = system_.realizeTopology();
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      const Block& block = question.blocks[k];
      blocks_[k].setQ(state_, Vec3(-block.angle, block.x, block.y));
    }
    integrator_ = make(question.setting("integrator", 0));
    integrator_->setAccuracy(question.setting("accuracy", 1e-3));
    integrator_->setAllowInterpolation(false);
    integrator_->initialize(state_);
  }

  void shake(double x, double y) {
    gravity_.setGravityVector(integrator_->updAdvancedState(), Vec3(x, y, 0));
  }

  void advance(double time) {
    while (integrator_->getTime() < time) integrator_->stepTo(time);
  }

  void print() const {
    for (const MobilizedBody::Planar& block : blocks_)
      std::printf("%.17g ", -block.getOneQ(integrator_->getState(), 0));
    std::printf("\n");
  }

 private:
  std::unique_ptr<SimTK::Integrator> make(double integrator) const {
    if (integrator == 1) return std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system_);
    if (integrator == 2) return std::make_unique<SimTK::RungeKutta3Integrator>(system_);
    if (integrator == 3) return std::make_unique<SimTK::VerletIntegrator>(system_);
    return std::make_unique<SimTK::CPodesIntegrator>(system_, SimTK::CPodes::BDF);
  }

  /// What shares a clique never touches: of each interface only its own half space and brick do.
  void add_half_space(SimTK::Body& body, const Transform& place, const SimTK::ContactMaterial& material,
                      std::size_t interface) {
    SimTK::ContactSurface surface(SimTK::ContactGeometry::HalfSpace(), material);
    surface.joinClique(half_spaces_);
    surface.joinClique(cliques_[interface]);
    body.addContactSurface(place, surface);
  }

  void add_brick(SimTK::Body& body, const Block& block, const SimTK::ContactMaterial& material,
                 std::size_t interface) {
    SimTK::ContactSurface surface(
        SimTK::ContactGeometry::Brick(Vec3(block.width / 2, block.height / 2, block.depth / 2)), material);
    surface.joinClique(bricks_);
    for (std::size_t k = 0; k < cliques_.size(); ++k) {
      if (k != interface) surface.joinClique(cliques_[k]);
    }
    body.addContactSurface(Transform(), surface);
  }

  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  SimTK::ContactTrackerSubsystem tracker_;
  SimTK::CompliantContactSubsystem contact_;
  SimTK::Force::Gravity gravity_;
  SimTK::ContactCliqueId bricks_, half_spaces_;
  std::vector<SimTK::ContactCliqueId> cliques_;
  std::vector<MobilizedBody::Planar> blocks_;
  SimTK::State state_;
  std::unique_ptr<SimTK::Integrator> integrator_;
};

}  // namespace

int main() try {
  Question question;
  if (!read(std::cin, question)) return 2;
  Stack stack(question);
  stack.print();
  for (std::size_t step = 0; step < static_cast<std::size_t>(question.number.at("steps")); ++step) {
    if (step < question.shaking.size()) {
      stack.shake(-question.shaking[step].first,
                  -question.number.at("gravity") - question.shaking[step].second);
    }
    stack.advance(static_cast<double>(step + 1) * question.number.at("dt"));
    stack.print();
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
