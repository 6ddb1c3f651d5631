#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rockstack::plots {

/// Names and texts in the order of the file.
using Facts = std::vector<std::pair<std::string, std::string>>;

}  // namespace rockstack::plots
