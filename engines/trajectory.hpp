#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

#include "engines/contact_record.hpp"
#include "engines/engine.hpp"

namespace rockstack {

/// What an engine made of a scene, at t = 0 and after every step; it ends early where a block has toppled.
/// All lists go sample by sample, and in each from the lowest block up.
struct Trajectory {
  std::vector<double> angles;      ///< rad, clockwise positive
  std::vector<double> velocities;  ///< rad/s
  std::vector<BodyState> bodies;   ///< where asked for
  /// What its contacts tell, where asked for and where the engine tells them.
  std::optional<ContactRecord> contacts;
  std::size_t warnings = 0;  ///< steps in which the solver failed and went on
};

/// A number of a block's motion stopped being finite, or is beyond all that a scene has (largest_number).
class NotFinite : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs a scene to its end in this process; `bodies`: keeps these and the contacts.
/// @throws NotFinite with the time at which that happened, or the engine's own error.
Trajectory run(const Engine& engine, const Setup& setup, const Parameters& parameters, bool bodies = false);

/// True where a block has toppled in the last sample, or an angle there is no number any more.
bool has_ended(const Setup& setup, const Trajectory& trajectory);

/// @throws NotFinite as above, for a trajectory of that many blocks.
void require_finite(const Trajectory& trajectory, std::size_t blocks, double dt);

/// Wall times of that many steps alone, without building or reading, in s: one each of `repeats` runs ≥ 0.
/// Precondition: the scene has been run before, as a warm-up and to know after how many steps it ends.
std::vector<double> time_stepping(const Engine& engine, const Setup& setup, const Parameters& parameters,
                                  std::size_t steps, int repeats);

}  // namespace rockstack
