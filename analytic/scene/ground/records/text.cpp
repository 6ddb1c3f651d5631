#include "analytic/scene/ground/records/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "analytic/scene/messages/one_line.hpp"

namespace rockstack::records {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";
constexpr double largest = 1e100;

char lower_letter(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Whether a word of a text in lower case goes on at a place.
bool is_in_word(std::string_view text, std::size_t place) {
  const char c = place < text.size() ? text[place] : ' ';
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '_';
}

std::string_view without_first(std::string_view text, std::size_t length) {
  return text.substr(std::min(length, text.size()));
}

/// The digits at the front of a text, taken off it; 0 without any or with too many.
std::size_t take_digits(std::string_view& text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc() ? value : 0;
}

}  // namespace

std::string_view Cursor::peek() const {
  std::string_view line = rest_.substr(0, rest_.find('\n'));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view Cursor::next(std::string_view expected) {
  if (at_end()) fail("the file ends here, before " + std::string(expected));
  const std::string_view line = peek();
  const std::size_t end = rest_.find('\n');
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++line_;
  return line;
}

std::string_view Cursor::take_rest() {
  return std::exchange(rest_, {});
}

Cursor Cursor::at_line(std::size_t line) const {
  Cursor other = *this;
  other.line_ = line;
  return other;
}

void Cursor::skip(std::size_t lines, std::string_view expected) {
  for (; lines > 0; --lines) next(expected);
}

void Cursor::skip_blank() {
  while (!at_end() && trimmed(peek()).empty()) next({});
}

void Cursor::fail_at(std::size_t line, const std::string& message) const {
  throw InputError(std::string(file_) + ":" + std::to_string(line) + ": " + message);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::size_t end = std::min(text.size(), longest);
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80) --end;
  return "'" + one_line(text.substr(0, end)) + (text.size() > end ? "…'" : "'");
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = lower_letter(c);
  return result;
}

std::string_view trimmed(std::string_view text) {
  return rockstack::trimmed(text, blanks);
}

std::vector<std::string_view> words(std::string_view text, std::string_view separators) {
  const std::string cuts = std::string(blanks) + std::string(separators);
  std::vector<std::string_view> result;
  while (true) {
    const std::size_t first = text.find_first_not_of(cuts);
    if (first == std::string_view::npos) return result;
    text.remove_prefix(first);
    const std::size_t length = std::min(text.find_first_of(cuts), text.size());
    result.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
}

std::string_view field_after(std::string_view text, std::string_view key) {
  const std::string plain = lower(text);
  for (std::size_t from = plain.find(key); from != std::string::npos; from = plain.find(key, from + 1)) {
    const std::size_t end = from + key.size();
    if (is_in_word(plain, from - 1) || is_in_word(plain, end)) continue;  // before the first there is none
    const std::string_view field = without_first(text, text.find_first_not_of(" \t=:", end));
    return field.substr(0, field.find_first_of(" \t\r,;)"));
  }
  return {};
}

double number(const Cursor& cursor, std::string_view field) {
  std::string text(trimmed(field));
  for (const char exponent : {'D', 'd'}) std::ranges::replace(text, exponent, 'E');
  const std::size_t plus = text.starts_with('+') && !text.starts_with("+-") ? 1 : 0;
  const char* const end = text.data() + text.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data() + plus, end, value);
  if (error == std::errc::invalid_argument || rest != end)
    cursor.fail(in_quotes(trimmed(field)) + " is not a number");
  if (error != std::errc() || !(std::abs(value) < largest))
    cursor.fail(in_quotes(trimmed(field)) + " is not a finite number below 1e100");
  return value;
}

std::size_t count(const Cursor& cursor, std::string_view field) {
  constexpr std::size_t most = 1'000'000'000;
  std::string_view digits = trimmed(field);
  const std::size_t value = take_digits(digits);
  if (value == 0 || value > most || !digits.empty())
    cursor.fail(in_quotes(trimmed(field)) + " is not a count: must be an integer from 1 to 1000000000");
  return value;
}

double checked_interval(const Cursor& cursor, double interval) {
  if (!(interval > 0) || !(interval < largest))
    cursor.fail("time step is " + number_text(interval) + " s: must be > 0");
  return interval;
}

Columns fortran_columns(const Cursor& cursor, std::string_view line) {
  const std::size_t open = line.rfind('(');
  if (open == std::string_view::npos) cursor.fail("no Fortran format such as (8F10.5) in this line");
  const std::string_view format = line.substr(open, line.find(')', open) - open + 1);
  std::string_view rest = format.substr(1);
  Columns columns{take_digits(rest), 0};
  if (starts_with(rest, "p")) {
    rest = without_first(rest, rest.size() > 1 && rest[1] == ',' ? 2 : 1);
    columns.per_line = take_digits(rest);
  }
  const bool has_type =
      !rest.empty() && std::string_view("fegid").find(lower_letter(rest.front())) != std::string_view::npos;
  rest = without_first(rest, 1);
  columns.width = take_digits(rest);
  if (!has_type || columns.per_line == 0 || columns.width == 0)
    cursor.fail(in_quotes(format) + " is not a Fortran format of the kind (8F10.5)");
  return columns;
}

std::vector<double> read_columns(Cursor& cursor, std::size_t count, Columns columns,
                                 std::optional<double> null) {
  const std::size_t announced_in = cursor.line_number();
  std::vector<double> values;
  while (values.size() < count) {
    if (cursor.at_end()) check_count(cursor, values.size(), count, announced_in);
    std::string_view rest = cursor.next("values");
    for (std::size_t k = 0; k < columns.per_line && values.size() < count; ++k) {
      if (trimmed(rest).empty()) cursor.fail("this line has " + std::to_string(k) + " values, too few");
      values.push_back(number(cursor, rest.substr(0, columns.width)));
      if (null && values.back() == *null)
        cursor.fail(in_quotes(trimmed(rest.substr(0, columns.width))) + " marks missing data");
      rest = without_first(rest, columns.width);
    }
    if (!trimmed(rest).empty())
      cursor.fail("surplus " + in_quotes(trimmed(rest)) + " at the end of this line");
  }
  return values;
}

std::vector<double> read_values(Cursor& cursor, bool marked) {
  std::vector<double> values;
  while (!cursor.at_end()) {
    const std::string_view line = cursor.next({});
    if (marked && line.starts_with("***") && contains(line, "end")) continue;
    for (const std::string_view word : words(line)) values.push_back(number(cursor, word));
  }
  return values;
}

void check_count(const Cursor& cursor, std::size_t found, std::size_t announced, std::size_t line) {
  if (found == announced) return;
  cursor.fail("the file ends after " + std::to_string(found) + " values; line " + std::to_string(line) +
              " announces " + std::to_string(announced));
}

}  // namespace rockstack::records
