#pragma once

#include "analytic/scene/scene.hpp"

namespace rockstack {

/// Where a block is: its centre in m and its angle in rad, clockwise positive.
struct BlockPose {
  double x = 0, y = 0;
  double angle = 0;
};

/// How a block stands on what is under it.
struct InterfaceState {
  /// How deep a corner of either body lies below the face of the other that it is over, m, negative where it
  /// is above it; −∞ where none is over it.
  double depth = 0;
  /// How far the block has slipped to the right along what is under it, m: by its pivot on the side to which
  /// it leans, along the face. The pivot is the end of the faces' overlap there: a corner of the block, or of
  /// the body below where that corner is past the end of its face.
  double slip = 0;
};

/// Of the lowest block on the ground, whose face is y = 0.
InterfaceState on_ground(const Block& block, const BlockPose& pose);

/// Of a block on another.
InterfaceState on_block(const Block& lower, const BlockPose& lower_pose, const Block& upper,
                        const BlockPose& upper_pose);

}  // namespace rockstack
