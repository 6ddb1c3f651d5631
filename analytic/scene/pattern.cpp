#include "analytic/scene/pattern.hpp"

namespace rockstack {

Pattern closed_pattern(int size) {
  Pattern pattern;
  pattern.size = size;
  return pattern;
}

std::string name(const Pattern& pattern) {
  const bool pivots = std::all_of(pattern.contacts.begin(), pattern.contacts.begin() + pattern.size,
                                  [](Contact contact) { return contact != Contact::apart; }) &&
                      std::all_of(pattern.slides.begin(), pattern.slides.begin() + pattern.size,
                                  [](int slide) { return slide == 0; });
  if (pattern.size == 2 && pivots) {
    // Rows: upper interface left, closed, right; columns: lower interface left, closed, right.
    static constexpr std::array<std::array<const char*, 3>, 3> names{
        {{"1b", "4b", "2a"}, {"3b", "rest", "3a"}, {"2b", "4a", "1a"}}};
    const int row = sign(pattern[1]) + 1;
    const int column = sign(pattern[0]) + 1;
    return names[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  }
  std::string word;
  for (int k = 0; k < pattern.size; ++k) {
    word += "LCR-"[static_cast<int>(pattern[k]) + 1];
    const std::int8_t slide = pattern.slides[static_cast<std::size_t>(k)];
    if (slide != 0) word += slide > 0 ? '>' : '<';
  }
  return word;
}

}  // namespace rockstack
