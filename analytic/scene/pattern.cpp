#include "analytic/scene/pattern.hpp"

#include <optional>
#include <stdexcept>

namespace rockstack {
namespace {

/// A pattern by its letters.
std::optional<Pattern> spelt_pattern(std::string_view text, int size) {
  constexpr std::string_view letters = "LCR-";  // in the order of Contact, from −1 on
  Pattern pattern;
  for (const char letter : text) {
    const std::size_t place = letters.find(letter);
    if (place == std::string_view::npos) {
      if (pattern.size == 0 || (letter != '<' && letter != '>')) return {};
      pattern.slides[static_cast<std::size_t>(pattern.size) - 1] = letter == '>' ? 1 : -1;
    } else if (pattern.size == size) {
      return {};
    } else {
      pattern[pattern.size++] = static_cast<Contact>(static_cast<int>(place) - 1);
    }
  }
  return pattern.size == size ? std::optional(pattern) : std::nullopt;
}

/// A pattern of two blocks by the paper's name.
std::optional<Pattern> paper_pattern(std::string_view text) {
  Pattern pattern = closed_pattern(2);
  for (const int lower : {-1, 0, 1})
    for (const int upper : {-1, 0, 1}) {
      pattern[0] = contact_of(lower);
      pattern[1] = contact_of(upper);
      if (name(pattern) == text) return pattern;
    }
  return {};
}

}  // namespace

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
    return names[row][column];
  }
  std::string word;
  for (int k = 0; k < pattern.size; ++k) {
    word += "LCR-"[static_cast<int>(pattern[k]) + 1];
    const std::int8_t slide = pattern.slides[k];
    if (slide != 0) word += slide > 0 ? '>' : '<';
  }
  return word;
}

std::string shown_pattern(const Pattern& pattern) {
  std::string text;
  for (const char letter : name(pattern))
    text += letter == '<' ? "←" : letter == '>' ? "→" : letter == '-' ? "–" : std::string(1, letter);
  return text;
}

Pattern named_pattern(std::string_view text, int size) {
  if (size == 2)
    if (const std::optional<Pattern> pattern = paper_pattern(text)) return *pattern;
  if (const std::optional<Pattern> pattern = spelt_pattern(text, size)) return *pattern;
  throw std::invalid_argument("\"" + std::string(text) + "\": must be a pattern of " + std::to_string(size) +
                              " blocks");
}

}  // namespace rockstack
