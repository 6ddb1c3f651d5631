#include "analytic/scene/messages/one_line.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace rockstack {
namespace {

/// The letter that a text begins with; of no bytes where they are no UTF-8 (Unicode 15, table 3-7).
struct Letter {
  std::size_t bytes = 0;
  std::uint32_t code = 0;
};

Letter first_letter(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return {1, byte(0)};
  const std::size_t bytes = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
  if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < bytes) return {};
  std::uint32_t code = byte(0) & (0x7fU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return {};
    code = (code << 6U) | (byte(i) & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  return code < least[bytes] || code > 0x10ffff || surrogate ? Letter{} : Letter{bytes, code};
}

/// Control characters, ends of lines and paragraphs, and marks of direction.
bool is_shown(std::uint32_t code) {
  constexpr std::array<std::array<std::uint32_t, 2>, 5> hidden{
      {{0, 0x1f}, {0x7f, 0x9f}, {0x200e, 0x200f}, {0x2028, 0x202e}, {0x2066, 0x2069}}};
  return !std::ranges::any_of(hidden, [&](auto& span) { return code >= span[0] && code <= span[1]; });
}

}  // namespace

std::string one_line(std::string_view text, std::size_t most) {
  std::string line;
  std::size_t letters = 0, kept = 0;  // bytes of the line that leave room for "…"
  while (!text.empty()) {
    const Letter letter = first_letter(text);
    const std::string_view bytes = text.substr(0, std::max<std::size_t>(letter.bytes, 1));
    const bool shown = letter.bytes > 0 && is_shown(letter.code);
    letters += shown ? 1 : 4 * bytes.size();
    if (letters > most) return line.substr(0, kept) + "…";
    if (shown)
      line += bytes;
    else
      for (const char byte : bytes) line += "\\x" + hex_digits(byte);
    if (letters < most) kept = line.size();
    text.remove_prefix(bytes.size());
  }
  return line;
}

std::string_view trimmed(std::string_view text, std::string_view blanks) {
  const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
  return text.substr(first, text.find_last_not_of(blanks) + 1 - first);  // npos + 1 is 0
}

std::string hex_digits(char byte) {
  static constexpr std::string_view digits = "0123456789abcdef";
  const auto code = static_cast<unsigned char>(byte);
  return {digits[code / 16], digits[code % 16]};
}

}  // namespace rockstack
