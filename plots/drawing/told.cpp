#include "plots/drawing/told.hpp"

#include <fmt/core.h>

#include <boost/algorithm/string/predicate.hpp>
#include <regex>
#include <sstream>

#include "plots/drawing/style.hpp"

namespace rockstack::plots {
namespace {

using DataLines = std::vector<std::vector<double>>;

/// The text of gnuplot strings that are joined by points, from `at` on, which moves behind them.
std::string joined_strings(const std::string& text, std::size_t& at) {
  std::string words;
  while (at < text.size() && (text[at] == '\'' || text[at] == '"')) {
    const std::size_t end = text.find(text[at], at + 1);
    if (end == std::string::npos) break;
    const std::string part = text.substr(at + 1, end - at - 1);
    words += part == "\\n" ? "" : part;
    at = end + 1 + (end + 1 < text.size() && text[end + 1] == '.' ? 1 : 0);
  }
  return words;
}

/// The text behind the last of some commands; empty where there is none.
std::string words_behind(const std::string& settings, const std::string& command) {
  const std::size_t found = settings.rfind("\n" + command);
  if (found == std::string::npos) return "";
  std::size_t at = found + command.size() + 1;
  return joined_strings(settings, at);
}

/// What stands above a small panel, in one or more lines.
std::string words_above(const std::string& settings) {
  std::string words;
  std::istringstream lines(settings);
  for (std::string line; std::getline(lines, line);) {
    std::size_t at = std::string("set label ").size();
    if (line.starts_with("set label '") && line.find(" at graph 0, graph 1 left ") != std::string::npos)
      words += joined_strings(line, at);
  }
  return words;
}

/// The words of rows, by their numbers.
std::map<long, std::string> rows_of(const std::string& settings) {
  static const std::string command = "\nset ytics (";
  std::map<long, std::string> rows;
  std::size_t at = settings.rfind(command);
  if (at == std::string::npos) return rows;
  at += command.size();
  while (at < settings.size() && settings[at] == '\'') {
    const std::string words = joined_strings(settings, at);
    const double place = std::strtod(settings.c_str() + at, nullptr);
    if (place == std::round(place)) rows[std::lround(place)] = words;
    at = settings.find_first_of(",)", at);
    if (at == std::string::npos || settings[at] == ')') break;
    at += 2;
  }
  return rows;
}

DataLines numbers_of(const std::string& blocks, const std::string& name) {
  const std::string head = "$" + name + " << END\n";
  const std::size_t found = boost::starts_with(blocks, head) ? 0 : blocks.find("\n" + head);
  DataLines rows;
  if (found == std::string::npos) return rows;
  const std::size_t from = blocks.find('\n', found + 1) + 1;
  std::istringstream lines(blocks.substr(from, blocks.find("END\n", from) - from));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::vector<double> row;
    for (std::string word; words >> word;) row.push_back(std::strtod(word.c_str(), nullptr));
    if (row.size() > 1) rows.push_back(std::move(row));
  }
  return rows;
}

/// The part of a style that a pattern finds; empty without.
std::string part_of(const std::string& style, const std::regex& pattern) {
  std::smatch found;
  return std::regex_search(style, found, pattern) ? found[1].str() : "";
}

std::string colour_of(const std::string& style) {
  static const std::regex colour(R"((?:lc|fc|fillcolor) rgb '(#[0-9A-Fa-f]{6})')");
  return part_of(style, colour);
}

/// The legend's words of a style: of its colour, mark and dashes, or of as many of these as an entry has.
std::string legend_words(const std::string& style, const Legend& legend) {
  static const std::regex mark(R"(\bpt (\d+))"), dash(R"(\bdt (\S+))");
  std::string best;
  int most = 0;
  for (const auto& [entry, words] : legend) {
    if (colour_of(entry) != colour_of(style)) continue;
    const int score = 1 + 2 * static_cast<int>(part_of(entry, mark) == part_of(style, mark)) +
                      static_cast<int>(part_of(entry, dash) == part_of(style, dash));
    if (score > most) most = score, best = words;
  }
  return best;
}

/// The row that all points stand in; none where they stand in several.
std::string row_words(const DataLines& numbers, const std::map<long, std::string>& rows) {
  const auto row = rows.find(std::lround(numbers.front()[1]));
  const bool one = std::ranges::all_of(numbers, [&](const std::vector<double>& line) {
    return row != rows.end() && std::abs(line[1] - static_cast<double>(row->first)) < 0.5;
  });
  return one ? row->second : "";
}

bool is_known(const DataLines& numbers, const std::vector<DrawnPanel>& known) {
  constexpr double digits = 1e-5;
  const auto is_same = [&](const DrawnCurve& one) {
    if (one.curve.size() != numbers.size()) return false;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (std::abs(one.curve.times[i] - numbers[i][0]) > digits * std::abs(numbers[i][0]) ||
          std::abs(one.curve.values[i] - numbers[i][1]) > digits * std::abs(numbers[i][1]))
        return false;
    return true;
  };
  return std::ranges::any_of(
      known, [&](const DrawnPanel& panel) { return std::ranges::any_of(panel.curves, is_same); });
}

std::string further_words(const std::string& words, const std::string& style, std::size_t column) {
  const bool bounds = style.find("errorbars") != std::string::npos && column < 4;
  return words + (bounds ? (column == 2 ? ", lower bound" : ", upper bound")
                         : fmt::format(", column {}", column + 1));
}

}  // namespace

DrawnPanel told_of(const SidePanel& panel, const std::string& blocks, const Legend& legend,
                   const std::vector<DrawnPanel>& known) {
  const std::string settings = "\n" + panel.settings;
  DrawnPanel told{words_behind(settings, "set xlabel "), words_behind(settings, "set ylabel "),
                  settings.find("set logscale y") != std::string::npos};
  std::map<std::string, std::string> styles;  // of each block all of its elements
  std::vector<std::string> names;
  for (const std::string& plot : panel.plots)
    if (plot.starts_with('$') && colour_of(plot) != context_colour) {
      const std::string name = plot.substr(1, plot.find(' ') - 1);
      if (!styles.contains(name)) names.push_back(name);
      styles[name] += plot + " ";
    }
  const auto rows = told.logarithmic ? std::map<long, std::string>() : rows_of(settings);
  for (const std::string& name : names) {
    const DataLines numbers = numbers_of(blocks, name);
    const std::string& style = styles.at(name);
    if (numbers.empty() || is_known(numbers, known)) continue;
    const std::string colour = colour_of(style);
    std::string words = row_words(numbers, rows);
    if (words.empty()) words = words_above(settings);
    if (words.empty()) words = legend_words(style, legend);
    if (words.empty()) words = name;
    for (std::size_t column = 1; column < numbers.front().size(); ++column) {
      DrawnCurve curve{
          column == 1 ? words : further_words(words, style, column), colour.empty() ? "#000000" : colour, {}};
      for (const std::vector<double>& row : numbers)
        if (column < row.size()) curve.curve.add(row[0], row[column]);
      told.curves.push_back(std::move(curve));
    }
  }
  return told;
}

}  // namespace rockstack::plots
