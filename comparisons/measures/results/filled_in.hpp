#pragma once

#include <map>
#include <string>
#include <string_view>

namespace rockstack {

/// Puts each value in the place of its {{name}}. @throws std::logic_error for a place without a value.
std::string filled_in(std::string_view text, const std::map<std::string, std::string>& values);

}  // namespace rockstack
