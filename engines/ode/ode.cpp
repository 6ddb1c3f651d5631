// The Open Dynamics Engine beside the exact model; README.md says what its contacts are and why its sets are
// as they are. `comparisons/tune` ranks sets; those here also hold the conformance tests.

#include <ode/ode.h>

#include "engines/ode/simulation.hpp"

namespace rockstack {
namespace {

std::vector<Setting> settings_of(OdeSolver solver) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  std::vector<Setting> settings{
      {.name = "erp", .standard = 0.2, .tuned = 0.01, .most = 1},
      {.name = "cfm", .unit = "s/kg", .standard = 1e-10, .tuned = 1e-6},
      {.name = "contactSurfaceLayer", .unit = "m"},
      {.name = "contactMaxCorrectingVel", .unit = "m/s", .standard = endless},
      {.name = "maxContacts", .standard = 8, .least = 1, .most = 64, .whole = true},
      switch_setting("contactApprox1", true, true),
      switch_setting("contactMu2", false, true),
      switch_setting("finiteRotationMode", false, false),
      {.name = "bounce", .most = 1, .role = SettingRole::restitution},
      {.name = "bounce_vel", .unit = "m/s", .role = SettingRole::restitution_threshold},
      {.name = "contactStiffness", .unit = "N/m", .most = stiffest},
      {.name = "contactDamping", .unit = "N s/m", .most = stiffest},
      {.name = "slip1", .unit = "m/(N s)"},
      {.name = "unitMass", .unit = "kg", .tuned = 1, .most = 1e12},
      switch_setting("realign", true, true),
      shaking_setting(),
  };
  if (solver == OdeSolver::quickstep) {
    settings.push_back(count_setting("quickStepNumIterations", 20, 100));
    settings.push_back({.name = "quickStepW", .standard = 1.3, .most = 2});
    settings.push_back({.name = "randomSeed", .most = 4294967295.0, .whole = true});
  }
  return settings;
}

Engine with(OdeSolver solver) {
  return {{.name = "ode",
           .solver = solver == OdeSolver::step ? "step" : "quickstep",
           .version = dODE_VERSION ", double precision",
           .licence = "BSD-3-Clause OR LGPL-2.1-or-later",
           .settings = settings_of(solver)},
          std::bind_front(start_ode, solver)};
}

}  // namespace

std::vector<Engine> make_ode() {
  return {with(OdeSolver::step), with(OdeSolver::quickstep)};
}

}  // namespace rockstack
