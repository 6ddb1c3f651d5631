#pragma once

#include <filesystem>

namespace rockstack::plots {

/// True for a folder of `rockstack canon`.
bool has_canon(const std::filesystem::path& results);

/// Writes results/report.html from canon.json: engines as rows, scenes as columns. The page appears whole or
/// not at all. @throws InputError naming the file that is missing or malformed; std::runtime_error where it
/// cannot be written.
void write_canon_report(const std::filesystem::path& results);

}  // namespace rockstack::plots
