#include "analytic/scene/pattern.hpp"

#include <optional>
#include <stdexcept>

namespace rockstack {
namespace {

/// Names for two blocks, in threes of the lower interface left, closed and right: the upper one left, closed,
/// right.
constexpr std::array<std::string_view, 9> paper_names{"1b", "4b", "2a", "3b", "rest", "3a", "2b", "4a", "1a"};

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

std::optional<Pattern> paper_pattern(std::string_view text) {
  const auto found = std::find(paper_names.begin(), paper_names.end(), text) - paper_names.begin();
  if (found == std::ssize(paper_names)) return {};
  Pattern pattern = closed_pattern(2);
  pattern[0] = contact_of(static_cast<int>(found % 3) - 1);
  pattern[1] = contact_of(static_cast<int>(found / 3) - 1);
  return pattern;
}

}  // namespace

std::string name(const Pattern& pattern) {
  std::string word;
  for (int k = 0; k < pattern.size; ++k) {
    word += "LCR-"[static_cast<int>(pattern[k]) + 1];
    const std::int8_t slide = pattern.slides[k];
    if (slide != 0) word += slide > 0 ? '>' : '<';
  }
  if (pattern.size != 2 || word.find_first_of("-<>") != std::string::npos) return word;
  const int number = 3 * sign(pattern[1]) + sign(pattern[0]) + 4;
  return std::string(paper_names[static_cast<std::size_t>(number)]);
}

std::string shown_pattern(const Pattern& pattern) {
  std::string text;
  for (const char letter : name(pattern))
    text += letter == '<' ? "←" : letter == '>' ? "→" : letter == '-' ? "–" : std::string(1, letter);
  return text;
}

std::string pattern_words(const Pattern& pattern) {
  std::string words;
  for (std::size_t k = 0; k < static_cast<std::size_t>(pattern.size); ++k) {
    const Contact contact = pattern.contacts[k];
    const auto way = [](int sign) { return std::string(sign < 0 ? "left" : "right"); };
    words += (k > 0 ? ", block " : "block ") + std::to_string(k + 1);
    words += contact == Contact::apart    ? " in flight"
             : contact == Contact::closed ? " flat"
                                          : " leaning " + way(sign(contact));
    if (pattern.slides[k] != 0) words += " and sliding " + way(pattern.slides[k]);
  }
  return words;
}

Pattern named_pattern(std::string_view text, int size) {
  if (size == 2)
    if (const std::optional<Pattern> pattern = paper_pattern(text)) return *pattern;
  if (const std::optional<Pattern> pattern = spelt_pattern(text, size)) return *pattern;
  throw std::invalid_argument("\"" + std::string(text) + "\": must be a pattern of " + std::to_string(size) +
                              " blocks");
}

}  // namespace rockstack
