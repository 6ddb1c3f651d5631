#pragma once

#include <string>

#include "analytic/scene/pattern.hpp"

namespace rockstack {

/// A pattern's name for people: an arrow the way an interface slides, a dash where it is apart.
std::string shown_pattern(const Pattern& pattern);

}  // namespace rockstack
