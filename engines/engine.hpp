#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"
#include "engines/body_record.hpp"
#include "engines/parameters.hpp"
#include "engines/simulation.hpp"

namespace rockstack {

/// A physics engine with one of its constraint solvers, inside this process: what worker programs run
/// (engines/worker) and tests look into.
class Engine {
 public:
  virtual ~Engine() = default;

  virtual std::string name() const = 0;     ///< "bullet", "bullet-single", "ode"
  virtual std::string solver() const = 0;   ///< "sequential-impulse", "step", …
  virtual std::string version() const = 0;  ///< of the library in use, e.g. "3.24, double precision"

  /// Every setting, with its value in either set: `default` is what a user gets who sets nothing but
  /// friction and restitution, `tuned` suits this problem best; the adapter's head says why.
  virtual std::vector<Setting> settings() const = 0;
  Parameters default_parameters() const { return standard_values(settings()); }
  Parameters tuned_parameters() const { return tuned_values(settings()); }

  /// The coefficient of friction that acts where a scene asks for `asked`; smaller where the engine has a
  /// limit.
  virtual double friction(double asked) const { return asked; }

  /// Builds the scene anew. `parameters` holds exactly the keys of default_parameters().
  /// @throws std::invalid_argument for an unknown or missing parameter, or one out of range; dt ≤ 0.
  virtual std::unique_ptr<Simulation> start(const Scene& scene, double dt,
                                            const Parameters& parameters) const = 0;
};

/// What an engine made of a scene.
struct EngineRun {
  /// The state at t = 0 and after every step; ends early where a block has toppled. Of law `unilateral` with
  /// slips, gaps (negative: overlap) and places, whether or not the blocks touch.
  History history;
  std::size_t warnings = 0;          ///< as Simulation::warnings()
  std::optional<BodyRecord> bodies;  ///< where asked for
};

/// A block's angle or angular velocity stopped being a finite number.
class NotFinite : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs a scene for its duration in this process; `bodies`: keeps a BodyRecord.
/// @throws std::invalid_argument as check_step(); NotFinite with the time at which that happened, or the
/// engine's own error.
EngineRun simulate(const Engine& engine, const Scene& scene, double dt, const Parameters& parameters,
                   bool bodies = false);

/// Wall times of that many steps alone, without building or reading, in s: one each of `repeats` runs ≥ 0.
/// Precondition: the scene has been simulated before, as a warm-up and to know after how many steps it ends.
std::vector<double> time_stepping(const Engine& engine, const Scene& scene, double dt,
                                  const Parameters& parameters, std::size_t steps, int repeats);

}  // namespace rockstack
