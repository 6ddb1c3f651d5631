#pragma once

#include <filesystem>

namespace rockstack::plots {

/// Writes results/report.html from a folder whose figures are drawn. The page appears whole or not at all.
/// @throws InputError naming the file that is missing or malformed; std::runtime_error where it cannot be
/// written.
void write_impact_law_report(const std::filesystem::path& results);

}  // namespace rockstack::plots
