// Box2D beside the exact model. README.md in this folder says what its contacts are, what is set in both
// sets, what the tuned set changes, and why.
//
// Box2D's tolerances are lengths fixed when it is compiled, in units that are meant to be metres:
// b2_linearSlop, b2_polygonRadius, b2_maxTranslation. lengthUnit says how many metres that unit is, by which
// no angle changes but for these lengths. polygonRadius is the skin, in that unit; the library takes it from
// each shape.

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
