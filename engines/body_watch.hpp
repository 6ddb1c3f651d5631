#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analytic/scene/scene.hpp"
#include "engines/body_record.hpp"
#include "engines/contact_watch.hpp"
#include "engines/ground_path.hpp"
#include "engines/simulation.hpp"

namespace rockstack {

/// Makes a BodyRecord while a simulation steps.
class BodyWatch {
 public:
  /// Watches a simulation that has not stepped yet. `ground_moves`: the engine really moves the ground by the
  /// scene's motion, so that bodies are seen from where it was at t = 0. `friction`: the coefficient that
  /// acts. dt in s.
  BodyWatch(const Scene& scene, double dt, bool ground_moves, double friction, Simulation& simulation);

  /// To be called once at t = 0 and once after every step, with what Simulation::read() gave.
  void observe(std::span<const double> angles, std::span<const double> velocities);

  const BodyRecord& record() const { return record_; }

 private:
  struct Place {
    double x = 0, y = 0;  ///< of a centre in the ground's frame, m
  };

  void follow_ground();
  void add_energy(const std::vector<BodyState>& bodies, std::span<const double> velocities);
  void add_interfaces(std::span<const double> angles);

  const Scene& scene_;
  const Simulation& simulation_;
  double dt_;
  std::optional<GroundPath> path_;
  std::optional<ContactWatch> contacts_;  ///< where the engine tells them
  GroundStep ground_;                     ///< where it is and how fast it has moved over the last step
  std::size_t samples_ = 0;
  std::vector<Place> places_, last_places_;
  BodyRecord record_;
};

}  // namespace rockstack
