#pragma once

#include <string>
#include <vector>

#include "tests/temporary_folder.hpp"

namespace rockstack {

/// Scene files that together hold every key there is.
std::vector<std::string> scenes_with_every_key();

/// Reads a scene file of that text; true where it is a scene, false where it is refused.
/// @throws std::logic_error where a scene that was read is not valid, or an error is not one line that starts
/// with the file's name. Anything else that escapes is wrong too.
bool is_read(const TemporaryFolder& folder, const std::string& text);

}  // namespace rockstack
