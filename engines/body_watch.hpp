#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analytic/scene/scene.hpp"
#include "engines/body_record.hpp"
#include "engines/contact_watch.hpp"
#include "engines/ground_path.hpp"
#include "engines/interface_state.hpp"
#include "engines/simulation.hpp"

namespace rockstack {

/// Makes a BodyRecord while a simulation steps.
class BodyWatch {
 public:
  /// Watches a simulation that has not stepped yet. `ground_moves`: the engine really moves the ground by the
  /// scene's motion, so that bodies are seen from where it was at t = 0. `friction`: the coefficient that
  /// acts at each interface. dt in s.
  BodyWatch(const Scene& scene, double dt, bool ground_moves, const std::vector<double>& friction,
            Simulation& simulation);

  /// To be called once at t = 0 and once after every step, with what Simulation::read() gave.
  void observe(std::span<const double> angles, std::span<const double> velocities);

  const BodyRecord& record() const { return record_; }
  /// Of the last sample, in the ground's frame, one a block.
  const std::vector<BlockPose>& poses() const { return poses_; }
  const std::vector<InterfaceState>& interfaces() const { return interfaces_; }

 private:
  void follow_ground();
  void add_energy(const std::vector<BodyState>& bodies, std::span<const double> velocities);
  void add_interfaces();

  const Scene& scene_;
  const Simulation& simulation_;
  double dt_;
  std::optional<GroundPath> path_;
  std::optional<ContactWatch> contacts_;  ///< where the engine tells them
  GroundStep ground_;                     ///< where it is and how fast it has moved over the last step
  std::size_t samples_ = 0;
  std::vector<BlockPose> poses_, last_poses_;
  std::vector<InterfaceState> interfaces_;
  BodyRecord record_;
};

}  // namespace rockstack
