#include "plots/drawing/layout.hpp"

#include <fmt/format.h>

#include "plots/drawing/told.hpp"
#include "plots/drawing/words.hpp"

namespace rockstack::plots {
namespace {

constexpr double legend_gap = 14, axis_height = 80;
constexpr double shown_before = 72;  // pixels, before words of a legend

/// Letters of a title that a figure has room for.
std::size_t title_letters(double width) {
  return static_cast<std::size_t>(88 * std::min(width, full_width) / full_width);
}

/// The height of a row, pixels; on a slide letters are smaller beside what they stand for.
double legend_row(double width) {
  return width == slide_width ? 20 : 23;
}

/// In two columns, or in one where some words are too long for half of the figure.
std::size_t legend_rows(const Legend& legend, double width, const Paper& paper) {
  // Pixels, with what stands before the words: a part of them that is larger in a narrow figure.
  const double letter = width == slide_width ? 10.5 : width < slide_width ? 14.5 : 13;
  const bool wide = std::ranges::any_of(legend, [&](const auto& entry) {
    const auto size = static_cast<double>(entry.second.size());
    return paper.alone ? shown_before + printed_letter * size > 0.44 * width : letter * size > width / 2;
  });
  return wide ? legend.size() : (legend.size() + 1) / 2;
}

/// With long words in several entries, of which only the first shows what they stand for.
Legend broken(const Legend& legend, double width) {
  constexpr auto nothing = "with points pt 7 ps 0 lc rgb '#FFFFFF'";
  const auto most = static_cast<std::size_t>(((1 - left_edge) * width - shown_before) / printed_letter);
  Legend lines;
  for (const auto& [style, words] : legend) {
    std::string shown = style;
    for (const std::string& line : lines_of(words, most))
      lines.emplace_back(std::exchange(shown, nothing), line);
  }
  return lines;
}

/// Without a legend there is room for the words above a panel.
double legend_height(const Legend& legend, double width, const Paper& paper) {
  return legend.empty()
             ? legend_row(width)
             : static_cast<double>(legend_rows(legend, width, paper)) * legend_row(width) + legend_gap;
}

constexpr double title_row = 26;
constexpr std::size_t first_title = 101;  // of labels, which panels number from 2 on

/// One line on a page, where long ones are smaller; on paper as many as they need.
std::vector<std::string> title_lines(const std::string& title, double width, const Paper& paper) {
  if (title.empty()) return {};
  return paper.alone ? lines_of(title, title_letters(width)) : std::vector{title};
}

double title_height(const std::vector<std::string>& lines) {
  return lines.empty() ? 10 : 56 + title_row * static_cast<double>(lines.size() - 1);
}

std::string titles(const std::vector<std::string>& lines, double width, double height) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += fmt::format("set label {} {} noenhanced at screen 0.5, screen {} center font ',{}'\n",
                        first_title + i, in_quotes(lines[i]),
                        plain(1 - (28 + title_row * static_cast<double>(i)) / height),
                        words_size(lines[i], 17, title_letters(width)));
  return text;
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
std::string legend_plots(const Legend& legend, double top, double width, const Paper& paper) {
  if (legend.empty()) return "";
  constexpr double first = left_edge - 0.01, second = 0.54;
  const char* font = width == slide_width ? ",12" : "";
  const std::size_t half = legend_rows(legend, width, paper);
  std::string text = "unset border\nunset tics\nset margins screen 0, screen 1, screen 0, screen 1\n";
  text += legend_column(legend, 0, half, first, top, font);
  if (half < legend.size()) text += legend_column(legend, half, legend.size(), second, top, font);
  return text + "set border\nset tics\nunset key\n";
}

/// Letters of the usual size that a line under the title has room for, capitals among them.
constexpr std::size_t readable = 105;

/// A line under the title, its middle at `height`, a share of the figure's from below; none without words.
std::string question_line(const std::string& words, double height) {
  if (words.empty()) return "";
  return fmt::format("set label {} noenhanced at screen 0.5, screen {} center font ',{}' tc rgb '#404040'\n",
                     in_quotes(words), plain(height), words_size(words, 14, readable));
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

using Notes = std::vector<std::pair<std::string, std::string>>;

/// Where notes begin, a share of the figure's width.
double note_left(const Sheet& sheet) {
  return sheet.printed() ? 0.02 : left_edge;
}

/// On paper in as many lines as they need.
Notes note_lines(const Notes& notes, const Sheet& sheet) {
  if (!sheet.printed()) return notes;
  constexpr double letter = 9.2;  // pixels
  Notes lines;
  for (const auto& [words, colour] : notes)
    for (const std::string& line :
         lines_of(words, static_cast<std::size_t>((1 - 2 * note_left(sheet)) * sheet.width() / letter)))
      lines.emplace_back(line, colour);
  return lines;
}

}  // namespace

std::string joined_lines(const std::vector<std::string>& lines) {
  return joined_texts(lines, in_quotes, R"(."\n".)");
}

std::string plain(double value) {
  return fmt::format("{:.8g}", value);
}

std::string data_block(const std::string& name, const Curve& curve) {
  std::string text = fmt::format("${} << END\n", name);
  for (std::size_t i = 0; i < curve.size(); ++i)
    text += fmt::format("{:.8g} {:.6g}\n", curve.times[i], curve.values[i]);
  return text + "END\n";
}

Sheet::Sheet(const std::string& title, const Legend& legend, const std::string& question, double width,
             const Paper& paper)
    : width_(width),
      right_(1 - (1 - right_edge) * full_width / width),
      title_(title_lines(title, width, paper)),
      question_(question_lines(question)),
      legend_(paper.alone ? broken(legend, width) : legend),
      paper_(paper) {
  below_ = title_height(title_) + question_height(question_) + legend_height(legend_, width_, paper_);
}

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
    panels_.push_back({below_, below_ + height, left, left + pace - between, cell});
    left += pace;
  }
  below_ += height;
}

