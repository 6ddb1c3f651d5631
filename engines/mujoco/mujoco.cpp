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

#include "engines/mujoco/mujoco.hpp"

#include <mujoco/mujoco.h>

#include <limits>
#include <string>

#include "engines/mujoco/simulation.hpp"
#include "engines/parameters.hpp"

namespace rockstack {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// Of solref, where a negative number is a stiffness or a damping.
constexpr double stiffest = 1e18;

std::vector<Setting> settings_of(MujocoSolver solver) {
  return {
      {"integrator", 0, 0, 0, 2, true, {"Euler", "RK4", "implicit"}},
      {"cone", 1, 1, 0, 1, true, {"pyramidal", "elliptic"}},
      {"solref_timeconst", 0.02, 1e-3, -stiffest, stiffest, false, {}, "s"},
      {"solref_dampratio", 1, solver == MujocoSolver::pgs ? 6.0 : 3.0, -stiffest, stiffest},
      {"solimp_d0", 0.9, 0.995, 0, 1},
      {"solimp_dwidth", 0.95, 0.995, 0, 1},
      {"solimp_width", 1e-3, 1e-3, 0, endless, false, {}, "m"},
      {"solimp_midpoint", 0.5, 0.5, 0, 1},
      {"solimp_power", 2, 2, 1, endless},
      {"margin", 0, 0, 0, endless, false, {}, "m"},
      {"gap", 0, 0, 0, endless, false, {}, "m"},
      {"impratio", 1, 1, 1e-6, 1e6},
      {"iterations", 100, solver == MujocoSolver::pgs ? 300.0 : 100.0, 1, 1e6, true},
      {"tolerance", 1e-8, 1e-12, 0, 1},
      {"noslip_iterations", 0, 0, 0, 1e6, true},
      {"noslip_tolerance", 1e-6, 1e-6, 0, 1},
      {"refsafe", 1, 1, 0, 1, true},
      {"warmstart", 1, 1, 0, 1, true},
      {"ground", 0, 0, 0, 1, true, {"plane", "box"}},
      {"depth_ratio", 1, 0.9, 0.1, 10},
      {"unitMass", 0, 1, 0, 1e12, false, {}, "kg"},
      shaking_setting(),
  };
}

class Mujoco : public Engine {
 public:
  explicit Mujoco(MujocoSolver solver) : solver_(solver) {}
  std::string name() const override { return "mujoco"; }
  std::string solver() const override {
    switch (solver_) {
      case MujocoSolver::pgs:
        return "pgs";
      case MujocoSolver::cg:
        return "cg";
      case MujocoSolver::newton:
        return "newton";
    }
    return "";
  }
  std::string version() const override { return std::string(mj_versionString()) + ", double precision"; }
  std::string licence() const override { return "Apache-2.0"; }
  Capabilities capabilities() const override {
    Capabilities able;
    able.planar = true;
    return able;
  }
  std::vector<Setting> settings() const override { return settings_of(solver_); }

 private:
  std::unique_ptr<Simulation> build(const Setup& setup, const Parameters& parameters) const override {
    return start_mujoco(solver_, setup, parameters);
  }

  MujocoSolver solver_;
};

}  // namespace

std::vector<std::unique_ptr<Engine>> make_mujoco() {
  std::vector<std::unique_ptr<Engine>> engines;
  for (const MujocoSolver solver : {MujocoSolver::newton, MujocoSolver::cg, MujocoSolver::pgs}) {
    engines.push_back(std::make_unique<Mujoco>(solver));
  }
  return engines;
}

}  // namespace rockstack
