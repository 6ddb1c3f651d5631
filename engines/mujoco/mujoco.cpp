// MuJoCo beside the exact model. README.md in this folder says what its contacts are, what is set in both
// sets, what the tuned set changes, and why.
//
// Contacts are soft by design. Each row pushes by f = (−b v − k d r − a)/R, where r is the gap, v and a are
// its rate and acceleration (MuJoCo's documentation, Computation: Constraint model; XML reference: solref,
// solimp). d is the impedance, which solimp makes of r; k = 1/(d₁ τ ζ)² and b = 2/(d₁ τ) with τ =
// solref_timeconst, ζ = solref_dampratio and d₁ = solimp_dwidth, or their negative values over d₁² and d₁; R
// = (1 − d)/d Â, Â = 2/3 (1/m + 1/M) with the masses of both bodies: the mean over three directions, in one
// of which nothing moves. So a contact at rest is a spring of k d/R and a dashpot of b/R: with d = d₁ between
// a block and the ground 1.5 m/((1 − d) τ² ζ²) N/m and 3 m/((1 − d) τ) N s/m a point, which contacts() tells.
// With refsafe τ is at least two steps. The defaults are for blocks of 1250 kg 4.2e7 N/m and 1.8e6 N s/m.
//
// depth_ratio: how deep a block's box is over the one below it, out of the plane, where nothing depends on
// it. A coefficient of friction of 0 makes a contact without friction (condim 1); below 1e-5 it is 1e-5. A
// moving ground is a box on two slides with 1e30 kg of armature, on which gravity does not act. Where a
// coordinate stops being finite MuJoCo begins anew from its first state; here the run ends with an error.
// What it warns of is counted and not printed.

#include <mujoco/mujoco.h>

#include <string>

#include "engines/engine.hpp"
#include "engines/mujoco/simulation.hpp"

namespace rockstack {
namespace {

/// Of solref, where a negative number is a stiffness or a damping.
constexpr double stiffest = 1e18;

std::vector<Setting> settings_of(MujocoSolver solver) {
  const bool pgs = solver == MujocoSolver::pgs;
  return {
      {.name = "integrator", .choices = {"Euler", "RK4", "implicit"}},
      {.name = "cone", .choices = {"pyramidal", "elliptic"}, .standard = 1},
      {.name = "solref_timeconst",
       .unit = "s",
       .standard = 0.02,
       .tuned = 1e-3,
       .least = -stiffest,
       .most = stiffest},
      {.name = "solref_dampratio",
       .standard = 1,
       .tuned = pgs ? 6.0 : 3.0,
       .least = -stiffest,
       .most = stiffest},
      {.name = "solimp_d0", .standard = 0.9, .tuned = 0.995, .most = 1},
      {.name = "solimp_dwidth", .standard = 0.95, .tuned = 0.995, .most = 1},
      {.name = "solimp_width", .unit = "m", .standard = 1e-3},
      {.name = "solimp_midpoint", .standard = 0.5, .most = 1},
      {.name = "solimp_power", .standard = 2, .least = 1},
      {.name = "margin", .unit = "m"},
      {.name = "gap", .unit = "m"},
      {.name = "impratio", .standard = 1, .least = 1e-6, .most = 1e6},
      {.name = "iterations",
       .standard = 100,
       .tuned = pgs ? 300.0 : 100.0,
       .least = 1,
       .most = 1e6,
       .whole = true},
      {.name = "tolerance", .standard = 1e-8, .tuned = 1e-12, .most = 1},
      {.name = "noslip_iterations", .most = 1e6, .whole = true},
      {.name = "noslip_tolerance", .standard = 1e-6, .most = 1},
      switch_setting("refsafe", true, true),
      switch_setting("warmstart", true, true),
      {.name = "ground", .choices = {"plane", "box"}},
      {.name = "depth_ratio", .standard = 1, .tuned = 0.9, .least = 0.1, .most = 10},
      {.name = "unitMass", .unit = "kg", .tuned = 1, .most = 1e12},
      shaking_setting(),
  };
}

Engine with(MujocoSolver solver, const char* name) {
  return {{.name = "mujoco",
           .solver = name,
           .version = std::string(mj_versionString()) + ", double precision",
           .licence = "Apache-2.0",
           .capabilities = {.planar = true},
           .settings = settings_of(solver)},
          [solver](const Setup& setup, const Parameters& parameters) {
            return start_mujoco(solver, setup, parameters);
          }};
}

}  // namespace

std::vector<Engine> make_mujoco() {
  return {with(MujocoSolver::newton, "newton"), with(MujocoSolver::cg, "cg"), with(MujocoSolver::pgs, "pgs")};
}

}  // namespace rockstack
