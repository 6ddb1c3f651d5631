#pragma once

#include <string>
#include <vector>

namespace rockstack::plots {

/// Numbers as text for a page: 32-bit floating point, lowest byte first, in base 64.
std::string base64(const std::vector<float>& numbers);

}  // namespace rockstack::plots
