#pragma once

#include <cstdint>
#include <filesystem>

#include "engines/trajectory.hpp"
#include "engines/worker/worker_engine.hpp"

namespace rockstack {

/// Motion of a scene's blocks as another program has written it: a table of comma-separated values with a
/// column `time` and angles, poses in the plane or poses in space, the form of which comparisons/README.md
/// has.
struct TrajectoryFile {
  std::filesystem::path file;
  std::uint64_t checksum = 0;  ///< of its bytes
  double dt = 0;               ///< mean time between samples, s
  Trajectory trajectory;       ///< in the ground's frame; without bodies where it has angles alone
};

/// Runs of a scene that a program has written, the nominal one first.
struct TrajectoryFiles {
  std::string scene;     ///< its name
  WorkerEngine program;  ///< by its name: nothing of it is run
  std::vector<TrajectoryFile> runs;
};

/// Reads a motion up to the scene's end, or to where a block has toppled. What is not in the scene's axes is
/// brought there: clocks and origins of their own, y or z up, a ground that moves. Rates that are missing are
/// those of the step before.
/// @throws InputError in one line with file, line, column and what is expected: a missing or malformed
/// number, times that do not ascend, a start or an end that is not the scene's.
TrajectoryFile read_trajectory(const std::filesystem::path& file, const Scene& scene);

}  // namespace rockstack
