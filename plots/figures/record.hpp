#pragma once

#include <filesystem>

namespace rockstack::plots {

/// Draws results/figures/record.png and .svg from record.csv, spectrum.csv and record.json of
/// `rockstack record`: acceleration, velocity and displacement with the significant duration, the growth of
/// the Arias intensity, and the response spectrum.
/// @throws InputError naming the file that is missing or malformed; std::runtime_error where gnuplot fails.
void draw_record(const std::filesystem::path& results);

}  // namespace rockstack::plots
