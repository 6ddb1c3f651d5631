#pragma once

#include <filesystem>
#include <vector>

namespace rockstack::plots {

/// Draws the motion of every scene of a results folder that a player could show, as
/// results/figures/<scene>.motion.gif, and as .mp4 where ffmpeg is there: exact and engines side by side, 25
/// frames a second. Returns the files.
/// @throws InputError naming the file that is missing or malformed; std::runtime_error where gnuplot or
/// ffmpeg fails.
std::vector<std::filesystem::path> draw_animations(const std::filesystem::path& results);

}  // namespace rockstack::plots
