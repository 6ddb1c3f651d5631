#pragma once

#include "tests/analytic/proof/exact_scene.hpp"

namespace rockstack::proof {

/// How each interface touches, from the ground up: it turns about its right end (1), its left one (−1), or is
/// closed (0).
using Pattern = std::vector<int>;

/// A letter an interface: R, L or C.
std::string letters(const Pattern& pattern);

/// A scene's blocks at the working bits. SI units.
struct Stack {
  std::vector<Ball> half_width;          ///< of the interface under a block
  std::vector<Ball> height;              ///< of a block
  std::vector<Ball> centre_x, centre_y;  ///< of mass, from the middle of a block's lower face
  std::vector<Ball> mass, inertia;
  std::vector<Ball> toppling_angle;  ///< at which a block counts as toppled, rad
  std::vector<bool> overhangs;       ///< whether a block is wider than what is below
  Ball gravity, downhill;            ///< across the ground and along it, m/s²

  std::size_t size() const { return mass.size(); }
  /// The pivot of an interface from its middle, m; 0 where it is closed, and above the top.
  Ball pivot(const Pattern& pattern, std::size_t k) const {
    return k < size() ? Ball(pattern[k]) * half_width[k] : Ball();
  }
};

Stack make_stack(const ExactScene& scene);

}  // namespace rockstack::proof
