#pragma once

#include <string>
#include <vector>

namespace rockstack {

/// "1 run", "2 runs".
std::string counted(std::size_t count, const std::string& one);

/// "a, b and c".
std::string joined(const std::vector<std::string>& words);

/// The same of at most `most`: "a, b and 5 others".
std::string joined_up_to(std::size_t most, const std::vector<std::string>& words);

}  // namespace rockstack
