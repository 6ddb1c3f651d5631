#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plots/drawing/thinning.hpp"

namespace rockstack::plots {

/// A curve that a picture shows, as a table of numbers has it.
struct DrawnCurve {
  std::string words, colour;
  Curve curve;
};

/// A panel with its curves, by the words of its axes.
struct DrawnPanel {
  std::string across, up;
  bool logarithmic = false;  ///< up
  std::vector<DrawnCurve> curves = {};
};

/// How a picture is printed: in which letters, and how many pixels are an inch on paper.
struct Paper {
  std::string font = "DejaVu Sans";
  double per_inch = 125;
  bool alone = false;  ///< whether the picture is for print alone, and has its size on paper in every format
  double least = 0;    ///< size of letters, in points of a screen
};

/// A picture in gnuplot's words. `commands` are run once a format; point sizes are multiples of `mark`.
struct Drawing {
  int width = 1200;                     ///< pixels
  int height = 600;                     ///< pixels
  std::string data;                     ///< named data blocks
  std::string commands;                 ///< plot commands, without terminal and output
  double time_limit = 300;              ///< of gnuplot, s
  std::vector<DrawnPanel> panels = {};  ///< what it shows as numbers
  Paper paper = {};
  std::string nothing = {};                ///< the reason why there is nothing to show, if there is not
  std::vector<std::string> left_out = {};  ///< what is not in it, with the reasons
};

/// Text as a gnuplot string, to be drawn with `noenhanced`: in single quotes, within which gnuplot runs no
/// commands and expands no macros, joined by quotes in double ones, since it loses one doubled at the front.
std::string in_quotes(const std::string& text);

/// The colour of words that take their room and are not to be seen.
inline constexpr auto unseen = "#FF010203";

/// Draws `stem`.png, `stem`.svg and `stem`.pdf, and where the drawing says what it shows as numbers writes
/// these as `stem`.csv; all appear whole or none. Waits for gnuplot to finish.
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
