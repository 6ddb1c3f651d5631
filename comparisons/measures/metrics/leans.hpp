#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// One swing of a block between two changes of side.
struct Swing {
  double end = 0;        ///< s; 0 for the last
  double peak = 0;       ///< largest absolute angle, rad
  double peak_time = 0;  ///< s
};

/// All swings of a block (from 0) in order.
std::vector<Swing> swings(const History& history, std::size_t block);

/// The one with the largest peak.
Swing largest_swing(const History& history, std::size_t block);

/// The largest angle of each block, rad; of samples where the history does not keep it.
std::vector<double> peak_angles(const History& history);

/// The largest uplift of each block, m; where the history does not keep it, that of blocks that turn over
/// ends of interfaces as samples tell.
std::vector<double> uplifts_of(const Scene& scene, const History& history);

/// How near to its balance something comes: 1 there, 0 upright.
struct Lean {
  std::size_t block = 0;
  double ratio = 0;
  double time = 0;  ///< of the sample that comes nearest to it, s; 0 without samples
};

/// The largest angle of a block over its slenderness angle atan(b/h), the normalized rotation of the
/// literature: beyond 1 a single block does not come back by itself. Where the centre of mass is off the
/// middle, over that of the side that it leans to, in samples.
Lean largest_lean(const Scene& scene, const History& history);

/// Lean of a block with all that stands on it: by how much the line from the corner that it leans on to
/// their common centre of mass has turned, over what it has to turn from upright blocks in the same places
/// until it is vertical. Of the lowest block of those that come nearest; on level ground without the top
/// block, which largest_lean() is of. In samples.
Lean largest_common_lean(const Scene& scene, const History& history);

/// A block that does not come back by itself.
struct FallingBlock {
  std::size_t block = 0;
  bool past_edge = false;  ///< where it has slid to it could not stand upright on level ground
};

/// The lowest block, from 0, that turns further over a corner beyond which, in the direction of gravity, is
/// the centre of mass of it and all that stands on it. At one sample.
std::optional<FallingBlock> falling_block(const Scene& scene, const History& history, std::size_t sample);

}  // namespace rockstack
