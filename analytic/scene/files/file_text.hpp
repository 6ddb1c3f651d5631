#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace rockstack {

/// The file itself, which can be opened without waiting and has an end. @throws InputError naming it where
/// nothing is there, or a folder, a pipe or a device.
const std::filesystem::path& regular_file(const std::filesystem::path& file);

inline constexpr std::uintmax_t largest_input = std::uintmax_t{64} << 20U;  ///< bytes
inline constexpr std::uintmax_t largest_results = std::uintmax_t{1}
                                                  << 30U;  ///< of one file that is read at once

/// All bytes of a regular file. @throws InputError naming it: as above, too large, not readable.
std::string file_text(const std::filesystem::path& file, std::uintmax_t largest = largest_input);

}  // namespace rockstack
