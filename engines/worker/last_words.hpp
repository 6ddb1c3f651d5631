#pragma once

#include <string>
#include <string_view>

namespace rockstack {

/// The line of a program's standard error that tells most of why it failed: the last one of the form "Error:
/// …", as all runtimes have it, below which some list calls or name themselves; where there is none, the last
/// line.
std::string telling_line(std::string_view text);

}  // namespace rockstack
