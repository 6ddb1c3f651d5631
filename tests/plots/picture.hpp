#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace rockstack::testing {

// What a picture shows, read from gnuplot's SVG. Places are in pixels from the upper left corner.

struct ShownText {
  double x = 0, y = 0;  ///< where it is anchored, on its base line
  double size = 0;      ///< of its font
  std::string anchor;   ///< "start", "middle" or "end"
  std::string colour, words;
  bool turned = false;  ///< along a vertical axis
};

struct ShownMark {
  double x = 0, y = 0;
  std::string colour;  ///< "rgb(0,114,178)"
};

struct ShownLine {
  std::string colour;
  double width = 0;
  std::vector<std::pair<double, double>> points;
};

struct Picture {
  double width = 0, height = 0;
  std::vector<ShownText> texts;  ///< those that can be seen
  std::vector<ShownMark> marks;
  std::vector<ShownLine> lines;

  bool says(const std::string& words) const;
  std::vector<ShownMark> marks_of(const std::string& colour) const;
  std::vector<ShownLine> lines_of(const std::string& colour) const;
};

Picture read_picture(const std::filesystem::path& svg);

/// "#0072B2" as pictures have it.
std::string shown_colour(const std::string& hexadecimal);

/// Texts that lie on each other or reach over the picture's edge, by their words. Letters are taken a little
/// narrower than they are, so that what is told is so, times `wider`.
std::vector<std::string> collisions(const Picture& picture, double wider = 1);

/// An axis as its numbers say: value = at + slope × pixel. Of those numbers that stand at the left of a panel
/// whose tics lie between two heights, or below it between two places.
struct ShownAxis {
  double at = 0, slope = 0;
  double value(double pixel) const { return at + slope * pixel; }
};

/// The linear axis along the left edge of the panel that spans so many pixels downwards.
ShownAxis left_axis(const Picture& picture, double top, double bottom);

}  // namespace rockstack::testing
