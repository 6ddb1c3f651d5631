#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string_view>

namespace rockstack {

/// Makes a folder for results, or takes one that is there.
/// @throws InputError naming the folder and the reason where nothing can be written into it.
void prepare_folder(const std::filesystem::path& folder);

/// Writes a file whole or not at all: beside its place first, then renamed.
/// @throws std::runtime_error naming the file and the reason.
void write_file(const std::filesystem::path& file, std::string_view content);

/// The same, of what `write` puts out.
void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

}  // namespace rockstack
