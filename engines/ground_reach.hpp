#pragma once

#include <vector>

#include "engines/setup.hpp"

namespace rockstack {

/// How far a ground that has edges should go to each side, m: ten times as far as all blocks in a row.
/// Precondition: there is a block.
inline double ground_reach(const std::vector<Placement>& blocks) {
  double reach = blocks.front().depth;
  for (const Placement& block : blocks) reach += block.width + block.height;
  return 10 * reach;
}

}  // namespace rockstack
