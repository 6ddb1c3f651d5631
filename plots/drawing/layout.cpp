#include "plots/drawing/layout.hpp"

#include <fmt/format.h>

namespace rockstack::plots {
namespace {

constexpr double legend_gap = 14, axis_height = 80;

/// The height of a row, pixels; on a slide letters are smaller beside what they stand for.
double legend_row(double width) {
  return width == slide_width ? 20 : 23;
}

/// In two columns, or in one where some words are too long for half of the figure.
std::size_t legend_rows(const Legend& legend, double width) {
  // Pixels, with what stands before the words: a part of them that is larger in a narrow figure.
  const double letter = width == slide_width ? 10.5 : width < slide_width ? 14.5 : 13;
  const bool wide = std::ranges::any_of(legend, [&](const auto& entry) {
    return letter * static_cast<double>(entry.second.size()) > width / 2;
  });
  return wide ? legend.size() : (legend.size() + 1) / 2;
}

/// Without a legend there is room for the words above a panel.
double legend_height(const Legend& legend, double width) {
  return legend.empty() ? legend_row(width)
                        : static_cast<double>(legend_rows(legend, width)) * legend_row(width) + legend_gap;
}

double title_height(const std::string& title) {
  return title.empty() ? 10 : 56;
}

/// Nothing that one panel sets holds for the next.
constexpr auto fresh_panel =
    "unset grid\nunset object\nunset logscale\nset format x '% h'\nset format y '% h'\nunset xlabel\n"
    "unset ylabel\nunset x2label\nunset x2tics\nset xtics autofreq font '' textcolor rgb '#000000'\n"
    "set ytics autofreq font '' textcolor rgb '#000000'\nset mxtics default\nset mytics default\n";

constexpr auto comma = ", \\\n  ";

/// One column of a legend: a plot without data whose only content is the key. The formats measure text
/// differently, so that columns placed by gnuplot would not be the same in both.
std::string legend_column(const Legend& legend, std::size_t from, std::size_t to, double left, double top,
                          const char* font) {
  std::vector<std::string> entries{"NaN notitle"};
  for (std::size_t i = from; i < to; ++i)
    entries.push_back(
        fmt::format("keyentry {} title {} noenhanced", legend[i].first, in_quotes(legend[i].second)));
  return fmt::format(
      "set key at screen {}, screen {} left top vertical maxcols 1 Left reverse samplen 3.2 font '{}'\n"
      "plot [0:1][0:1] {}\nunset label\n",
      plain(left), plain(top), font, fmt::join(entries, comma));
}

/// `top` is its upper edge, a share of the figure's height from below.
std::string legend_plots(const Legend& legend, double top, double width) {
  if (legend.empty()) return "";
  constexpr double first = left_edge - 0.01, second = 0.54;
  const char* font = width == slide_width ? ",12" : "";
  const std::size_t half = legend_rows(legend, width);
  std::string text = "unset border\nunset tics\nset margins screen 0, screen 1, screen 0, screen 1\n";
  text += legend_column(legend, 0, half, first, top, font);
  if (half < legend.size()) text += legend_column(legend, half, legend.size(), second, top, font);
  return text + "set border\nset tics\nunset key\n";
}

/// Long words are smaller than usual to stay inside the figure; `fitting` letters of the usual size do.
int words_size(const std::string& words, std::size_t usual, std::size_t fitting) {
  return static_cast<int>(usual * fitting / std::max(words.size(), fitting));
}

/// Letters of the usual size that a line under the title has room for, capitals among them.
constexpr std::size_t readable = 105;

/// A line under the title, its middle at `height`, a share of the figure's from below; none without words.
std::string question_line(const std::string& words, double height) {
  if (words.empty()) return "";
  return fmt::format("set label {} noenhanced at screen 0.5, screen {} center font ',{}' tc rgb '#404040'\n",
                     in_quotes(words), plain(height), words_size(words, 14, readable));
}

/// Where words may be broken next: behind a comma, or before a further parameter, "…+name=value".
std::size_t next_break(const std::string& words, std::size_t from) {
  for (std::size_t at = from + 1; at < words.size(); ++at)
    if (words.compare(at - 1, 2, ", ") == 0)
      return at + 1;
    else if (words[at] == '+' && words[at - 1] != ' ')
      return at;
  return words.size();
}

/// The question in a line, its answer in another, or in two where the letters of one would be too small.
std::vector<std::string> question_lines(const std::string& question) {
  const std::size_t mark = question.find("? ");
  if (question.empty()) return {};
  if (mark == std::string::npos) return {question};
  const std::string asked = question.substr(0, mark + 1), answer = question.substr(mark + 2);
  if (answer.size() <= readable) return {asked, answer};
  std::size_t middle = 0;
  while (middle < answer.size() / 2) middle = next_break(answer, middle);
  return {asked, answer.substr(0, middle), answer.substr(middle)};
}

constexpr double answer_row = 22;

double question_height(const std::vector<std::string>& lines) {
  return lines.empty() ? 0 : 46 + (lines.size() > 2 ? answer_row : 0);
}

std::vector<std::string> lines_of(const std::string& words) {
  constexpr std::size_t fitting = 41;
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
std::string words_above(const Series& one) {
  const std::vector<std::string> lines = lines_of(one.words);
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += fmt::format(
        "set label {} noenhanced at graph 0, graph 1 left offset 0,{} font ',{}' tc rgb '{}' front\n",
        in_quotes(lines[i]), 0.5 + 0.8 * static_cast<double>(lines.size() - 1 - i),
        words_size(lines[i], 12, 40), one.colour);
  return text;
}

}  // namespace

std::string plain(double value) {
  return fmt::format("{:.8g}", value);
}

std::string data_block(const std::string& name, const Curve& curve) {
  std::string text = fmt::format("${} << END\n", name);
  for (std::size_t i = 0; i < curve.size(); ++i)
    text += fmt::format("{:.8g} {:.6g}\n", curve.times[i], curve.values[i]);
  return text + "END\n";
}

Sheet::Sheet(const std::string& title, const Legend& legend, const std::string& question, double width)
    : below_(title_height(title) + question_height(question_lines(question)) + legend_height(legend, width)),
      width_(width),
      right_(1 - (1 - right_edge) * full_width / width),
      title_(title),
      question_(question_lines(question)),
      legend_(legend) {}

void Sheet::panel(double height, double gap, const std::string& settings,
                  const std::vector<std::string>& plots) {
  const double left = width_ < slide_width ? narrow_left : left_edge * full_width;
  row(height, gap, {{settings, plots}}, 1, left / width_);
}

void Sheet::row(double height, double gap, const std::vector<SidePanel>& cells, std::size_t columns,
                double left, double between) {
  below_ += panels_.empty() ? 0 : gap;
  const double pace = (right_ - left + between) / static_cast<double>(columns);
  for (const SidePanel& cell : cells) {
    panels_.push_back({below_, below_ + height, left, left + pace - between, cell.settings,
                       cell.plots.empty() ? "NaN notitle" : fmt::format("{}", fmt::join(cell.plots, comma))});
    left += pace;
  }
  below_ += height;
}

Drawing Sheet::finish() const {
  constexpr double word_row = 22;
  const double words_top = below_ + axis_height;
  const double height = std::ceil(words_top + static_cast<double>(notes_.size()) * word_row);
  std::string text = fmt::format(
      "set multiplot\nunset key\nset label 1 {} noenhanced at screen 0.5, screen {} center font ',{}'\n",
      in_quotes(title_), plain(1 - title_height(title_) / 2 / height),
      words_size(title_, 17, static_cast<std::size_t>(88 * std::min(width_, full_width) / full_width)));
  const double head = title_height(title_) - 4 + question_height(question_);
  constexpr double half_row = answer_row / 2;
  for (std::size_t i = 0; i < question_.size(); ++i) {
    const double below = answer_row * static_cast<double>(question_.size() - 1 - i);
    const double middle = i == 0 ? title_height(title_) - 4 + half_row : head - half_row - 2 - below;
    text += question_line(question_[i], 1 - middle / height);
  }
  text += legend_plots(legend_, 1 - head / height, width_);
  for (const Panel& panel : panels_) {
    text += fmt::format("set margins screen {}, screen {}, screen {}, screen {}\n", plain(panel.left),
                        plain(panel.right), plain(1 - panel.bottom / height), plain(1 - panel.top / height));
    if (&panel == &panels_.back())
      for (std::size_t i = 0; i < notes_.size(); ++i)
        text += fmt::format("set label {} noenhanced at screen {}, screen {} left font ',12' tc rgb '{}'\n",
                            in_quotes(notes_[i].first), left_edge,
                            plain(1 - (words_top + static_cast<double>(i) * word_row) / height),
                            notes_[i].second);
    text += fresh_panel;
    text += panel.settings + fmt::format("plot {}\nunset label\nunset arrow\n", panel.plots);
  }
  return {.width = static_cast<int>(width_),
          .height = static_cast<int>(height),
          .data = blocks_,
          .commands = text + "unset multiplot",
          .panels = drawn_,
          .paper = paper_};
}

Drawing empty_sheet(const std::string& title, const std::string& text) {
  Sheet sheet(title, {});
  sheet.panel(120, 0,
              "unset tics\nset xrange [0:1]\nset yrange [0:1]\nset label 2 " + in_quotes(text) +
                  " noenhanced at graph 0.5, graph 0.5 center\n",
              {});
  return sheet.finish();
}

void add_multiples(Sheet& sheet, const std::vector<Series>& series, const std::vector<std::string>& context,
                   const std::string& settings, const std::string& across, const std::string& up,
                   double left) {
  constexpr std::size_t most_columns = 3;
  const std::size_t columns = std::min(most_columns, series.size());
  constexpr double line = 16, gap = 34, before = 92;
  std::size_t most_lines = 1;
  for (const Series& one : series) most_lines = std::max(most_lines, lines_of(one.words).size());
  const double further_lines = line * static_cast<double>(most_lines - 1);
  sheet.leave_room_above(further_lines);
  for (std::size_t from = 0; from < series.size(); from += columns) {
    std::vector<SidePanel> cells;
    for (std::size_t i = from; i < std::min(from + columns, series.size()); ++i) {
      std::vector<std::string> plots = context;
      plots.insert(plots.end(), series[i].alone.begin(), series[i].alone.end());
      std::string words = settings + words_above(series[i]);
      words += i + columns < series.size() ? without_horizontal_labels
                                           : fmt::format("set xlabel {}\n", in_quotes(across));
      words += i == from ? fmt::format("set ylabel {} noenhanced offset 0.5\n", in_quotes(up))
                         : fmt::format("set ytics textcolor rgb '{}'\nunset ylabel\n", unseen);
      cells.push_back({words, plots});
    }
    sheet.row(multiple_height, from == 0 ? before : gap + further_lines, cells, columns, left);
  }
}

std::string subscript(int number) {
  constexpr std::array digits{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  std::string text;
  for (const char c : std::to_string(number)) text += digits.at(static_cast<std::size_t>(c - '0'));
  return text;
}

std::string angle_name(int block) {
  return "θ" + subscript(block);
}

}  // namespace rockstack::plots
