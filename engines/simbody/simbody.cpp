// Simbody beside the exact model; README.md says what its contacts are and why its sets are as they are.

#include "engines/engine.hpp"

namespace rockstack {

/// A stack inside Simbody (simulation.cpp, C++17: as C++20 comparisons of its headers are ambiguous).
/// Precondition: checked `parameters`. @throws std::exception with the library's own error, as its steps do.
std::unique_ptr<Simulation> start_simbody(const Setup& setup, const Parameters& parameters);

std::vector<Engine> make_simbody() {
  return {
      {{.name = "simbody",
        .solver = "compliant",
        .version = SIMBODY_VERSION ", double precision",
        .licence = "Apache-2.0",
        .capabilities = {.kinetic_friction = true,
                         .applied_forces = true,
                         .planar = true,
                         .center_of_mass = true,
                         .lead = 0},
        .settings = {{.name = "integrator",
                      .choices = {"CPodes", "RungeKuttaMerson", "RungeKutta3", "Verlet"}},
                     {.name = "accuracy", .default_value = 1e-3, .tuned = 1e-7, .least = 1e-12, .most = 0.1},
                     {.name = "stiffness", .unit = "N/m", .default_value = 1e8, .least = 1e-18, .most = 1e18},
                     {.name = "dissipation", .unit = "s/m", .default_value = 1, .tuned = 5e4},
                     {.name = "transition_velocity",
                      .unit = "m/s",
                      .default_value = 0.01,
                      .tuned = 1e-4,
                      .least = 1e-12},
                     {.name = "unitMass", .unit = "kg", .tuned = 1, .most = 1e12}}},
       start_simbody}};
}

}  // namespace rockstack
