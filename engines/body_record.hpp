#pragma once

#include <vector>

namespace rockstack {

/// What the bodies of an engine did that angles alone do not tell, over one run. SI units, in the ground's
/// frame.
struct BodyRecord {
  /// At each sample: kinetic and potential, zero where the stack rests upright, J.
  std::vector<double> energy;
  /// Work that the ground's motion has done on the blocks by then, J.
  std::vector<double> input;
  double penetration = 0;        ///< largest depth of a block in the block or ground under it, m
  double gap = 0;                ///< largest height of a block over what it stands on, m
  double slip = 0;               ///< largest way of a pivot along the face that it stands on, m
  double out_of_plane = 0;       ///< largest |z| of a block's centre, m
  double out_of_plane_tilt = 0;  ///< largest sine of a block's angle out of the plane
};

}  // namespace rockstack
