// DART beside the exact model. README.md in this folder says what its contacts are, what is set in both sets,
// what the tuned set changes, and why.
//
// The settings of contacts are static numbers of DART's class ContactConstraint; each step sets them anew.
// ConstraintForceMixing has no unit: it is added to one on the diagonal. ErrorReductionParameter takes that
// share of an overlap away in a step, at MaxErrorReductionVelocity at most, through the velocities. Below
// 1e-3 DART takes a coefficient of friction for zero.

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
