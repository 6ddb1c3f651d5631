#pragma once

#include <filesystem>

namespace rockstack::plots {

/// Writes results/report.html of one motion: its verdict, its player, its figures and everything that its
/// summary says. Figures are drawn before.
/// @throws InputError naming the file that is missing or malformed.
void write_motion_report(const std::filesystem::path& results);

}  // namespace rockstack::plots
