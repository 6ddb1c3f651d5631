#pragma once

#include <cstdint>

#include "analytic/scene/input/document.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// Many scenes that hardly differ from a given one: where histories part by nature, only their distributions
/// can be compared.
struct Perturbations {
  int runs = 0;        ///< 0: none asked for
  double size = 1e-6;  ///< the largest relative change, > 0
  std::uint64_t seed = 1;
};

/// The runs that an engine's number is drawn from: one run is chance, since the phase between impacts and
/// time steps and the last digits of a scene each change it by factors.
struct Draws {
  int runs = 1;         ///< with the one at the nominal step and scene; ≥ 1
  int finest = 0;       ///< the same at the finest of several steps, 1 to `runs`; 0: as many
  double steps = 0.03;  ///< the largest relative change of the time step, 0 to 0.5
  double scene = 1e-6;  ///< likewise of the scene, as Perturbations::size
  std::uint64_t seed = 1;
};

inline constexpr int quick_draws = 5;      ///< where nobody asked for a number of draws
inline constexpr int fewest_draws = 3;     ///< where a quick answer is asked for
inline constexpr int most_draws = 10'000;  ///< that may be asked for

/// As many at every step.
inline void set_runs(Draws& draws, int runs) {
  draws.runs = runs;
  draws.finest = 0;
}

/// The scene of one run (from 0): each block's width and height, all initial angles and velocities together,
/// and each ground motion are multiplied by 1 + size · u, u uniform between −1 and 1. Masses stay, and so
/// does what is closed. The same on every call.
Scene perturbed(const Scene& scene, const Perturbations& perturbations, int run);

/// The scene of one draw; that of draw 0 is the scene itself.
Scene drawn_scene(const Scene& scene, const Draws& draws, int draw);

/// The time step of one draw, s: dt itself for draw 0; the others are spread evenly over dt (1 ± steps).
double drawn_step(double dt, const Draws& draws, int draw);

/// The tables [perturbations] and [draws] of a suite or study. @throws InputError with file:line, key, value
/// and what is allowed.
Perturbations read_perturbations(const Node& table);
Draws read_draws(const Node& table);

}  // namespace rockstack
