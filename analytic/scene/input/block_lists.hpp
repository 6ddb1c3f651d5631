#pragma once

#include "analytic/scene/input/document.hpp"

namespace rockstack {

/// Writes out for each block of a scene what one number, or the default of a key that is left out, says of
/// all, so that one of them can be set; where there is no default the others are missing. Leaves other nodes
/// as they are.
void list_blocks(const Node& root, Node& node, const std::string& place);

}  // namespace rockstack
