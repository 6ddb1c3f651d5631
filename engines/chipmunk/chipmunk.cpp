// Chipmunk beside the exact model. README.md in this folder says what its contacts are, what is set in both
// sets, what the tuned set changes, and why.
//
// A step moves bodies by the velocities that they have, then finds contacts, then changes velocities. So
// smooth motion is half a step late where other engines' is half a step early, and an impact comes when the
// overlap is found. A ground that really moves has its next step's velocity when contacts are solved, which
// is what blocks must follow. With collisionPersistence = 0 the library frees what it is using.

#include "engines/chipmunk/chipmunk.hpp"

#include <chipmunk/chipmunk.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "engines/chipmunk/simulation.hpp"

namespace rockstack {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

class Chipmunk : public Engine {
 public:
  std::string name() const override { return "chipmunk"; }
  std::string solver() const override { return "sequential-impulse"; }
  std::string version() const override { return fmt::format("{}, double precision", cpVersionString); }
  std::string licence() const override { return "MIT"; }
  Capabilities capabilities() const override { return {.planar = true, .lead = -0.5}; }
  std::vector<Setting> settings() const override {
    const double bias = std::pow(1 - 0.1F, 60);
    return {{"iterations", 10, 50, 1, 1e6, true}, {"collisionSlop", 0.1F, 1e-4, 0, endless, false, {}, "m"},
            {"collisionBias", bias, bias, 0, 1},  {"collisionPersistence", 3, 3, 1, 1e6, true},
            {"elasticity", 0, 0, 0, 1},           shaking_setting()};
  }

 private:
  std::unique_ptr<Simulation> build(const Setup& setup, const Parameters& parameters) const override {
    return start_chipmunk(setup, parameters);
  }
};

}  // namespace

std::vector<std::unique_ptr<Engine>> make_chipmunk() {
  std::vector<std::unique_ptr<Engine>> engines;
  engines.push_back(std::make_unique<Chipmunk>());
  return engines;
}

}  // namespace rockstack
