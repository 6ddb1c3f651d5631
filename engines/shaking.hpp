#pragma once

#include <optional>

#include "analytic/scene/scene.hpp"
#include "engines/ground_path.hpp"
#include "engines/parameters.hpp"
#include "engines/placement.hpp"

namespace rockstack {

/// What a scene's ground motion does to an engine over one time step.
struct ShakingStep {
  std::optional<GroundStep> ground;              ///< where the ground really moves
  std::optional<BodyAcceleration> acceleration;  ///< where its motion enters as a body force
};

/// A scene's ground motion, step by step, in the way that the setting `shaking` asks for.
class Shaking {
 public:
  /// Precondition: dt > 0, in s. The scene must outlive this.
  Shaking(const Scene& scene, double dt, const Parameters& parameters);

  /// True where the ground really moves.
  bool moves_ground() const { return path_.has_value(); }

  /// The next step, the first from t = 0; nothing in it where the ground rests.
  ShakingStep next();

 private:
  const Scene& scene_;
  double dt_;
  std::size_t steps_ = 0;
  std::optional<GroundPath> path_;
};

}  // namespace rockstack
