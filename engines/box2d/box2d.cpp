// Box2D beside the exact model: what is set, and why.
//
// The same in both sets, as the question asks for it: no sleeping, no damping, no restitution. Blocks and
// ground are boxes. Box2D takes the root of the product of two fixtures' friction; each interface has a
// coefficient of its own here, given in the library's call for a pair that is about to be solved. The library
// is planar by nature and works in single precision. Debian's build has its assertions in (it stops the
// process at a number that is none).
//
// Box2D's tolerances are lengths fixed when it is compiled, in units that are meant to be metres: an overlap
// of b2_linearSlop, 0.005, is left alone; b2_polygonRadius, 0.01, is a skin around each polygon; a body moves
// by b2_maxTranslation, 2, in a step at most, and its velocity is cut to that. lengthUnit says how many
// metres that unit is, by which no angle changes but for these lengths. polygonRadius is the skin, in that
// unit; the library takes it from each shape.
//
// What was measured of every setting: engines/README.md.
//
// Tuned sets are those of comparisons/tune with the least errors that also hold the conformance tests
// (engines/README.md has the ranking).
//
// Tuned: no skin, because corners with one roll on it, and blocks that are placed where they touch overlap by
// two of them and are pushed apart as they rock. lengthUnit 2 cm, so that 0.1 mm of overlap is left alone
// rather than 5 mm, and velocities are cut at 10 m/s at a step of 4 ms. 50 velocityIterations: 8 leave 4 mrad
// at the second peak at 1e-4 s. No continuousPhysics: without a skin it takes up to eight sub-steps for each
// contact and changes next to nothing. positionIterations stay: Box2D leaves off after the first while no
// overlap is above three slops.

#include "engines/box2d/box2d.hpp"

#include <box2d/box2d.h>

#include <limits>

#include "engines/box2d/simulation.hpp"

namespace rockstack {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

class Box2D : public Engine {
 public:
  std::string name() const override { return "box2d"; }
  std::string solver() const override { return "sequential-impulse"; }
  std::string version() const override { return BOX2D_VERSION ", single precision"; }
  std::string licence() const override { return "MIT"; }
  Capabilities capabilities() const override { return {.single_precision = true, .planar = true}; }
  std::vector<Setting> settings() const override {
    return {{"velocityIterations", 8, 50, 1, 1e6, true},
            {"positionIterations", 3, 3, 0, 1e6, true},
            {"warmStarting", 1, 1, 0, 1, true},
            {"continuousPhysics", 1, 0, 0, 1, true},
            {"polygonRadius", b2_polygonRadius, 0, 0, 1e3},
            {"restitution", 0, 0, 0, 1},
            {"restitutionThreshold", 1, 1, 0, endless},
            {"lengthUnit", 1, 0.02, 1e-6, 1e6, false, {}, "m"},
            shaking_setting()};
  }

 private:
  std::unique_ptr<Simulation> build(const Setup& setup, const Parameters& parameters) const override {
    return start_box2d(setup, parameters);
  }
};

}  // namespace

std::vector<std::unique_ptr<Engine>> make_box2d() {
  std::vector<std::unique_ptr<Engine>> engines;
  engines.push_back(std::make_unique<Box2D>());
  return engines;
}

}  // namespace rockstack
