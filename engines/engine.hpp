#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "engines/parameters.hpp"
#include "engines/setup.hpp"
#include "engines/simulation.hpp"

namespace rockstack {

/// What an engine is able to do, and by which rules it is to be judged.
struct Capabilities {
  /// The coefficient of friction that acts where a scene asks for more.
  double largest_friction = std::numeric_limits<double>::infinity();
  bool single_precision = false;
  bool planar = false;  ///< by nature; else constraints or corrections hold its bodies in the plane
  /// By how many steps places are ahead under a constant force: ½ for semi-implicit Euler, 0 for an
  /// integrator of higher order.
  double lead = 0.5;
};

/// A physics engine with one of its constraint solvers, inside this process: what worker programs run
/// (engines/worker) and tests look into.
class Engine {
 public:
  virtual ~Engine() = default;

  virtual std::string name() const = 0;     ///< "bullet", "bullet-single", "ode"
  virtual std::string solver() const = 0;   ///< "sequential-impulse", "step", …
  virtual std::string version() const = 0;  ///< of the library in use, e.g. "3.24, double precision"
  virtual std::string licence() const = 0;  ///< of the library in use, by its SPDX name
  virtual Capabilities capabilities() const { return {}; }

  /// Every setting, with its value in either set: `default` is what a user gets who sets nothing but
  /// friction and restitution, `tuned` suits this problem best; the adapter's head says why.
  virtual std::vector<Setting> settings() const = 0;
  Parameters default_parameters() const { return standard_values(settings()); }
  Parameters tuned_parameters() const { return tuned_values(settings()); }

  /// Builds the scene anew. `parameters` holds exactly the keys of default_parameters().
  /// @throws std::invalid_argument for an unknown or missing parameter, or one out of range.
  std::unique_ptr<Simulation> start(const Setup& setup, const Parameters& parameters) const {
    check(name(), settings(), parameters);
    return build(setup, parameters);
  }

 private:
  virtual std::unique_ptr<Simulation> build(const Setup& setup, const Parameters& parameters) const = 0;
};

}  // namespace rockstack
