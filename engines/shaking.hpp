#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "engines/setup.hpp"

namespace rockstack {

/// What a scene's ground motion does to an engine over one time step.
struct ShakingStep {
  std::optional<GroundStep> ground;              ///< where the ground really moves
  std::optional<BodyAcceleration> acceleration;  ///< where its motion enters as a body force
};

/// A scene's ground motion, step by step.
class Shaking {
 public:
  explicit Shaking(const Setup& setup) : accelerations_(setup.accelerations), ground_(setup.ground) {}

  /// True where the ground really moves.
  bool moves_ground() const { return !ground_.empty(); }

  /// The next step, the first from t = 0; nothing in it where the ground rests or the scene is over.
  ShakingStep next() {
    const std::size_t step = steps_++;
    ShakingStep now;
    if (step < ground_.size()) now.ground = ground_[step];
    if (step < accelerations_.size()) now.acceleration = accelerations_[step];
    return now;
  }

 private:
  std::vector<BodyAcceleration> accelerations_;
  std::vector<GroundStep> ground_;
  std::size_t steps_ = 0;
};

}  // namespace rockstack
