#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rockstack {

/// "; did you mean NAME?" for the name nearest to a word, by letters put in, left out, replaced or changed
/// with their neighbours (Damerau's distance), where these are at most a third of its letters; else empty.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

}  // namespace rockstack
