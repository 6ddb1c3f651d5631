#include "analytic/scene/named.hpp"

#include <optional>
#include <stdexcept>
#include <string>

namespace rockstack {
namespace {

/// One of the first `size` values of an enumeration.
template <class Enumeration>
Enumeration named(std::string_view text, int size) {
  for (int i = 0; i < size; ++i)
    if (name(static_cast<Enumeration>(i)) == text) return static_cast<Enumeration>(i);
  throw std::invalid_argument("\"" + std::string(text) + "\": must be a name that results have");
}

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

Pattern named_pattern(std::string_view text, int size) {
  if (size == 2)
    if (const std::optional<Pattern> pattern = paper_pattern(text)) return *pattern;
  if (const std::optional<Pattern> pattern = spelt_pattern(text, size)) return *pattern;
  throw std::invalid_argument("\"" + std::string(text) + "\": must be a pattern of " + std::to_string(size) +
                              " blocks");
}

EventKind named_event(std::string_view text) {
  return named<EventKind>(text, static_cast<int>(EventKind::part) + 1);
}

Consistency named_consistency(std::string_view text) {
  return named<Consistency>(text, static_cast<int>(Consistency::several) + 1);
}

}  // namespace rockstack
