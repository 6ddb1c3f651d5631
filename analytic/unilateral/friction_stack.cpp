#include "analytic/unilateral/friction_stack.hpp"

#include <algorithm>
#include <utility>

namespace rockstack {

FrictionStack::FrictionStack(std::vector<Block> stacked, std::vector<double> coefficients)
    : blocks(std::move(stacked)),
      friction(std::move(coefficients)),
      inverse_mass(3 * static_cast<Eigen::Index>(blocks.size())) {
  for (int k = 0; k < size(); ++k) {
    const Block& block = blocks[static_cast<std::size_t>(k)];
    inverse_mass.segment<3>(Eigen::Index{3} * k) << 1 / block.mass, 1 / block.mass, 1 / block.inertia;
  }
}

Overlap overlap(const FrictionStack& stack, int interface, double offset) {
  const double upper = half_width_of(stack.blocks, interface);
  const double lower = half_width_of(stack.blocks, interface - 1);
  return {std::max(-upper, -lower - offset), std::min(upper, lower - offset)};
}

bool corner_is_below(const FrictionStack& stack, int interface, double offset, int side) {
  return half_width_of(stack.blocks, interface - 1) - side * offset < half_width_of(stack.blocks, interface);
}

}  // namespace rockstack
