#pragma once

#include <filesystem>
#include <string>

namespace rockstack {

/// All bytes of a file that a user names. Pipes and devices are refused: they may have no end, and results
/// name the files that they were made of.
/// @throws InputError naming the file: not there, not a regular file, larger than 64 MiB, not readable.
std::string file_text(const std::filesystem::path& file);

}  // namespace rockstack
