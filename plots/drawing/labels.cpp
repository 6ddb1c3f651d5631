#include "plots/drawing/labels.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "plots/drawing/layout.hpp"

namespace rockstack::plots {
namespace {

/// A rectangle in pixels that is taken by a mark, a word or a piece of a line.
struct Box {
  double left, right, low, high;

  bool meets(const Box& other) const {
    return left < other.right && other.left < right && low < other.high && other.low < high;
  }
};

Box around(double x, double y, double half) {
  return {x - half, x + half, y - half, y + half};
}

bool meets_any(const Box& box, const std::vector<Box>& others) {
  return std::any_of(others.begin(), others.end(), [&](const Box& other) { return box.meets(other); });
}

/// What lines pass through, as boxes beside each other.
std::vector<Box> line_boxes(const LabelledPanel& panel) {
  constexpr double step = 4, half = 2;
  std::vector<Box> boxes;
  for (const std::vector<LabelledMark>& line : panel.lines)
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double across = line[i].x - line[i - 1].x, up = line[i].y - line[i - 1].y;
      const int parts = 1 + static_cast<int>(std::hypot(across, up) / step);
      for (int part = 0; part <= parts; ++part)
        boxes.push_back(
            around(line[i - 1].x + across * part / parts, line[i - 1].y + up * part / parts, half));
    }
  return boxes;
}

/// Where a label stands: its box, and on which side of the mark.
struct LabelPlace {
  Box box;
  double side;
};

/// The first of four corners of a mark that is free of all boxes.
std::optional<LabelPlace> free_corner(const LabelledPanel& panel, const LabelledMark& mark,
                                      const std::vector<Box>& taken, const std::vector<Box>& lines) {
  const double width = 9.5 * static_cast<double>(mark.word.size()) + 4;
  constexpr double aside = 11, half_height = 8, rise = 12;
  for (const double side : {1.0, -1.0})
    for (const double lift : {rise, -rise}) {
      const double near = mark.x + side * aside, far = near + side * width;
      const Box box{std::min(near, far), std::max(near, far), mark.y + lift - half_height,
                    mark.y + lift + half_height};
      const bool inside = box.left > 0 && box.right < panel.width && box.low > 0 && box.high < panel.height;
      if (inside && !meets_any(box, taken) && !meets_any(box, lines)) return LabelPlace{box, side};
    }
  return std::nullopt;
}

std::string command(const LabelledPanel& panel, const LabelledMark& mark, const LabelPlace& place) {
  const bool right = place.side > 0;
  return fmt::format("set label '{}' at graph {}, graph {} {} font ',11' textcolor rgb '{}' front\n",
                     mark.word, plain((right ? place.box.left : place.box.right) / panel.width),
                     plain((place.box.low + place.box.high) / 2 / panel.height), right ? "left" : "right",
                     mark.colour);
}

}  // namespace

std::string placed_labels(const LabelledPanel& panel) {
  constexpr double half_mark = 7;
  std::vector<Box> taken;
  for (const std::vector<LabelledMark>& line : panel.lines)
    for (const LabelledMark& mark : line) taken.push_back(around(mark.x, mark.y, half_mark));
  const std::vector<Box> crossed = line_boxes(panel);
  std::string text;
  for (const std::vector<LabelledMark>& line : panel.lines)
    for (const LabelledMark& mark : line) {
      std::optional<LabelPlace> place = free_corner(panel, mark, taken, crossed);
      if (!place) place = free_corner(panel, mark, taken, {});
      if (!place) continue;
      taken.push_back(place->box);
      text += command(panel, mark, *place);
    }
  return text;
}

}  // namespace rockstack::plots
