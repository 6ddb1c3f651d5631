// DART beside the exact model. README.md in this folder says what its contacts are, what is set in both sets,
// what the tuned set changes, and why.
//
// The settings of contacts are static numbers of DART's class ContactConstraint; each step sets them anew.
// ConstraintForceMixing has no unit: it is added to one on the diagonal. ErrorReductionParameter takes that
// share of an overlap away in a step, at MaxErrorReductionVelocity at most, through the velocities. Below
// 1e-3 DART takes a coefficient of friction for zero.

#include "engines/dart/simulation.hpp"

namespace rockstack {
namespace {

std::vector<Setting> settings_of(DartSolver solver) {
  std::vector<Setting> settings{
      {.name = "collisionDetector", .choices = {"fcl", "dart"}, .tuned = 1},
      {.name = "ErrorAllowance", .unit = "m"},
      {.name = "ErrorReductionParameter", .standard = 0.01, .most = 1},
      {.name = "MaxErrorReductionVelocity", .unit = "m/s", .standard = 1e-3},
      {.name = "ConstraintForceMixing", .standard = 1e-5, .least = 1e-9, .most = 1},
      {.name = "RestitutionCoeff", .most = 1},
      {.name = "unitMass", .unit = "kg", .most = 1e12},
      shaking_setting(),
  };
  if (solver == DartSolver::pgs) {
    settings.push_back(
        {.name = "MaxIteration", .standard = 30, .tuned = 300, .least = 1, .most = 1e6, .whole = true});
    settings.push_back({.name = "DeltaXThreshold", .unit = "N s", .standard = 1e-6});
    settings.push_back({.name = "RelativeDeltaXTolerance", .standard = 1e-3, .tuned = 1e-6, .most = 1});
  }
  return settings;
}

Engine with(DartSolver solver) {
  return {{.name = "dart",
           .solver = solver == DartSolver::dantzig ? "dantzig" : "pgs",
           .version = dart_version() + ", double precision",
           .licence = "BSD-2-Clause",
           .capabilities = {.planar = true},
           .settings = settings_of(solver)},
          [solver](const Setup& setup, const Parameters& parameters) {
            return start_dart(solver, setup, parameters);
          }};
}

}  // namespace

std::vector<Engine> make_dart() {
  return {with(DartSolver::dantzig), with(DartSolver::pgs)};
}

}  // namespace rockstack
