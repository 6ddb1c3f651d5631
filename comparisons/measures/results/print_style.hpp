#pragma once

#include "analytic/scene/input/key.hpp"

namespace rockstack {

/// How figures are drawn for print.
struct PrintStyle {
  enum class Kind { paper };
  enum class Unit { automatic, rad, mrad, deg };

  Kind style = Kind::paper;
  double width = 88;                      ///< mm, 50 to 400
  std::string font = "DejaVu Sans";       ///< family
  double font_size = 8;                   ///< pt, 4 to 24
  Unit unit = Unit::automatic;            ///< of angles
  bool titles = true;                     ///< whether a figure has its scene's title
  std::vector<std::string> figures = {};  ///< names, "error-step"; empty: all that can show what is asked
  std::vector<std::string> panels = {};   ///< over time, "θ2", or "slip" for all blocks; empty: all angles
  double from = 0;                        ///< where axes of time begin, s
  double to = HUGE_VAL;                   ///< and where they end at the latest, s
};

extern const KeysOf<PrintStyle> print_keys;

/// The table [figures] of a suite, or what a program or Python was given. @throws InputError with place, key,
/// value and what is allowed.
PrintStyle read_print_style(const Node& table);

/// A table with the option texts of a command line, by the names of keys; "88mm" is 88 of a key in mm, and
/// commas part the entries of a list.
Node style_table(const std::vector<std::pair<std::string, std::string>>& options);

/// Lines "key = value" of a table as results keep them, which read_style_text() reads.
std::string style_text(const Node& table);
PrintStyle read_style_text(const std::string& text, const std::string& place);

}  // namespace rockstack
