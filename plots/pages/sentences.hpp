#pragma once

#include <string>
#include <vector>

namespace rockstack::plots {

/// "1 run", "2 runs".
std::string counted(std::size_t count, const std::string& one);

/// "a, b and c".
std::string joined(const std::vector<std::string>& words);

}  // namespace rockstack::plots
