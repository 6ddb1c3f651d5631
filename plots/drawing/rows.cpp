#include "plots/drawing/rows.hpp"

#include <fmt/core.h>

#include "plots/drawing/axes.hpp"

namespace rockstack::plots {
namespace {

constexpr double letter = 8.4, margin = 30;  // pixels
constexpr double widest = 0.6;               // that words may take, a share of the figure's width

/// Words in lines of so many letters at most, broken after a comma, blank or hyphen, or before a plus.
std::vector<std::string> lines_of(const std::string& words, std::size_t most) {
  std::vector<std::string> lines;
  std::size_t start = 0;
  while (words.size() - start > most) {
    std::size_t end = start + most;
    while (end > start && words[end] != '+' && words[end - 1] != ',' && words[end - 1] != ' ' &&
           words[end - 1] != '-')
      --end;
    if (end == start) end = start + most;
    lines.push_back(words.substr(start, end - start));
    start = end;
  }
  lines.push_back(words.substr(start));
  return lines;
}

/// Words beside the rows of a panel.
struct RowWords {
  std::string tics;       ///< "set ytics …"
  std::string blank;      ///< the same without words, beside further panels
  double left = 0;        ///< where panels begin, a share of the figure's width
  std::size_t lines = 1;  ///< of the row that has most
};

RowWords row_words(const std::vector<std::string>& rows, double width) {
  RowWords result{"", "", left_edge, 1};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<std::string> lines =
        lines_of(rows[i], static_cast<std::size_t>((widest * width - margin) / letter));
    result.lines = std::max(result.lines, lines.size());
    result.tics += i > 0 ? ", " : "";
    for (std::size_t j = 0; j < lines.size(); ++j) {
      result.tics += fmt::format("{}{}", j > 0 ? R"(."\n".)" : "", in_quotes(lines[j]));
      result.left = std::max(result.left, (letter * static_cast<double>(lines[j].size()) + margin) / width);
    }
    result.tics += fmt::format(" {}", i);
    result.blank += fmt::format("{}'' {}", i > 0 ? ", " : "", i);
  }
  for (std::string* tics : {&result.tics, &result.blank})
    *tics = fmt::format("set ytics ({}) noenhanced font ',11'\n", *tics);
  return result;
}

/// The title of a column and the lines under it with the sizes of their fonts, in a panel of so many pixels.
std::vector<std::pair<std::string, int>> title_lines(const RowColumn& column, double width) {
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

/// Words of an axis as a gnuplot string, in lines that a panel of so many pixels has room for.
std::string axis_words(const RowColumn& column, double width) {
  std::string text;
  for (const std::string& line : lines_of(column.across, static_cast<std::size_t>(width / letter)))
    text += (text.empty() ? "" : R"(."\n".)") + in_quotes(line);
  return text;
}

/// The axis of a column, and above the panel the same one.
std::string axes_of(const RowColumn& column, const RowPanel& panel, double width, bool above) {
  std::string text = above ? "set xtics nomirror\n" : "";
  for (const std::string axis : {"x", "x2"}) {
    if (axis == "x2" && !above) break;
    text += column.end > 0 ? linear_range(axis, 0, column.end, width)
                           : logarithmic_range(axis, panel.low, panel.high, width);
    text += fmt::format("set {}label {}\n", axis, axis_words(column, width));
  }
  return text;
}

}  // namespace

void add_rows(Sheet& sheet, const RowPanel& panel, const std::vector<RowColumn>& columns) {
  constexpr double edge = 30, title_line = 20, screen = 600, axis_line = 20;
  const RowWords words = row_words(panel.words, sheet.width());
  const auto rows = static_cast<double>(panel.words.size());
  const double row_height =
      panel.row_height > 0 ? panel.row_height : 10 + 16 * static_cast<double>(words.lines);
  const double height = row_height * rows + edge;
  const double width = (sheet.right() - words.left) * sheet.width() / static_cast<double>(columns.size());
  const bool is_tall = height > screen;
  std::size_t titles = 0, axis_lines = 0;
  for (const RowColumn& column : columns) {
    titles = std::max(titles, title_lines(column, width).size());
    axis_lines =
        std::max(axis_lines, lines_of(column.across, static_cast<std::size_t>(width / letter)).size());
  }
  const double above = is_tall ? 1.6 + static_cast<double>(axis_lines) : 0;
  sheet.leave_room_above(title_line * static_cast<double>(titles) + axis_line * above);
  std::vector<SidePanel> cells;
  cells.reserve(columns.size());
  for (const RowColumn& column : columns)
    cells.push_back(
        {axes_of(column, panel, width, is_tall) + title_above(title_lines(column, width), above) +
             fmt::format("set yrange [{}:-0.7]\nset grid {} lt 1 dt solid lw 1 lc rgb '#E4E4E4'\n",
                         rows - 0.3, panel.grid) +
             column.settings + (cells.empty() ? words.tics + order_above(panel.order) : words.blank),
         column.plots});
  sheet.row(height, 0, cells, cells.size(), words.left);
  sheet.leave_room_above(axis_line * static_cast<double>(axis_lines - 1));
}

}  // namespace rockstack::plots
