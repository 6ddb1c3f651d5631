#include "comparisons/measures/results/shown_pattern.hpp"

namespace rockstack {

std::string shown_pattern(const Pattern& pattern) {
  std::string text;
  for (const char letter : name(pattern))
    text += letter == '<' ? "←" : letter == '>' ? "→" : letter == '-' ? "–" : std::string(1, letter);
  return text;
}

}  // namespace rockstack
