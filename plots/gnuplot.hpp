#pragma once

#include <filesystem>
#include <string>

namespace rockstack::plots {

/// A picture in gnuplot's words. `commands` are run once a format; point sizes in them are multiples of
/// `mark`.
struct Drawing {
  int width = 1200;      ///< pixels
  int height = 600;      ///< pixels
  std::string data;      ///< named data blocks
  std::string commands;  ///< plot commands, without terminal and output
};

/// Draws `stem`.png, `stem`.svg and `stem`.pdf; all appear whole or none. Waits for gnuplot to finish.
/// @throws std::runtime_error with gnuplot's own words where it fails, and where it is not installed.
void draw(const Drawing& drawing, const std::filesystem::path& stem);

}  // namespace rockstack::plots
