// Bullet beside the exact model; README.md says what its contacts are and why its sets are as they are.

#include <btBulletDynamicsCommon.h>
#include <fmt/format.h>

#include "engines/bullet/simulation.hpp"

namespace rockstack {
namespace {

constexpr bool single_precision = sizeof(btScalar) == sizeof(float);

/// What the tuned set changes.
struct Tuned {
  double iterations = 50, erp2 = 0.2, cfm = 0;
  bool split = true;
  double breaking = 0.02, warmstarting = 0.85, unit_mass = 0;
};

Tuned tuned_for(BulletSolver solver) {
  const double warmstarting = single_precision ? 0 : 0.85;
  const double lemke = single_precision ? 1e-6 : 1e-5;
  if (solver == BulletSolver::sequential_impulse) return {.warmstarting = warmstarting};
  if (solver == BulletSolver::nncg) return {.warmstarting = warmstarting, .unit_mass = 1e6};
  if (solver == BulletSolver::mlcp_pgs) return {.iterations = 20};
  if (solver == BulletSolver::mlcp_lemke)
    return {.erp2 = 0.01, .cfm = lemke, .split = false, .breaking = lemke, .unit_mass = 1};
  return single_precision ? Tuned{.erp2 = 0.01, .cfm = 1e-6, .split = false, .unit_mass = 1}
                          : Tuned{.erp2 = 0.005, .cfm = 1e-10, .split = false, .unit_mass = 1};
}

std::vector<Setting> settings_of(BulletSolver solver) {
  const Tuned tuned = tuned_for(solver);
  std::vector<Setting> settings{
      count_setting("numIterations", 10, tuned.iterations),
      {.name = "erp2", .default_value = 0.2, .tuned = tuned.erp2, .most = 1},
      {.name = "globalCfm", .tuned = tuned.cfm},
      {.name = "sor", .default_value = 1, .most = 2},
      switch_setting("splitImpulse", true, tuned.split),
      {.name = "splitImpulsePenetrationThreshold",
       .unit = "m",
       .default_value = -0.04F,
       .tuned = 0,
       .least = -std::numeric_limits<double>::infinity()},
      {.name = "splitImpulseTurnErp", .default_value = 0.1F, .most = 1},
      {.name = "linearSlop", .unit = "m", .least = -1, .most = 1},
      {.name = "warmstartingFactor", .default_value = 0.85, .tuned = tuned.warmstarting, .most = 1},
      {.name = "solverMode",
       .default_value = SOLVER_USE_WARMSTARTING | SOLVER_SIMD,
       .most = 8191,
       .whole = true},
      {.name = "leastSquaresResidualThreshold"},
      {.name = "contactBreakingThreshold", .default_value = 0.02, .tuned = tuned.breaking},
      {.name = "restitution", .most = 1, .role = SettingRole::restitution},
      {.name = "restitutionVelocityThreshold",
       .unit = "m/s",
       .default_value = 0.2F,
       .role = SettingRole::restitution_threshold},
      {.name = "unitMass", .unit = "kg", .tuned = tuned.unit_mass, .most = 1e12},
      {.name = "ground", .choices = {"box", "plane"}},
      {.name = "shape", .choices = {"box", "hull"}},
      {.name = "contactStiffness", .unit = "N/m", .most = stiffest},
      {.name = "contactDamping", .unit = "N s/m", .most = stiffest},
      switch_setting("frictionAnchor", false, false),
      {.name = "frictionERP", .default_value = 0.2F, .most = 1},
      shaking_setting(),
  };
  if (solver == BulletSolver::mlcp_lemke) {
    settings.push_back(count_setting("maxLoops", 1000, 1000));
    settings.push_back({.name = "maxValue", .default_value = 100000});
  }
  return settings;
}

Engine with(BulletSolver solver, const char* name) {
  return {{.name = single_precision ? "bullet-single" : "bullet",
           .solver = name,
           .version = fmt::format("{}.{:02}, {} precision", btGetVersion() / 100, btGetVersion() % 100,
                                  single_precision ? "single" : "double"),
           .licence = "Zlib",
           .capabilities = {.largest_friction = friction_clamp,
                            .applied_forces = true,
                            .single_precision = single_precision,
                            .center_of_mass = true},
           .settings = settings_of(solver)},
          std::bind_front(start_bullet, solver)};
}

}  // namespace

std::vector<Engine> make_bullet() {
  using enum BulletSolver;
  return {with(sequential_impulse, "sequential-impulse"), with(nncg, "nncg"),
          with(mlcp_dantzig, "mlcp-dantzig"), with(mlcp_lemke, "mlcp-lemke"), with(mlcp_pgs, "mlcp-pgs")};
}

}  // namespace rockstack
