#include "plots/drawing/rows.hpp"

#include <fmt/core.h>

#include "plots/drawing/axes.hpp"
#include "plots/drawing/words.hpp"

namespace rockstack::plots {
namespace {

constexpr double margin = 30;  // pixels

/// How wide a letter beside rows is, pixels.
double letter_of(const Sheet& sheet) {
  constexpr double usual = 8.4, points = 11;
  return usual * std::max(1.0, std::ceil(sheet.least()) / points);
}

/// What words may take, a share of the figure's width: on paper columns need more.
double widest_of(const Sheet& sheet) {
  return sheet.printed() ? 0.42 : 0.6;
}

/// The title of a column and the lines under it with the sizes of their fonts, in a panel of so many pixels.
std::vector<std::pair<std::string, int>> title_lines(const RowColumn& column, double width, double letter) {
  std::vector<std::pair<std::string, int>> lines;
  for (const auto& [words, each, size] : {std::tuple{column.title, letter, 13}, {column.subtitle, 6.6, 10}})
    if (!words.empty())
      for (const std::string& line : lines_of(words, static_cast<std::size_t>(width / each)))
        lines.emplace_back(line, size);
  return lines;
}

/// Lines stand so many lines above the panel's edge, the last one lowest.
std::string title_above(const std::vector<std::pair<std::string, int>>& lines, double above) {
  std::string labels;
  for (std::size_t i = 0; i < lines.size(); ++i)
    labels += fmt::format("set label {} noenhanced at graph 0.5, graph 1 center offset 0,{} font ',{}'\n",
                          in_quotes(lines[i].first), 0.7 + above + static_cast<double>(lines.size() - 1 - i),
                          lines[i].second);
  return labels;
}

/// In what order the rows stand, beside the panel's upper edge.
std::string order_above(const std::string& words) {
  if (words.empty()) return "";
  return fmt::format(
      "set label {} noenhanced at graph 0, graph 1 right offset -1,0.4 font ',11' tc rgb '#404040'\n",
      in_quotes(words));
}

/// The axis of a column, and above the panel the same one.
std::string axes_of(const RowColumn& column, const RowPanel& panel, double width, double letter, bool above) {
  std::string text = above ? "set xtics nomirror\n" : "";
  for (const std::string axis : {"x", "x2"}) {
    if (axis == "x2" && !above) break;
    text += column.end > 0 ? linear_range(axis, 0, column.end, width)
                           : logarithmic_range(axis, panel.low, panel.high, width);
    text += fmt::format("set {}label {}\n", axis,
                        joined_lines(lines_of(column.across, static_cast<std::size_t>(width / letter))));
  }
  return text;
}

}  // namespace

RowWords row_words(const std::vector<std::string>& rows, const Sheet& sheet, int first, int step) {
  const double width = sheet.width(), letter = letter_of(sheet);
  RowWords result{"", "", left_edge, 1};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<std::string> lines =
        lines_of(rows[i], static_cast<std::size_t>((widest_of(sheet) * width - margin) / letter));
    result.lines = std::max(result.lines, lines.size());
    result.tics += i > 0 ? ", " : "";
    for (std::size_t j = 0; j < lines.size(); ++j) {
      result.tics += fmt::format("{}{}", j > 0 ? R"(."\n".)" : "", in_quotes(lines[j]));
      result.left = std::max(result.left, (letter * static_cast<double>(lines[j].size()) + margin) / width);
    }
    const int place = first + step * static_cast<int>(i);
    result.tics += fmt::format(" {}", place);
    result.blank += fmt::format("{}'' {}", i > 0 ? ", " : "", place);
  }
  for (std::string* tics : {&result.tics, &result.blank})
    *tics = fmt::format("set ytics ({}) noenhanced font ',11'\n", *tics);
  return result;
}

void add_rows(Sheet& sheet, const RowPanel& panel, const std::vector<RowColumn>& columns) {
  constexpr double edge = 30, title_line = 20, screen = 600, axis_line = 20;
  const RowWords words = row_words(panel.words, sheet);
  const double letter = letter_of(sheet);
  const auto rows = static_cast<double>(panel.words.size());
  const double row_height = panel.row_height > 0 ? panel.row_height : words.row_height();
  const double height = row_height * rows + edge;
  const double width = (sheet.right() - words.left) * sheet.width() / static_cast<double>(columns.size());
  const bool is_tall = height > screen;
  std::size_t titles = 0, axis_lines = 0;
  for (const RowColumn& column : columns) {
    titles = std::max(titles, title_lines(column, width, letter).size());
    axis_lines =
        std::max(axis_lines, lines_of(column.across, static_cast<std::size_t>(width / letter)).size());
  }
  const double above = is_tall ? 1.6 + static_cast<double>(axis_lines) : 0;
  sheet.leave_room_above(title_line * static_cast<double>(titles) + axis_line * above);
  std::vector<SidePanel> cells;
  cells.reserve(columns.size());
  for (const RowColumn& column : columns)
    cells.push_back(
        {axes_of(column, panel, width, letter, is_tall) +
             title_above(title_lines(column, width, letter), above) +
             fmt::format("set yrange [{}:-0.7]\nset grid {} lt 1 dt solid lw 1 lc rgb '#E4E4E4'\n",
                         rows - 0.3, panel.grid) +
             column.settings + (cells.empty() ? words.tics + order_above(panel.order) : words.blank),
         column.plots});
  sheet.row(height, 0, cells, cells.size(), words.left);
  sheet.leave_room_above(axis_line * static_cast<double>(axis_lines - 1));
}

}  // namespace rockstack::plots
