// DART beside the exact model: what is set, and why.
//
// The same in both sets, as the question asks for it: each block is a skeleton with one PlanarJoint, whose
// three coordinates keep it in the plane; no bounce. DART takes the lesser of both shapes' coefficients of
// friction for a contact, so that one shape a block could not have two interfaces of their own. Here each
// block has two boxes, its lower and its upper half, each with the coefficient of the interface that it
// belongs to. Below 1e-3 DART takes a coefficient for zero. The ground is a box: a weld holds it, or where it
// really moves a TranslationalJoint with the actuator VELOCITY.
//
// collisionDetector: "fcl" is the library's choice, "dart" the one of box on box that comes with it. Here FCL
// takes boxes for meshes: some corners of a face on a face come several times, others with a depth of 1 m and
// no normal, which DART leaves out. With it the base meets the ground 9 steps early at 1e-3 s.
//
// The settings of contacts are static numbers of DART's class ContactConstraint; each step sets them anew.
// ConstraintForceMixing has no unit: it is added to one on the diagonal. ErrorReductionParameter takes that
// share of an overlap away in a step, at MaxErrorReductionVelocity at most, through the velocities.
//
// Tuned: the detector "dart". "pgs" has 300 iterations and a tolerance of 1e-6: with the library's 1e-3 it
// stops where a push that is too weak to rock a block still turns it, by twice a step's fall.
//
// What was measured of every setting: engines/README.md.

#include "engines/dart/dart.hpp"

#include <limits>

#include "engines/dart/simulation.hpp"
#include "engines/parameters.hpp"

namespace rockstack {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

std::vector<Setting> settings_of(DartSolver solver) {
  std::vector<Setting> settings{
      {"collisionDetector", 0, 1, 0, 1, true, {"fcl", "dart"}},
      {"ErrorAllowance", 0, 0, 0, endless, false, {}, "m"},
      {"ErrorReductionParameter", 0.01, 0.01, 0, 1},
      {"MaxErrorReductionVelocity", 1e-3, 1e-3, 0, endless, false, {}, "m/s"},
      {"ConstraintForceMixing", 1e-5, 1e-5, 1e-9, 1},
      {"RestitutionCoeff", 0, 0, 0, 1},
      {"unitMass", 0, 0, 0, 1e12, false, {}, "kg"},
      shaking_setting(),
  };
  if (solver == DartSolver::pgs) {
    settings.push_back({"MaxIteration", 30, 300, 1, 1e6, true});
    settings.push_back({"DeltaXThreshold", 1e-6, 1e-6, 0, endless, false, {}, "N s"});
    settings.push_back({"RelativeDeltaXTolerance", 1e-3, 1e-6, 0, 1});
  }
  return settings;
}

class Dart : public Engine {
 public:
  explicit Dart(DartSolver solver) : solver_(solver) {}
  std::string name() const override { return "dart"; }
  std::string solver() const override { return solver_ == DartSolver::dantzig ? "dantzig" : "pgs"; }
  std::string version() const override { return dart_version() + ", double precision"; }
  std::string licence() const override { return "BSD-2-Clause"; }
  std::vector<Setting> settings() const override { return settings_of(solver_); }
  Capabilities capabilities() const override {
    Capabilities own;
    own.planar = true;
    return own;
  }

 private:
  std::unique_ptr<Simulation> build(const Setup& setup, const Parameters& parameters) const override {
    return start_dart(solver_, setup, parameters);
  }

  DartSolver solver_;
};

}  // namespace

std::vector<std::unique_ptr<Engine>> make_dart() {
  std::vector<std::unique_ptr<Engine>> engines;
  for (const DartSolver solver : {DartSolver::dantzig, DartSolver::pgs}) {
    engines.push_back(std::make_unique<Dart>(solver));
  }
  return engines;
}

}  // namespace rockstack
