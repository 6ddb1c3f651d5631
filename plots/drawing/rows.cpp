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

/// Lines stand on the panel's edge, the last one lowest.
std::string title_above(const std::vector<std::pair<std::string, int>>& lines) {
  std::string labels;
  for (std::size_t i = 0; i < lines.size(); ++i)
    labels += fmt::format("set label {} noenhanced at graph 0.5, graph 1 center offset 0,{} font ',{}'\n",
                          in_quotes(lines[i].first), 0.7 + static_cast<double>(lines.size() - 1 - i),
                          lines[i].second);
  return labels;
}

}  // namespace

void add_rows(Sheet& sheet, const RowPanel& panel, const std::vector<RowColumn>& columns) {
  constexpr double edge = 30, title_line = 20;
  const RowWords words = row_words(panel.words, sheet.width());
  const auto rows = static_cast<double>(panel.words.size());
  const double height = panel.row_height > 0 ? panel.row_height : 10 + 16 * static_cast<double>(words.lines);
  const double width = (sheet.right() - words.left) * sheet.width() / static_cast<double>(columns.size());
  std::vector<SidePanel> cells;
  cells.reserve(columns.size());
  std::size_t above = 0;
  for (const RowColumn& column : columns) above = std::max(above, title_lines(column, width).size());
  sheet.leave_room_above(title_line * static_cast<double>(above));
  for (const RowColumn& column : columns)
    cells.push_back(
        {(column.range ? column.range(width) : logarithmic_range("x", panel.low, panel.high, width)) +
             title_above(title_lines(column, width)) +
             fmt::format("set yrange [{}:-0.7]\nset grid {} lt 1 dt solid lw 1 lc rgb '#E4E4E4'\n"
                         "set xlabel {}\n",
                         rows - 0.3, panel.grid, in_quotes(column.across)) +
             (cells.empty() ? words.tics : words.blank),
         column.plots});
  sheet.row(height * rows + edge, 0, cells, cells.size(), words.left);
}

}  // namespace rockstack::plots
