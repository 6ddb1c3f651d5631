#include "analytic/scene/ground/records/plain_text.hpp"

#include <algorithm>
#include <cstdint>

#include "analytic/scene/ground/records/text.hpp"

namespace rockstack::records {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Without the bytes that fill the last block of a file that comes from DOS: its ends of file, zeros.
std::string_view without_padding(std::string_view text) {
  const std::size_t last = text.find_last_not_of(std::string_view("\x1A\0\r\n", 4));
  const std::size_t end = text.find_first_not_of("\r\n", last + 1);  // npos + 1 is 0
  return text.substr(0, end);
}

/// Whether a file is MiniSEED: six digits, then the quality of the data and a blank; or version 3.
bool is_miniseed(std::string_view text) {
  constexpr std::size_t digits = 6, start = 8;
  if (text.starts_with("MS\x03")) return true;
  return text.size() > start && text.find_first_not_of("0123456789") == digits &&
         std::string_view("DRQM").find(text[digits]) != std::string_view::npos &&
         (text[digits + 1] == ' ' || text[digits + 1] == '\0');
}

/// Whether a file is binary SAC: 632 bytes of header, its version, 6 or 7, at byte 304 in either order.
bool is_sac(std::string_view text) {
  constexpr std::size_t header = 632, version = 304;
  if (text.size() < header) return false;
  const std::string_view word = text.substr(version, 4);
  const auto is_version = [](char c) { return c == 6 || c == 7; };
  const std::string_view zeros("\0\0\0", 3);
  return (is_version(word.front()) && word.ends_with(zeros)) ||
         (is_version(word.back()) && word.starts_with(zeros));
}

/// Refuses two binary formats that hold what a recorder counted, and not which acceleration that was.
void check_waveform(const Cursor& cursor, std::string_view text) {
  const bool miniseed = is_miniseed(text);
  if (!miniseed && !is_sac(text)) return;
  cursor.fail(std::string(miniseed ? "MiniSEED" : "SAC") +
              " has no unit of acceleration: must be converted to columns of numbers, after the instrument's "
              "response is taken off (in ObsPy remove_response(inventory, output=\"ACC\"))");
}

/// Refuses what is not text, at its first control character.
void check_text(std::string_view file, std::string_view text) {
  const auto is_binary = [](char c) {
    return (c >= 0 && c < ' ' && std::string_view("\t\n\v\f\r").find(c) == std::string_view::npos) ||
           c == '\x7F';
  };
  const auto bad = std::ranges::find_if(text, is_binary);
  if (bad == text.end()) return;
  const auto line = static_cast<std::size_t>(std::count(text.begin(), bad, '\n')) + 1;
  Cursor(file, text).fail_at(line, "byte " + std::to_string(static_cast<int>(*bad)) + ": not a text file");
}

bool ends_in_digit(std::string_view text) {
  return !text.empty() && text.back() >= '0' && text.back() <= '9';
}

/// Whether a number of this line ends before `column`.
bool ends_number(std::string_view line, std::size_t column) {
  if (line.size() < column || !ends_in_digit(line.substr(0, column))) return false;
  return line.size() == column || std::string_view(" -\r").find(line[column]) != std::string_view::npos;
}

/// How a line ends in digits: how many, and the sign before them. Only after a decimal point, or the sign of
/// an exponent, do they show that the number is whole.
struct Ending {
  std::size_t digits = 0;
  char sign = ' ';

  friend bool operator==(const Ending&, const Ending&) = default;
};

Ending ending_of(std::string_view line) {
  const std::string_view text = trimmed(line);
  const std::size_t sign = text.find_last_not_of("0123456789");
  if (sign == text.npos) return {};
  const bool exponent = sign > 0 && std::string_view("eEdD").find(text[sign - 1]) != text.npos;
  // A comma alone would part two counts of one length.
  const bool comma = text[sign] == ',' && (text.find_first_of(";\t") != text.npos || text.size() - sign > 3);
  const bool decimals = text[sign] == '.' || comma || exponent;
  return decimals ? Ending{text.size() - sign - 1, text[sign] == '-' ? '+' : text[sign]} : Ending{};
}

bool is_of_numbers(std::string_view line) {
  return !trimmed(line).empty() && line.find_first_not_of("0123456789+-.eEdD,;: \t\r") == line.npos;
}

/// Whether all lines of numbers of a text end alike.
bool end_alike(std::string_view text, std::string_view last) {
  const Ending ending = ending_of(last);
  std::size_t count = 0;
  for (Cursor cursor("", text); !cursor.at_end();) {
    const std::string_view line = cursor.next({});
    if (!is_of_numbers(line)) continue;
    if (ending_of(line) != ending) return false;
    ++count;
  }
  return ending.digits > 0 && count > 1;
}

void append_utf8(std::uint32_t code, std::string& text) {
  const auto part = [&](unsigned bits, std::uint32_t mark, std::uint32_t mask) {
    text += static_cast<char>(mark | ((code >> bits) & mask));
  };
  if (code < 0x80) return part(0, 0, 0x7f);
  if (code < 0x800) {
    part(6, 0xc0, 0x1f);
  } else {
    part(12, 0xe0, 0x0f);
    part(6, 0x80, 0x3f);
  }
  part(0, 0x80, 0x3f);
}

/// Converts the basic plane; what is beyond it has no place in a record.
std::string from_utf16(std::string_view bytes, bool high_first) {
  std::string text;
  for (std::size_t k = 0; k + 1 < bytes.size(); k += 2) {
    const auto one = static_cast<unsigned char>(bytes[k]), two = static_cast<unsigned char>(bytes[k + 1]);
    append_utf8(high_first ? one * 256U + two : two * 256U + one, text);
  }
  return text;
}

bool is_utf8(std::string_view text) {
  std::size_t left = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((left > 0) != ((byte & 0xc0U) == 0x80)) return false;
    left = left > 0 ? left - 1 : byte >= 0xf0 ? 3 : byte >= 0xe0 ? 2 : byte >= 0xc0 ? 1 : 0;
  }
  return left == 0;
}

std::string to_utf8(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) return from_utf16(bytes.substr(2), false);
  if (bytes.starts_with("\xFE\xFF")) return from_utf16(bytes.substr(2), true);
  if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
  if (is_utf8(bytes)) return std::string(bytes);
  std::string text;
  for (const char c : bytes) append_utf8(static_cast<unsigned char>(c), text);
  return text;
}

}  // namespace

std::string plain_text(std::string_view file, std::string_view bytes) {
  check_waveform(Cursor(file, bytes), bytes);
  std::string text = to_utf8(bytes);
  text.resize(without_padding(text).size());
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) Cursor(file, text).fail("the file is empty");
  check_text(file, text);
  if (text.find('\n') == std::string::npos) std::ranges::replace(text, '\r', '\n');
  return text;
}

void check_last_line(std::string_view file, std::string_view text) {
  const bool open = ends_in_digit(text) || text.ends_with('.');
  const std::size_t start = text.rfind('\n') + 1;  // 0 in a file of one line
  const std::string_view last = text.substr(start);
  if (!open || !is_of_numbers(last)) return;
  const std::string_view before = start == 0 ? "" : text.substr(0, start - 1);
  const std::string_view above = before.substr(before.rfind('\n') + 1);
  const bool lined_up = last.starts_with(' ') || above.starts_with(' ');
  if (lined_up && ends_number(last, last.size()) && ends_number(above, last.size())) return;
  if (end_alike(text, last)) return;
  const auto line = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  Cursor(file, text).fail_at(line, "this line has no end: its last number may be cut short; add a line end");
}

}  // namespace rockstack::records
