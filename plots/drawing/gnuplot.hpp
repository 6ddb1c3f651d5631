#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rockstack::plots {

/// A picture in gnuplot's words. `commands` are run once a format; point sizes are multiples of `mark`.
struct Drawing {
  int width = 1200;         ///< pixels
  int height = 600;         ///< pixels
  std::string data;         ///< named data blocks
  std::string commands;     ///< plot commands, without terminal and output
  double time_limit = 300;  ///< of gnuplot, s
};

/// The colour of words that take their room and are not to be seen.
inline constexpr auto unseen = "#FF010203";

/// Draws `stem`.png, `stem`.svg and `stem`.pdf; all appear whole or none. Waits for gnuplot to finish.
/// @throws std::runtime_error where gnuplot fails, with its own words, is not installed or hangs.
void draw(const Drawing& drawing, const std::filesystem::path& stem);

/// Whether a program is installed, as chromium, which prints pages.
bool has_program(const std::string& name);

/// A folder for what a program writes, away from results, that goes away with its contents.
struct Scratch {
  /// `name`-XXXXXX in a folder. @throws std::runtime_error where it cannot be made.
  Scratch(const std::filesystem::path& within, const std::string& name);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::filesystem::path folder;
};

std::string quoted_for_shell(const std::string& text);

}  // namespace rockstack::plots
