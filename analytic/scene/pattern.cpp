#include "analytic/scene/pattern.hpp"

namespace rockstack {

Pattern closed_pattern(int size) {
  Pattern pattern;
  pattern.size = size;
  return pattern;
}

std::string name(const Pattern& pattern) {
  if (pattern.size == 2) {
    // Rows: upper interface left, closed, right; columns: lower interface left, closed, right.
    static constexpr std::array<std::array<const char*, 3>, 3> names{
        {{"1b", "4b", "2a"}, {"3b", "rest", "3a"}, {"2b", "4a", "1a"}}};
    const int row = sign(pattern[1]) + 1;
    const int column = sign(pattern[0]) + 1;
    return names[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  }
  std::string word;
  for (int k = 0; k < pattern.size; ++k) word += "LCR"[sign(pattern[k]) + 1];
  return word;
}

}  // namespace rockstack
