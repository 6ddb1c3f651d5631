#pragma once

#include <string>

#include "analytic/scene/scene.hpp"

namespace rockstack {

/// What springs of unit stiffness at a corner add to tr M⁻¹K of a block, 1/kg: one across a face, the corner
/// at the end of a face of that half width, and `tangential` along it.
double spring_compliance(const Block& block, double half_width, double tangential);

/// Bounds on how fast the springs of a stack may be, 1/s, as it stands upright: nothing swings faster than
/// √tr M⁻¹K, dies out faster than tr M⁻¹C, or relaxes faster than k/c, where sliders may move. And the scene
/// file's key of what the largest of them is due to most.
struct SpringRate {
  double rate = 0;
  std::string key;
  double value = 0;  ///< of that key
};
SpringRate fastest_spring_rate(const Scene& scene);

}  // namespace rockstack
