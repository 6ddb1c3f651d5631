// Siconos beside the exact model. README.md in this folder says what its contacts are, what is set in both
// sets, what the tuned set changes, and why.
//
// Each block is a LagrangianLinearTIDS with three coordinates, each corner over a face an Interaction with
// NewtonImpactFrictionNSL (stack.cpp). The scheme is Moreau and Jean's. gamma and
// constraintActivationThreshold choose a step's contacts: those whose gap plus gamma times the step times its
// velocity is at most the threshold. Forces and masses are constant, so that the library's Newton loop ends
// after one turn: Jacobians are those of the step's start. A ground that really moves is the part of a gap
// that depends on time alone (LagrangianRheonomousR), with the velocity of the step under way.

#include "engines/siconos/siconos.hpp"

#include <limits>

#include "engines/parameters.hpp"
#include "engines/siconos/stack.hpp"

namespace rockstack {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

class SiconosSimulation : public Simulation {
 public:
  SiconosSimulation(const Setup& setup, const Parameters& parameters)
      : shaking_(setup), stack_(setup, parameters) {}

  void step() override { stack_.step(shaking_.next()); }

  void read(std::span<double> angles, std::span<double> velocities) const override {
    for (std::size_t k = 0; k < stack_.blocks().size(); ++k) {
      angles[k] = stack_.blocks()[k].angle;
      velocities[k] = stack_.blocks()[k].angular_velocity;
    }
  }

  BodyState body(std::size_t k) const override {
    const Placement& block = stack_.blocks()[k];
    BodyState state;
    state.x = block.x;
    state.y = block.y;
    state.velocity_x = block.velocity_x;
    state.velocity_y = block.velocity_y;
    return state;
  }

  bool watch_contacts() override {
    stack_.watch();
    return true;
  }

  std::vector<ContactPoint> contacts() const override { return stack_.contacts(); }
  std::size_t warnings() const override { return stack_.failures(); }

 private:
  Shaking shaking_;
  SiconosStack stack_;
};

class Siconos : public Engine {
 public:
  std::string name() const override { return "siconos"; }
  std::string solver() const override { return "nsgs"; }
  /// Its headers do not tell; this is Debian 12's.
  std::string version() const override { return "4.4.0, double precision"; }
  std::string licence() const override { return "Apache-2.0"; }
  std::vector<Setting> settings() const override {
    return {
        {"theta", 0.5, 0.5, 0, 1},
        {"gamma", 0.5, 0.5, 0, 1},
        {"constraintActivationThreshold", 0, 1e-9, 0, endless, false, {}, "m"},
        {"SICONOS_DPARAM_TOL", 1e-4, 1e-12, 0, 1},
        {"SICONOS_IPARAM_MAX_ITER", 1000, 10000, 1, 1e9, true},
        {"keepLambdaAndYState", 1, 1, 0, 1, true},
        {"en", 0, 0, 0, 1},
        {"unitMass", 0, 1, 0, 1e12, false, {}, "kg"},
        shaking_setting(),
    };
  }
  Capabilities capabilities() const override {
    Capabilities own;
    own.planar = true;
    own.lead = 0;
    return own;
  }

 private:
  std::unique_ptr<Simulation> build(const Setup& setup, const Parameters& parameters) const override {
    return std::make_unique<SiconosSimulation>(setup, parameters);
  }
};

}  // namespace

std::vector<std::unique_ptr<Engine>> make_siconos() {
  std::vector<std::unique_ptr<Engine>> engines;
  engines.push_back(std::make_unique<Siconos>());
  return engines;
}

}  // namespace rockstack
