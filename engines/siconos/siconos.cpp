// Siconos beside the exact model; README.md says what its contacts are and why its sets are as they are.

#include "engines/engine.hpp"

namespace rockstack {

/// A scene inside Siconos (simulation.cpp, C++17 as its headers are). Precondition: checked `parameters`.
std::unique_ptr<Simulation> start_siconos(const Setup& setup, const Parameters& parameters);

std::vector<Engine> make_siconos() {
  const std::vector<Setting> settings{
      {.name = "theta", .default_value = 0.5, .most = 1},
      {.name = "gamma", .default_value = 0.5, .most = 1},
      {.name = "constraintActivationThreshold", .unit = "m", .tuned = 1e-9},
      {.name = "SICONOS_DPARAM_TOL", .default_value = 1e-4, .tuned = 1e-12, .most = 1},
      {.name = "SICONOS_IPARAM_MAX_ITER",
       .default_value = 1e3,
       .tuned = 1e4,
       .least = 1,
       .most = 1e9,
       .whole = true},
      switch_setting("keepLambdaAndYState", true, true),
      {.name = "en", .most = 1, .role = SettingRole::restitution},
      {.name = "unitMass", .unit = "kg", .tuned = 1, .most = 1e12},
      shaking_setting()};
  return {{{.name = "siconos",
            .solver = "nsgs",
            .version = "4.4.0, double precision",  // of Debian 12: its headers do not tell
            .licence = "Apache-2.0",
            .capabilities = {.applied_forces = true, .planar = true, .center_of_mass = true, .lead = 0},
            .settings = settings},
           start_siconos}};
}

}  // namespace rockstack
