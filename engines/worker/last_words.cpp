#include "engines/worker/last_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace rockstack {
namespace {

/// "ValueError: …", "Exception in thread "main" …: …", "panic: …", "  what():  …"; not the frames of calls,
/// which Java and JavaScript begin with "at".
bool names_an_error(std::string_view line) {
  std::string lower(line);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  if (lower.starts_with("at ")) return false;
  static constexpr std::array words{"error", "exception", "panic", "fatal", "what()"};
  return std::any_of(words.begin(), words.end(), [&](const char* word) {
    const std::size_t found = lower.find(word);
    return found != std::string::npos && lower.find(':', found) != std::string::npos;
  });
}

std::string_view trimmed(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
}

}  // namespace

std::string telling_line(std::string_view text) {
  std::string_view last;
  while (!text.empty()) {
    const std::size_t end = text.find_last_of('\n');
    const std::string_view line = trimmed(text.substr(end + 1));  // npos + 1 is 0
    if (names_an_error(line)) return std::string(line);
    if (last.empty()) last = line;
    text = end == std::string_view::npos ? std::string_view() : text.substr(0, end);
  }
  return std::string(last);
}

}  // namespace rockstack