/// On paper of all curves, those that nobody has told as well.
std::vector<DrawnPanel> Sheet::numbers() const {
  std::vector<DrawnPanel> all = drawn_;
  if (!printed()) return all;
  std::string across, up;
  for (auto panel = panels_.rbegin(); panel != panels_.rend(); ++panel) {
    DrawnPanel told = told_of(panel->cell, blocks_, legend_, drawn_);
    across = told.across = told.across.empty() ? across : told.across;
    up = told.up = told.up.empty() ? up : told.up;
    if (!told.curves.empty()) all.insert(all.begin() + std::ssize(drawn_), std::move(told));
  }
  return all;
}

Drawing Sheet::finish() const {
  constexpr double word_row = 22;
  const double words_top = below_ + axis_height;
  const std::vector<std::pair<std::string, std::string>> notes = note_lines(notes_, *this);
  const double height = std::ceil(words_top + static_cast<double>(notes.size()) * word_row);
  std::string text = "set multiplot\nunset key\n" + titles(title_, width_, height);
  const double head = title_height(title_) - 4 + question_height(question_);
  constexpr double half_row = answer_row / 2;
  for (std::size_t i = 0; i < question_.size(); ++i) {
    const double below = answer_row * static_cast<double>(question_.size() - 1 - i);
    const double middle = i == 0 ? title_height(title_) - 4 + half_row : head - half_row - 2 - below;
    text += question_line(question_[i], 1 - middle / height);
  }
  text += legend_plots(legend_, 1 - head / height, width_, paper_);
  for (const Panel& panel : panels_) {
    text += fmt::format("set margins screen {}, screen {}, screen {}, screen {}\n", plain(panel.left),
                        plain(panel.right), plain(1 - panel.bottom / height), plain(1 - panel.top / height));
    if (&panel == &panels_.back())
      for (std::size_t i = 0; i < notes.size(); ++i)
        text +=
            fmt::format("set label {} noenhanced at screen {}, screen {} left font ',12' tc rgb '{}'\n",
                        in_quotes(notes[i].first), note_left(*this),
                        plain(1 - (words_top + static_cast<double>(i) * word_row) / height), notes[i].second);
    text += fresh_panel;
    const std::vector<std::string>& plots = panel.cell.plots;
    text += panel.cell.settings +
            fmt::format("plot {}\nunset label\nunset arrow\n",
                        plots.empty() ? "NaN notitle" : fmt::format("{}", fmt::join(plots, comma)));
  }
  return {.width = static_cast<int>(width_),
          .height = static_cast<int>(height),
          .data = blocks_,
          .commands = text + "unset multiplot",
          .panels = numbers(),
          .paper = paper_};
}

Drawing empty_sheet(const std::string& title, const std::string& text) {
  Sheet sheet(title, {});
  sheet.panel(120, 0,
              "unset tics\nset xrange [0:1]\nset yrange [0:1]\nset label 2 " + in_quotes(text) +
                  " noenhanced at graph 0.5, graph 0.5 center\n",
              {});
  Drawing drawing = sheet.finish();
  drawing.nothing = text;
  return drawing;
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
