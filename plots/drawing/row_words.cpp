#include "plots/drawing/row_words.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "plots/drawing/layout.hpp"

namespace rockstack::plots {
namespace {

constexpr double letter = 0.0070;  // width of one, a share of the figure's
constexpr double margin = 0.025;
constexpr double widest = 0.6;  // that words may take

/// Words in as many lines as they need, each but the first beginning after a comma or at a plus.
std::vector<std::string> row_lines(const std::string& words) {
  const auto most = static_cast<std::size_t>((widest - margin) / letter);
  std::vector<std::string> lines;
  std::size_t start = 0;
  while (words.size() - start > most) {
    std::size_t end = start + most;
    while (end > start && words[end] != '+' && words[end - 1] != ',') --end;
    if (end == start) end = start + most;
    lines.push_back(words.substr(start, end - start));
    start = end;
  }
  lines.push_back(words.substr(start));
  return lines;
}

}  // namespace

RowWords row_words(const std::vector<std::string>& rows) {
  RowWords result{"", "", left_edge, 1};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<std::string> lines = row_lines(rows[i]);
    result.lines = std::max(result.lines, lines.size());
    result.tics += i > 0 ? ", " : "";
    for (std::size_t j = 0; j < lines.size(); ++j) {
      result.tics += fmt::format("{}{}", j > 0 ? R"(."\n".)" : "", in_quotes(lines[j]));
      result.left = std::max(result.left, letter * static_cast<double>(lines[j].size()) + margin);
    }
    result.tics += fmt::format(" {}", i);
    result.blank += fmt::format("{}'' {}", i > 0 ? ", " : "", i);
  }
  for (std::string* tics : {&result.tics, &result.blank})
    *tics = fmt::format("set ytics ({}) noenhanced font ',11'\n", *tics);
  return result;
}

double row_height(const RowWords& words) {
  return 10 + 16 * static_cast<double>(words.lines);
}

}  // namespace rockstack::plots
