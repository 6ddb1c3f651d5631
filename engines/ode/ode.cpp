// The Open Dynamics Engine beside the exact model. README.md in this folder says what its contacts are, what
// is set in both sets, what the tuned set changes, and why. `comparisons/tune` ranks sets; those here also
// hold the conformance tests.
//
// contactStiffness k in N/m and contactDamping c in N s/m make each contact point a spring and a dashpot,
// through ODE's own erp = h k/(h k + c) and cfm = 1/(h k + c) of that point with the step h; where both are
// zero, the world's erp and cfm act. contactApprox1 = 1 makes the scene's friction a coefficient; with 0 the
// limit is a force, that coefficient times the stack's weight. ODE reports errors through handlers: an error
// throws from the call; a message (the solver's "s <= 0": it goes on with a step half solved) is counted as a
// warning, and the run goes on as it does for a user, who sees it printed.

#include "engines/ode/ode.hpp"

#include <ode/ode.h>

#include <limits>

#include "engines/ode/simulation.hpp"
#include "engines/parameters.hpp"

namespace rockstack {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// N/m and N s/m: far beyond what a step resolves, and finite, as quotients of stiffness and damping are
/// taken.
constexpr double stiffest = 1e18;

std::vector<Setting> settings_of(OdeSolver solver) {
  std::vector<Setting> settings{
      {"erp", 0.2, 0.01, 0, 1},
      {"cfm", 1e-10, 1e-6, 0, endless, false, {}, "s/kg"},
      {"contactSurfaceLayer", 0, 0, 0, endless, false, {}, "m"},
      {"contactMaxCorrectingVel", endless, endless, 0, endless, false, {}, "m/s"},
      {"maxContacts", 8, 8, 1, 64, true},
      {"contactApprox1", 1, 1, 0, 1, true},
      {"contactMu2", 0, 1, 0, 1, true},
      {"finiteRotationMode", 0, 0, 0, 1, true},
      {"bounce", 0, 0, 0, 1},
      {"bounce_vel", 0, 0, 0, endless, false, {}, "m/s"},
      {"contactStiffness", 0, 0, 0, stiffest, false, {}, "N/m"},
      {"contactDamping", 0, 0, 0, stiffest, false, {}, "N s/m"},
      {"slip1", 0, 0, 0, endless, false, {}, "m/(N s)"},
      {"unitMass", 0, 1, 0, 1e12, false, {}, "kg"},
      {"realign", 1, 1, 0, 1, true},
      shaking_setting(),
  };
  if (solver == OdeSolver::quickstep) {
    settings.push_back({"quickStepNumIterations", 20, 100, 1, 1e6, true});
    settings.push_back({"quickStepW", 1.3, 1.3, 0, 2});
    settings.push_back({"randomSeed", 0, 0, 0, 4294967295.0, true});
  }
  return settings;
}

class Ode : public Engine {
 public:
  explicit Ode(OdeSolver solver) : solver_(solver) {}
  std::string name() const override { return "ode"; }
  std::string solver() const override { return solver_ == OdeSolver::step ? "step" : "quickstep"; }
  std::string version() const override { return dODE_VERSION ", double precision"; }
  std::string licence() const override { return "BSD-3-Clause OR LGPL-2.1-or-later"; }
  std::vector<Setting> settings() const override { return settings_of(solver_); }

 private:
  std::unique_ptr<Simulation> build(const Setup& setup, const Parameters& parameters) const override {
    return start_ode(solver_, setup, parameters);
  }

  OdeSolver solver_;
};

}  // namespace

std::vector<std::unique_ptr<Engine>> make_ode() {
  std::vector<std::unique_ptr<Engine>> engines;
  for (const OdeSolver solver : {OdeSolver::step, OdeSolver::quickstep}) {
    engines.push_back(std::make_unique<Ode>(solver));
  }
  return engines;
}

}  // namespace rockstack
