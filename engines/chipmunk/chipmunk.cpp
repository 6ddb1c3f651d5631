// Chipmunk beside the exact model: what is set, and why.
//
// The same in both sets, as the question asks for it: no sleeping, no damping, no elasticity. Blocks are
// boxes without a radius, the ground a segment without one. Chipmunk multiplies the two shapes' friction;
// each interface has a coefficient of its own here, given in the library's call for a pair that is about to
// be solved. The library is planar by nature and works in double precision. Debian's build has its assertions
// in (it greets on standard output, and stops the process at a number that is none).
//
// A step moves bodies by the velocities that they have, then finds contacts, then changes velocities. So
// smooth motion is half a step late where other engines' is half a step early, and an impact comes when the
// overlap is found. Overlaps go by pseudo velocities that last one step: nothing bounces by them. A ground
// that really moves has its next step's velocity when contacts are solved, which is what blocks must follow.
//
// What was measured of every setting: engines/README.md.
//
// Tuned sets are those of comparisons/tune with the least errors that also hold the conformance tests
// (engines/README.md has the ranking).
//
// Tuned: collisionSlop 1e-4 m, because the default, 0.1, suits scenes in pixels: as metres it leaves every
// overlap alone. With none at all an overlap is pushed out until the point is off, and the block falls back:
// one that is pushed weakly turns twice as far as a step's fall. 50 iterations: 10 let a flat block turn.
// collisionBias, the share of an overlap that is left after a second, stays, and so does
// collisionPersistence, the number of steps for which contacts that parted are remembered (with 0 the library
// frees what it is using, and blocks fall through the ground).

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
