#include "plots/drawing/words.hpp"

#include <algorithm>
#include <cmath>

namespace rockstack::plots {

std::vector<std::string> lines_of(const std::string& words, std::size_t most) {
  std::vector<std::string> lines;
  std::size_t start = 0;
  while (words.size() - start > most) {
    std::size_t end = start + most;
    while (end > start && words[end] != '+' && words[end - 1] != ',' && words[end - 1] != ' ' &&
           words[end - 1] != '-')
      --end;
    if (end == start) end = start + most;
    while (end > start + 1 && (static_cast<unsigned char>(words[end]) & 0xC0U) == 0x80U) --end;
    lines.push_back(words.substr(start, end - start));
    if (lines.back().ends_with(' ')) lines.back().pop_back();
    start = end;
  }
  lines.push_back(words.substr(start));
  return lines;
}

int words_size(const std::string& words, std::size_t usual, std::size_t fitting) {
  return static_cast<int>(usual * fitting / std::max(words.size(), fitting));
}

std::size_t next_break(const std::string& words, std::size_t from) {
  for (std::size_t at = from + 1; at < words.size(); ++at)
    if (words.compare(at - 1, 2, ", ") == 0)
      return at + 1;
    else if (words[at] == '+' && words[at - 1] != ' ')
      return at;
  return words.size();
}

std::string legible(const std::string& commands, double least) {
  static const std::string before = "font ',";
  std::string text;
  std::size_t from = 0;
  for (std::size_t at = 0; (at = commands.find(before, from)) != std::string::npos;) {
    at += before.size();
    const std::size_t end = commands.find('\'', at);
    const double size = std::stod(commands.substr(at, end - at));
    text += commands.substr(from, at - from);
    text += size < least ? std::to_string(static_cast<int>(std::ceil(least))) : commands.substr(at, end - at);
    from = end;
  }
  return text + commands.substr(from);
}

}  // namespace rockstack::plots
