#include <fmt/core.h>

#include "plots/drawing/layout.hpp"
#include "plots/drawing/words.hpp"

// Small panels of the same axes, one a series.

namespace rockstack::plots {
namespace {

/// Words above a small panel that has room for so many letters.
std::vector<std::string> lines_above(const std::string& words, std::size_t fitting) {
  std::vector<std::string> lines{""};
  for (std::size_t from = 0, to = 0; from < words.size(); from = to) {
    to = next_break(words, from);
    const std::string part = words.substr(from, to - from);
    if (!lines.back().empty() && lines.back().size() + part.size() > fitting)
      lines.push_back(part);
    else
      lines.back() += part;
  }
  return lines;
}

/// The words above a small panel, each line in a size that stays above it.
std::string words_above(const Series& one, std::size_t fitting) {
  const std::vector<std::string> lines = lines_above(one.words, fitting);
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += fmt::format(
        "set label {} noenhanced at graph 0, graph 1 left offset 0,{} font ',{}' tc rgb '{}' front\n",
        in_quotes(lines[i]), 0.5 + 0.8 * static_cast<double>(lines.size() - 1 - i),
        words_size(lines[i], 12, fitting - 1), one.colour);
  return text;
}

/// The columns of small panels, and how wide each is, pixels.
struct Multiples {
  std::size_t columns = 3;
  double left = left_edge, width = multiple_width;

  Multiples(const Sheet& sheet, std::size_t series, double from) : left(from) {
    if (!sheet.printed()) {
      columns = std::min(columns, series);
      return;
    }
    constexpr double least = 200;
    left = std::max(left, narrow_left / sheet.width());
    const double room = (sheet.right() - left) * sheet.width();
    columns = std::min({columns, series, static_cast<std::size_t>(std::max(1.0, room / least))});
    width =
        std::min(room / static_cast<double>(columns), 1.2 * multiple_width) - multiples_apart * sheet.width();
  }

  /// Letters that words above a panel have room for.
  std::size_t letters() const {
    return static_cast<std::size_t>((columns == 3 ? 41 : 36) * width / multiple_width);
  }
};

}  // namespace

void add_multiples(Sheet& sheet, const std::vector<Series>& series, const std::vector<std::string>& context,
                   const PanelSettings& settings, const std::string& across, const std::string& up,
                   double left) {
  const Multiples grid(sheet, series.size(), left);
  constexpr double line = 16, gap = 34, before = 92;
  std::size_t most_lines = 1;
  for (const Series& one : series)
    most_lines = std::max(most_lines, lines_above(one.words, grid.letters()).size());
  const double further_lines = line * static_cast<double>(most_lines - 1);
  sheet.leave_room_above(further_lines);
  const std::string common = settings(grid.width, multiple_height);
  const std::vector<std::string> below =
      sheet.printed() ? lines_of(across, static_cast<std::size_t>(grid.width / printed_letter))
                      : std::vector{across};
  for (std::size_t from = 0; from < series.size(); from += grid.columns) {
    std::vector<SidePanel> cells;
    for (std::size_t i = from; i < std::min(from + grid.columns, series.size()); ++i) {
      std::vector<std::string> plots = context;
      plots.insert(plots.end(), series[i].alone.begin(), series[i].alone.end());
      std::string words = common + words_above(series[i], grid.letters());
      words += i + grid.columns < series.size() ? without_horizontal_labels
                                                : fmt::format("set xlabel {}\n", joined_lines(below));
      words += i == from ? fmt::format("set ylabel {} noenhanced offset 0.5\n", in_quotes(up))
                         : fmt::format("set ytics textcolor rgb '{}'\nunset ylabel\n", unseen);
      cells.push_back({words, plots});
    }
    sheet.row(multiple_height, from == 0 ? before : gap + further_lines, cells, grid.columns, grid.left);
  }
  sheet.leave_room_above(24 * static_cast<double>(below.size() - 1));
}

}  // namespace rockstack::plots
