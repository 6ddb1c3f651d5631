#include "analytic/scene/ground/records/record_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

#include "analytic/scene/files/file_text.hpp"
#include "analytic/scene/ground/records/format.hpp"
#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {
namespace records {
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

/// Refuses a file that ends without a line end inside what may be the first part of a number: only where
/// numbers are lined up by their ends does its own end show that it is whole.
void check_last_line(std::string_view file, std::string_view text) {
  const bool open = ends_in_digit(text) || text.ends_with('.');
  const std::size_t start = text.rfind('\n') + 1;  // 0 in a file of one line
  const std::string_view last = text.substr(start);
  const bool numbers = last.find_first_not_of("0123456789+-.eEdD,; \t") == std::string_view::npos;
  if (!open || !numbers) return;
  const std::string_view before = start == 0 ? "" : text.substr(0, start - 1);
  const std::string_view above = before.substr(before.rfind('\n') + 1);
  const bool lined_up = last.starts_with(' ') || above.starts_with(' ');
  if (lined_up && ends_number(last, last.size()) && ends_number(above, last.size())) return;
  const auto line = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  Cursor(file, text).fail_at(line, "this line has no end: its last number may be cut short");
}

}  // namespace

std::vector<Record> read_series(std::string_view file, std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  check_waveform(Cursor(file, text), text);
  text = without_padding(text);
  const Cursor cursor(file, text);
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) cursor.fail("the file is empty");
  check_text(file, text);
  const std::array formats{&knet, &esm, &cosmos, &smc, &geonet, &volume2, &peer, &plain_columns};
  for (const Format* format : formats) {
    if (!format->recognises(cursor)) continue;
    std::vector<Record> series;
    for (Cursor rest = cursor; !rest.at_end();) format->read(rest, series);
    check_last_line(file, text);
    if (series.empty()) cursor.fail("holds no series of acceleration");
    return series;
  }
  cursor.fail("not a known format: must be " + std::string(known_formats));
}

}  // namespace records

namespace {

struct Place {
  std::filesystem::path file;
  std::size_t channel = 1;
};

/// Takes a channel's suffix off a name, unless a file has that very name.
Place place_of(const std::filesystem::path& name) {
  const std::string text = name.string();
  const std::size_t colon = text.rfind(':');
  std::error_code ignored;
  if (colon == std::string::npos || std::filesystem::exists(name, ignored)) return {name};
  std::size_t channel = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + colon + 1, end, channel);
  if (error != std::errc() || rest != end) return {name};
  return {text.substr(0, colon), channel};
}

}  // namespace

std::filesystem::path record_file(const std::filesystem::path& name) {
  return place_of(name).file;
}

Record read_record(const std::filesystem::path& name) {
  const Place place = place_of(name);
  std::vector<Record> series = records::read_series(place.file.string(), file_text(place.file));
  if (place.channel < 1 || place.channel > series.size())
    throw InputError(place.file.string() + ": no channel " + std::to_string(place.channel) +
                     ": must be 1 to " + std::to_string(series.size()));
  return std::move(series[place.channel - 1]);
}

}  // namespace rockstack
