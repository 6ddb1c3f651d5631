#include "plots/drawing/layout.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rockstack::plots {
namespace {

constexpr double left_edge = 0.095, right_edge = 0.975;
constexpr double title_height = 56, legend_row = 28, legend_gap = 14, axis_height = 80;
constexpr std::size_t half_a_figure = 46;  // letters of a legend

/// In two columns, or in one where some words are too long for half of the figure.
std::size_t legend_rows(const Legend& legend) {
  const bool wide = std::any_of(legend.begin(), legend.end(),
                                [](const auto& entry) { return entry.second.size() > half_a_figure; });
  return wide ? legend.size() : (legend.size() + 1) / 2;
}

double legend_height(const Legend& legend) {
  return legend.empty() ? 0 : static_cast<double>(legend_rows(legend)) * legend_row + legend_gap;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", \\\n  ") + part;
  return text;
}

/// One column of a legend: a plot without data whose only content is the key. The formats measure text
/// differently, so that columns placed by gnuplot would not be the same in both.
std::string legend_column(const Legend& legend, std::size_t from, std::size_t to, double left,
                          double height) {
  std::vector<std::string> entries{"NaN notitle"};
  for (std::size_t i = from; i < to; ++i)
    entries.push_back(
        fmt::format("keyentry {} title {} noenhanced", legend[i].first, in_quotes(legend[i].second)));
  return fmt::format(
      "set key at screen {}, screen {} left top vertical maxcols 1 Left reverse samplen 3.2\n"
      "plot [0:1][0:1] {}\nunset label\n",
      plain(left), plain(1 - (title_height - 4) / height), joined(entries));
}

std::string legend_plots(const Legend& legend, double height) {
  if (legend.empty()) return "";
  constexpr double first = left_edge - 0.01, second = 0.54;
  const std::size_t half = legend_rows(legend);
  std::string text = "unset border\nunset tics\nset margins screen 0, screen 1, screen 0, screen 1\n";
  text += legend_column(legend, 0, half, first, height);
  if (half < legend.size()) text += legend_column(legend, half, legend.size(), second, height);
  return text + "set border\nset tics\nunset key\n";
}

/// Long titles are set smaller, so that they stay inside the figure.
int title_size(const std::string& title) {
  constexpr std::size_t usual = 17, fitting = 88;  // letters across the figure
  return static_cast<int>(usual * fitting / std::max(title.size(), fitting));
}

}  // namespace

std::string in_quotes(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') {
      result += R"('."'".')";
    } else {
      result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return result + "'";
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

Sheet::Sheet(const std::string& title, const Legend& legend)
    : below_(title_height + legend_height(legend)), title_(title), legend_(legend) {}

void Sheet::panel(double height, double gap, const std::string& settings,
                  const std::vector<std::string>& plots) {
  below_ += panels_.empty() ? 0 : gap;
  const std::string elements = plots.empty() ? "NaN notitle" : joined(plots);
  panels_.push_back({below_, below_ + height, settings, elements});
  below_ += height;
}

Drawing Sheet::finish() const {
  constexpr double word_row = 22;
  const double words_top = below_ + axis_height;
  const double height = std::ceil(words_top + static_cast<double>(notes_.size()) * word_row);
  std::string text = fmt::format(
      "set multiplot\nunset key\nset label 1 {} noenhanced at screen 0.5, screen {} center font ',{}'\n",
      in_quotes(title_), plain(1 - title_height / 2 / height), title_size(title_));
  text += legend_plots(legend_, height);
  for (const Panel& panel : panels_) {
    text += fmt::format("set margins screen {}, screen {}, screen {}, screen {}\n", left_edge, right_edge,
                        plain(1 - panel.bottom / height), plain(1 - panel.top / height));
    if (&panel == &panels_.back())
      for (std::size_t i = 0; i < notes_.size(); ++i)
        text += fmt::format("set label {} noenhanced at screen {}, screen {} left font ',12' tc rgb '{}'\n",
                            in_quotes(notes_[i].first), left_edge,
                            plain(1 - (words_top + static_cast<double>(i) * word_row) / height),
                            notes_[i].second);
    text += panel.settings + fmt::format("plot {}\nunset label\nunset arrow\n", panel.plots);
  }
  return {.height = static_cast<int>(height), .data = blocks_, .commands = text + "unset multiplot"};
}

std::string logarithmic_tics(const std::string& axis, double low, double high) {
  constexpr double enough = 100;
  if (high / low >= enough) return fmt::format("set format {} '10^{{%T}}'\n", axis);
  std::string tics;
  for (int power = static_cast<int>(std::floor(std::log10(low))); std::pow(10, power) <= high; ++power)
    for (const int times : {1, 2, 5})
      tics +=
          fmt::format("{}'{}10^{{{}}}' {}", tics.empty() ? "" : ", ",
                      times == 1 ? "" : fmt::format("{}·", times), power, plain(times * std::pow(10, power)));
  return fmt::format("set {}tics ({})\n", axis, tics);
}

std::string without_horizontal_labels() {
  return "set format x ''\nunset xlabel\n";
}

Drawing empty_sheet(const std::string& title, const std::string& text) {
  Sheet sheet(title, {});
  constexpr double height = 120;
  sheet.panel(height, 0,
              "unset tics\nset xrange [0:1]\nset yrange [0:1]\nset label 2 " + in_quotes(text) +
                  " noenhanced at graph 0.5, graph 0.5 center\n",
              {});
  return sheet.finish();
}

std::string angle_name(int block) {
  constexpr std::array digits{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  std::string name = "θ";
  for (const char c : std::to_string(block)) name += digits.at(static_cast<std::size_t>(c - '0'));
  return name;
}

double panel_height(int blocks) {
  return std::clamp(780.0 / blocks, 110.0, 420.0);
}

std::size_t bins_for(std::size_t curves) {
  constexpr std::size_t points = 10000, most = 500, fewest = 30;
  return std::clamp(points / (2 * std::max<std::size_t>(curves, 1)), fewest, most);
}

}  // namespace rockstack::plots
