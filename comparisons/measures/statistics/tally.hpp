#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// What a perturbed run came to.
struct MotionTally {
  std::vector<double> peaks;  ///< largest |θ| of each block, rad; none where the run failed
  int impacts = 0;            ///< above the chatter speed
  bool topples = false;

  bool failed() const { return peaks.empty(); }
};

/// Of the exact solution. @throws as solve().
MotionTally exact_tally(const Scene& scene);

/// Of an engine's history.
MotionTally observed_tally(const Scene& scene, const History& history);

/// run,peak_1,…,impacts,toppled: a line a tally, empty cells where a run failed.
std::string tallies_csv(const std::vector<MotionTally>& tallies, int blocks);

/// The tallies of a file. @throws InputError as read_table().
std::vector<MotionTally> read_tallies(const std::filesystem::path& file);

}  // namespace rockstack
