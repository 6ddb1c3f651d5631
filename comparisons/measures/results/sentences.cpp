#include "comparisons/measures/results/sentences.hpp"

#include <fmt/core.h>

namespace rockstack {

std::string counted(std::size_t count, const std::string& one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

std::string joined_up_to(std::size_t most, const std::vector<std::string>& words) {
  if (words.size() <= most + 1) return joined(words);
  std::vector<std::string> some(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(most));
  some.push_back(fmt::format("{} others", words.size() - most));
  return joined(some);
}

}  // namespace rockstack
