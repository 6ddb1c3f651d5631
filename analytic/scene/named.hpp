#pragma once

#include <string_view>

#include "analytic/scene/history.hpp"
#include "analytic/scene/pattern.hpp"

namespace rockstack {

// What a name() stands for. All throw std::invalid_argument where it stands for nothing.

/// The pattern of `size` blocks with that name.
Pattern named_pattern(std::string_view name, int size);

EventKind named_event(std::string_view name);

Consistency named_consistency(std::string_view name);

}  // namespace rockstack
