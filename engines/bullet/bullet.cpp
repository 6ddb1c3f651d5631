// Bullet beside the exact model. README.md in this folder says what its contacts are, what is set in both
// sets, what the tuned set changes, and why. `comparisons/tune` ranks sets; those here also hold the
// conformance tests.
//
// contactStiffness k in N/m and contactDamping c in N s/m make each contact point a spring and a dashpot,
// through Bullet's own erp = h k/(h k + c) and cfm = 1/(h k + c) with the step h; where both are zero, erp2
// and globalCfm act. Only an overlap that goes through the velocities is a spring: splitImpulse = 0, or above
// its threshold. Bullet's erp and frictionCFM are not here: without joints they change no digit; frictionERP
// acts with frictionAnchor = 1 alone.

#include "engines/bullet/bullet.hpp"

#include <LinearMath/btScalar.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engines/bullet/simulation.hpp"
#include "engines/parameters.hpp"

namespace rockstack {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

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
  double split = 1;
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
    tuned.split = 0;
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
  std::vector<Setting> settings{
      {"numIterations", 10, tuned.iterations, 1, 1e6, true},
      {"erp2", 0.2, tuned.erp2, 0, 1},
      {"globalCfm", 0, tuned.cfm, 0, endless},
      {"sor", 1, 1, 0, 2},
      {"splitImpulse", 1, tuned.split, 0, 1, true},
      {"splitImpulsePenetrationThreshold", -0.04F, 0, -endless, endless, false, {}, "m"},
      {"splitImpulseTurnErp", 0.1F, 0.1F, 0, 1},
      {"linearSlop", 0, 0, -1, 1, false, {}, "m"},
      {"warmstartingFactor", 0.85, tuned.warmstarting, 0, 1},
      {"solverMode", usual_mode, usual_mode, 0, 8191, true},
      {"leastSquaresResidualThreshold", 0, 0, 0, endless},
      {"contactBreakingThreshold", 0.02, tuned.breaking, 0, endless},
      {"restitution", 0, 0, 0, 1},
      {"restitutionVelocityThreshold", 0.2F, 0.2F, 0, endless, false, {}, "m/s"},
      {"unitMass", 0, tuned.unit_mass, 0, 1e12, false, {}, "kg"},
      {"ground", 0, 0, 0, 1, true, {"box", "plane"}},
      {"shape", 0, 0, 0, 1, true, {"box", "hull"}},
      {"contactStiffness", 0, 0, 0, stiffest, false, {}, "N/m"},
      {"contactDamping", 0, 0, 0, stiffest, false, {}, "N s/m"},
      {"frictionAnchor", 0, 0, 0, 1, true},
      {"frictionERP", 0.2F, 0.2F, 0, 1},
      shaking_setting(),
  };
  if (solver == BulletSolver::mlcp_lemke) {
    settings.push_back({"maxLoops", 1000, 1000, 1, 1e6, true});
    settings.push_back({"maxValue", 100000, 100000, 0, endless});
  }
  return settings;
}

const char* name_of(BulletSolver solver) {
  switch (solver) {
    case BulletSolver::sequential_impulse:
      return "sequential-impulse";
    case BulletSolver::nncg:
      return "nncg";
    case BulletSolver::mlcp_dantzig:
      return "mlcp-dantzig";
    case BulletSolver::mlcp_lemke:
      return "mlcp-lemke";
    case BulletSolver::mlcp_pgs:
      return "mlcp-pgs";
  }
  return "";
}

class Bullet : public Engine {
 public:
  explicit Bullet(BulletSolver solver) : solver_(solver) {}
  std::string name() const override { return single_precision ? "bullet-single" : "bullet"; }
  std::string solver() const override { return name_of(solver_); }
  std::string version() const override {
    return fmt::format("{}.{:02}, {} precision", btGetVersion() / 100, btGetVersion() % 100,
                       single_precision ? "single" : "double");
  }
  std::string licence() const override { return "Zlib"; }
  std::vector<Setting> settings() const override { return settings_of(solver_); }
  Capabilities capabilities() const override {
    return {.largest_friction = friction_clamp, .single_precision = single_precision};
  }

 private:
  std::unique_ptr<Simulation> build(const Setup& setup, const Parameters& parameters) const override {
    return start_bullet(solver_, setup, parameters);
  }

  BulletSolver solver_;
};

}  // namespace

std::vector<std::unique_ptr<Engine>> make_bullet() {
  std::vector<std::unique_ptr<Engine>> engines;
  for (const BulletSolver solver :
       {BulletSolver::sequential_impulse, BulletSolver::nncg, BulletSolver::mlcp_dantzig,
        BulletSolver::mlcp_lemke, BulletSolver::mlcp_pgs}) {
    engines.push_back(std::make_unique<Bullet>(solver));
  }
  return engines;
}

}  // namespace rockstack
