// Bullet beside the exact model. README.md in this folder says what its contacts are, what is set in both
// sets, what the tuned set changes, and why. `comparisons/tune` ranks sets; those here also hold the
// conformance tests.
//
// contactStiffness k in N/m and contactDamping c in N s/m make each contact point a spring and a dashpot,
// through Bullet's own erp = h k/(h k + c) and cfm = 1/(h k + c) with the step h; where both are zero, erp2
// and globalCfm act. Only an overlap that goes through the velocities is a spring: splitImpulse = 0, or above
// its threshold. Bullet's erp and frictionCFM are not here: without joints they change no digit; frictionERP
// acts with frictionAnchor = 1 alone.

#include <LinearMath/btScalar.h>
#include <fmt/format.h>

#include <limits>

#include "engines/bullet/simulation.hpp"
#include "engines/engine.hpp"

namespace rockstack {
namespace {

constexpr bool single_precision = sizeof(btScalar) == sizeof(float);

/// SOLVER_USE_WARMSTARTING | SOLVER_SIMD
constexpr int usual_mode = 4 | 256;

/// N/m and N s/m: what the library gives a body that has no stiffness of its own.
constexpr double stiffest = 1e18;

/// What the tuned set changes.
struct Tuned {
  double iterations = 50;
  double erp2 = 0.2;
  double cfm = 0;
  bool split = true;
  double breaking = 0.02;
  double warmstarting = 0.85;
  double unit_mass = 0;
};

Tuned tuned_for(BulletSolver solver) {
  Tuned tuned;
  if (solver == BulletSolver::mlcp_pgs) tuned.iterations = 20;
  if (solver == BulletSolver::nncg) tuned.unit_mass = 1e6;
  if (single_precision && (solver == BulletSolver::sequential_impulse || solver == BulletSolver::nncg)) {
    tuned.warmstarting = 0;
  }
  if (solver == BulletSolver::mlcp_dantzig || solver == BulletSolver::mlcp_lemke) {
    tuned.split = false;
    tuned.unit_mass = 1;
  }
  if (solver == BulletSolver::mlcp_dantzig) {
    tuned.erp2 = single_precision ? 0.01 : 0.005;
    tuned.cfm = single_precision ? 1e-6 : 1e-10;
  }
  if (solver == BulletSolver::mlcp_lemke) {
    tuned.erp2 = 0.01;
    tuned.cfm = single_precision ? 1e-6 : 1e-5;
    tuned.breaking = single_precision ? 1e-6 : 1e-5;
  }
  return tuned;
}

std::vector<Setting> settings_of(BulletSolver solver) {
  const Tuned tuned = tuned_for(solver);
  constexpr double endless = std::numeric_limits<double>::infinity();
  std::vector<Setting> settings{
      {.name = "numIterations",
       .standard = 10,
       .tuned = tuned.iterations,
       .least = 1,
       .most = 1e6,
       .whole = true},
      {.name = "erp2", .standard = 0.2, .tuned = tuned.erp2, .most = 1},
      {.name = "globalCfm", .tuned = tuned.cfm},
      {.name = "sor", .standard = 1, .most = 2},
      switch_setting("splitImpulse", true, tuned.split),
      {.name = "splitImpulsePenetrationThreshold",
       .unit = "m",
       .standard = -0.04F,
       .tuned = 0,
       .least = -endless},
      {.name = "splitImpulseTurnErp", .standard = 0.1F, .most = 1},
      {.name = "linearSlop", .unit = "m", .least = -1, .most = 1},
      {.name = "warmstartingFactor", .standard = 0.85, .tuned = tuned.warmstarting, .most = 1},
      {.name = "solverMode", .standard = usual_mode, .most = 8191, .whole = true},
      {.name = "leastSquaresResidualThreshold"},
      {.name = "contactBreakingThreshold", .standard = 0.02, .tuned = tuned.breaking},
      {.name = "restitution", .most = 1},
      {.name = "restitutionVelocityThreshold", .unit = "m/s", .standard = 0.2F},
      {.name = "unitMass", .unit = "kg", .tuned = tuned.unit_mass, .most = 1e12},
      {.name = "ground", .choices = {"box", "plane"}},
      {.name = "shape", .choices = {"box", "hull"}},
      {.name = "contactStiffness", .unit = "N/m", .most = stiffest},
      {.name = "contactDamping", .unit = "N s/m", .most = stiffest},
      switch_setting("frictionAnchor", false, false),
      {.name = "frictionERP", .standard = 0.2F, .most = 1},
      shaking_setting(),
  };
  if (solver == BulletSolver::mlcp_lemke) {
    settings.push_back({.name = "maxLoops", .standard = 1000, .least = 1, .most = 1e6, .whole = true});
    settings.push_back({.name = "maxValue", .standard = 100000});
  }
  return settings;
}

Engine with(BulletSolver solver, const char* name) {
  return {{.name = single_precision ? "bullet-single" : "bullet",
           .solver = name,
           .version = fmt::format("{}.{:02}, {} precision", btGetVersion() / 100, btGetVersion() % 100,
                                  single_precision ? "single" : "double"),
           .licence = "Zlib",
           .capabilities = {.largest_friction = friction_clamp, .single_precision = single_precision},
           .settings = settings_of(solver)},
          [solver](const Setup& setup, const Parameters& parameters) {
            return start_bullet(solver, setup, parameters);
          }};
}

}  // namespace

std::vector<Engine> make_bullet() {
  using enum BulletSolver;
  return {with(sequential_impulse, "sequential-impulse"), with(nncg, "nncg"),
          with(mlcp_dantzig, "mlcp-dantzig"), with(mlcp_lemke, "mlcp-lemke"), with(mlcp_pgs, "mlcp-pgs")};
}

}  // namespace rockstack
