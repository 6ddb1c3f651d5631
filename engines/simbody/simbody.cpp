// Simbody beside the exact model. README.md in this folder says what its contacts are, what is set in both
// sets, what the tuned set changes, and why.
//
// Its contact is compliant: CompliantContactSubsystem between a brick and a half space. Each corner of the
// brick that is in the half space by x is pushed out by k x (1 + c x'), never pulled, with k half of
// `stiffness`, as both surfaces give way alike, and c = `dissipation` (Hunt and Crossley 1975). At each
// interface the narrower block is the brick. k and k c x are told of each contact. The ground's motion is a
// body force: a moving ground's velocity jumps from step to step, on which CPodes gives up.

#include "engines/simbody/simbody.hpp"

#include <limits>

#include "engines/parameters.hpp"
#include "engines/shaking.hpp"
#include "engines/simbody/world.hpp"

namespace rockstack {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

class SimbodySimulation : public Simulation {
 public:
  SimbodySimulation(const Setup& setup, const Parameters& parameters)
      : shaking_(setup), world_(setup, parameters) {}

  void step() override { world_.step(shaking_.next()); }

  void read(std::span<double> angles, std::span<double> velocities) const override {
    for (std::size_t k = 0; k < angles.size(); ++k) {
      const PlanarState state = world_.block(k);
      angles[k] = -state.angle;
      velocities[k] = -state.angular_velocity;
    }
  }

  BodyState body(std::size_t k) const override {
    const PlanarState state = world_.block(k);
    BodyState body;
    body.x = state.x;
    body.y = state.y;
    body.velocity_x = state.velocity_x;
    body.velocity_y = state.velocity_y;
    return body;
  }

  bool watch_contacts() override { return true; }
  std::vector<ContactPoint> contacts() const override { return world_.contacts(); }

 private:
  Shaking shaking_;
  SimbodyWorld world_;
};

class Simbody : public Engine {
 public:
  std::string name() const override { return "simbody"; }
  std::string solver() const override { return "compliant"; }
  std::string version() const override { return SIMBODY_VERSION ", double precision"; }
  std::string licence() const override { return "Apache-2.0"; }
  Capabilities capabilities() const override {
    Capabilities able;
    able.planar = true;
    able.lead = 0;
    return able;
  }
  std::vector<Setting> settings() const override {
    return {
        {"integrator", 0, 0, 0, 3, true, {"CPodes", "RungeKuttaMerson", "RungeKutta3", "Verlet"}},
        {"accuracy", 1e-3, 1e-7, 1e-12, 0.1},
        {"stiffness", 1e8, 1e8, 1e-18, 1e18, false, {}, "N/m"},
        {"dissipation", 1, 5e4, 0, endless, false, {}, "s/m"},
        {"transition_velocity", 0.01, 1e-4, 1e-12, endless, false, {}, "m/s"},
        {"unitMass", 0, 1, 0, 1e12, false, {}, "kg"},
    };
  }

 private:
  std::unique_ptr<Simulation> build(const Setup& setup, const Parameters& parameters) const override {
    return std::make_unique<SimbodySimulation>(setup, parameters);
  }
};

}  // namespace

std::vector<std::unique_ptr<Engine>> make_simbody() {
  std::vector<std::unique_ptr<Engine>> engines;
  engines.push_back(std::make_unique<Simbody>());
  return engines;
}

}  // namespace rockstack
