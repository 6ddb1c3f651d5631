#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"
#include "comparisons/impacts.hpp"

namespace rockstack {

/// Many scenes that hardly differ from a given one: where histories part by nature, only their distributions
/// can be compared.
struct Perturbations {
  int runs = 0;        ///< 0: none asked for
  double size = 1e-6;  ///< the largest relative change, > 0
  std::uint64_t seed = 1;
};

/// The scene of one run (from 0): each block's width and height, all initial angles and velocities together,
/// and each ground motion are multiplied by 1 + size · u, u uniform between −1 and 1. Masses stay, and so
/// does what is closed. The same on every call.
Scene perturbed(const Scene& scene, const Perturbations& perturbations, int run);

/// What a perturbed run came to.
struct MotionTally {
  std::vector<double> peaks;  ///< largest |θ| of each block, rad
  int impacts = 0;            ///< above the chatter speed
  bool topples = false;
};

/// Of the exact solution. @throws as solve().
MotionTally exact_tally(const Scene& scene);

/// Of an engine's history.
MotionTally observed_tally(const Scene& scene, const History& history);

/// run,peak_1,…,impacts,toppled: a line a tally, empty cells where a run failed (a tally without
/// peaks).
std::string tallies_csv(const std::vector<MotionTally>& tallies, int blocks);

/// The tallies of a file, without those of runs that failed. @throws InputError as read_table().
std::vector<MotionTally> read_tallies(const std::filesystem::path& file);

}  // namespace rockstack
