#pragma once

#include "analytic/unilateral/bodies.hpp"

namespace rockstack {

/// The stack that contacts hold, with the friction coefficient of each interface.
struct FrictionStack {
  std::vector<Block> blocks;
  std::vector<double> friction;
  Eigen::VectorXd inverse_mass;  ///< three a block

  FrictionStack(std::vector<Block> stacked, std::vector<double> coefficients);
  int size() const { return static_cast<int>(blocks.size()); }
};

/// The overlap of a flat contact from the middle of the block above, m.
struct Overlap {
  double left, right;
};
Overlap overlap(const FrictionStack& stack, int interface, double offset);

/// A pivot at an end of a flat contact: which block has the corner. Even ends: the upper one.
bool corner_is_below(const FrictionStack& stack, int interface, double offset, int side);

}  // namespace rockstack
