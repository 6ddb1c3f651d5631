// Siconos beside the exact model. README.md in this folder says what its contacts are, what is set in both
// sets, what the tuned set changes, and why.
//
// Each block is a LagrangianLinearTIDS with three coordinates, each corner over a face an Interaction with
// NewtonImpactFrictionNSL (stack.cpp). The scheme is Moreau and Jean's. gamma and
// constraintActivationThreshold choose a step's contacts: those whose gap plus gamma times the step times its
// velocity is at most the threshold. Forces and masses are constant, so that the library's Newton loop ends
// after one turn: Jacobians are those of the step's start. A ground that really moves is the part of a gap
// that depends on time alone (LagrangianRheonomousR), with the velocity of the step under way.

#include "engines/engine.hpp"
#include "engines/shaking.hpp"
#include "engines/siconos/stack.hpp"

namespace rockstack {
namespace {

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

}  // namespace

std::vector<Engine> make_siconos() {
  return {{{.name = "siconos",
            .solver = "nsgs",
            .version = "4.4.0, double precision",  // of Debian 12: its headers do not tell
            .licence = "Apache-2.0",
            .capabilities = {.planar = true, .lead = 0},
            .settings = {{.name = "theta", .standard = 0.5, .most = 1},
                         {.name = "gamma", .standard = 0.5, .most = 1},
                         {.name = "constraintActivationThreshold", .unit = "m", .tuned = 1e-9},
                         {.name = "SICONOS_DPARAM_TOL", .standard = 1e-4, .tuned = 1e-12, .most = 1},
                         {.name = "SICONOS_IPARAM_MAX_ITER",
                          .standard = 1000,
                          .tuned = 10000,
                          .least = 1,
                          .most = 1e9,
                          .whole = true},
                         switch_setting("keepLambdaAndYState", true, true),
                         {.name = "en", .most = 1},
                         {.name = "unitMass", .unit = "kg", .tuned = 1, .most = 1e12},
                         shaking_setting()}},
           [](const Setup& setup, const Parameters& parameters) {
             return std::make_unique<SiconosSimulation>(setup, parameters);
           }}};
}

}  // namespace rockstack
