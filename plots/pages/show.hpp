#pragma once

#include <filesystem>

namespace rockstack::plots {

/// Whether a folder holds what `compare` or `teach` has run, and no study of it.
bool has_runs(const std::filesystem::path& results);

/// Draws the figures of a results folder and writes its pages, whatever it is of.
/// @throws InputError naming the file that is missing or malformed, or the folder where it holds no results
/// that can be shown; std::runtime_error where gnuplot fails.
void show(const std::filesystem::path& results);

}  // namespace rockstack::plots
