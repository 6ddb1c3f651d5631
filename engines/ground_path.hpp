#pragma once

#include "analytic/scene/scene.hpp"
#include "engines/setup.hpp"

namespace rockstack {

/// The ground's displacement under a scene's accelerations, from rest at t = 0, step by step: their double
/// integral, exact for straight lines between samples and by Gauss's rule with five points for pulses: to
/// rounding for steps of up to a fifth of their period.
class GroundPath {
 public:
  /// Precondition: dt > 0, in s.
  GroundPath(const Scene& scene, double dt)
      : horizontal_(scene.horizontal), vertical_(scene.vertical), dt_(dt) {}

  /// The next step; the first call gives the one from t = 0.
  GroundStep next();

 private:
  /// Along one axis: displacement and velocity of the ground at the start of the next step.
  struct Axis {
    double displacement = 0, velocity = 0;
    /// Moves on to the end of the step; returns the mean velocity over it.
    double advance(const GroundMotion& motion, double from, double to);
  };

  GroundMotion horizontal_, vertical_;
  double dt_;
  std::size_t steps_ = 0;
  Axis x_, y_;
};

}  // namespace rockstack
