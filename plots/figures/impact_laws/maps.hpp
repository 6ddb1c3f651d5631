#pragma once

#include <filesystem>

namespace rockstack::plots {

/// True where a folder holds the results of the study of impact laws.
bool has_impact_laws(const std::filesystem::path& results);

/// Draws results/figures/impact-laws.<n>-blocks.png, .svg and .pdf, one figure a number of blocks: maps over
/// the top block's height over width and its mass ratio, a panel a kind of impact, of the share in which the
/// laws differ and of that in which no pattern is consistent. A share below one in a hundred has no panel.
/// And impact-laws.engines: how far every engine run is from either law.
/// @throws InputError naming the file that is missing or malformed; std::runtime_error where gnuplot fails.
void draw_impact_laws(const std::filesystem::path& results);

}  // namespace rockstack::plots
