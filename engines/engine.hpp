#pragma once

#include <cstddef>
#include <functional>
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
  double tuned_lead = lead;  ///< with the tuned set, where the number of substeps is a setting
};

/// Who a physics engine with one of its constraint solvers is.
struct EngineDescription {
  std::string name = {};     ///< "bullet", "bullet-single", "ode"
  std::string solver = {};   ///< "sequential-impulse", "step", …
  std::string version = {};  ///< of the library in use, e.g. "3.24, double precision"
  std::string licence = {};  ///< of the library in use, by its SPDX name
  Capabilities capabilities = {};
  /// Steps that its runtime takes until they are as fast as they get; a worker takes so many before it times
  /// any. 0: the first is no slower than the last.
  std::size_t warm_up = 0;
  /// Every setting, with its value in either set: `standard` is what a user gets who sets nothing but
  /// friction and restitution, `tuned` suits this problem best; the adapter's head says why.
  std::vector<Setting> settings = {};

  std::string full_name() const { return name + ":" + solver; }
  Parameters default_parameters() const { return standard_values(settings); }
  Parameters tuned_parameters() const { return tuned_values(settings); }
};

/// An engine inside this process: what worker programs run (engines/worker) and tests look into.
struct Engine : EngineDescription {
  /// Builds a scene anew, with parameters that are checked.
  std::function<std::unique_ptr<Simulation>(const Setup&, const Parameters&)> build = {};

  /// Likewise. `parameters` holds exactly the keys of default_parameters().
  /// @throws std::invalid_argument for an unknown or missing parameter, or one out of range.
  std::unique_ptr<Simulation> start(const Setup& setup, const Parameters& parameters) const {
    check(name, settings, parameters);
    return build(setup, parameters);
  }
};

}  // namespace rockstack
