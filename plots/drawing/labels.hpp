#pragma once

#include <string>
#include <vector>

namespace rockstack::plots {

/// A mark with a word, in pixels from a panel's lower left corner.
struct LabelledMark {
  double x = 0, y = 0;
  std::string word, colour;
};

/// Where a panel has labels beside its marks.
struct LabelledPanel {
  double width = 0, height = 0;                  ///< pixels
  std::vector<std::vector<LabelledMark>> lines;  ///< marks that a line joins in their order
};

/// gnuplot's commands for the words beside their marks: clear of lines where there is room, and left out
/// where labels or marks are in the way.
std::string placed_labels(const LabelledPanel& panel);

}  // namespace rockstack::plots
