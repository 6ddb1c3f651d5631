#include "engines/worker/last_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "analytic/scene/messages/one_line.hpp"

namespace rockstack {
namespace {

constexpr std::size_t longest_line = 4096;  ///< bytes of a line that are kept

/// "ValueError: …", "panic: …", "  what():  …"; not frames of calls, in Java and JavaScript from "at" on.
bool names_an_error(std::string lower) {
  for (char& letter : lower) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  if (lower.starts_with("at ")) return false;
  static constexpr std::array words{"error", "exception", "panic", "fatal", "what()"};
  return std::ranges::any_of(words, [&](const char* word) {
    const std::size_t found = lower.find(word);
    return found != std::string::npos && lower.find(':', found) != std::string::npos;
  });
}

void take_line(const std::string& text, std::string& last, std::string& error) {
  const std::string line(trimmed(text, " \t\r"));
  if (!line.empty()) last = line;
  if (names_an_error(line)) error = line;
}

}  // namespace

void LastWords::hear(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    line_.append(bytes.substr(0, std::min(end, longest_line - line_.size())));
    if (end == std::string_view::npos) return;
    take_line(line_, last_, error_);
    line_.clear();
    bytes.remove_prefix(end + 1);
  }
}

std::string LastWords::telling_line() const {
  std::string last = last_, error = error_;
  take_line(line_, last, error);
  return error.empty() ? last : error;
}

}  // namespace rockstack
