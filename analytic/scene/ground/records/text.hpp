#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rockstack::records {

/// A place in the text of a record: hands out lines and knows where it is when something is wrong. Cheap to
/// copy; the name and the text must outlive it. Lines end in "\n" or "\r\n".
class Cursor {
 public:
  Cursor(std::string_view file, std::string_view text) : file_(file), rest_(text) {}

  bool at_end() const { return rest_.empty(); }
  /// The line that next() would give, empty at the end.
  std::string_view peek() const;
  /// @throws InputError at the end of the file: `expected` is missing.
  std::string_view next(std::string_view expected);
  void skip(std::size_t lines, std::string_view expected);
  void skip_blank();
  /// At the end, as the whole text.
  std::string_view take_rest();
  /// Number of the line that next() gave last, from 1.
  std::size_t line_number() const { return line_ == 0 ? 1 : line_; }

  /// @throws InputError "file:line: message" for the line that next() gave last.
  [[noreturn]] void fail(const std::string& message) const { fail_at(line_number(), message); }
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const;
  /// Cursor whose errors name another line.
  Cursor at_line(std::size_t line) const;

  std::string_view file() const { return file_; }

 private:
  std::string_view file_;
  std::string_view rest_;
  std::size_t line_ = 0;
};

/// Fixed columns as a Fortran format names them: (8F10.5) is eight a line, ten characters each.
struct Columns {
  std::size_t per_line = 0;  ///< > 0
  std::size_t width = 0;     ///< characters, > 0
};

/// A piece of the file for an error message: printable, in quotes, cut after 40 characters.
std::string in_quotes(std::string_view text);

inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string lower(std::string_view text);  ///< A–Z only, whatever the locale
std::string_view trimmed(std::string_view text);
/// Compares upper and lower case alike; so does the next.
inline bool contains(std::string_view text, std::string_view lower_case_part) {
  return lower(text).find(lower_case_part) != std::string::npos;
}

inline bool starts_with(std::string_view text, std::string_view lower_case_part) {
  return lower(text).starts_with(lower_case_part);
}

/// The pieces between blanks, tabs and any of `separators`.
std::vector<std::string_view> words(std::string_view text, std::string_view separators = ",");

/// The number that starts right after `key` (lower case, a whole word) and blanks, '=' or ':'; empty without
/// one. "NPTS=  4000, DT= .01 SEC" has 0.01 after "dt".
std::string_view field_after(std::string_view text, std::string_view key);

/// The whole field as a number, Fortran's spellings included (.5, +1, 1D3).
/// @throws InputError where it is none, or not finite, or of a magnitude no record has (1e100).
double number(const Cursor& cursor, std::string_view field);

/// The whole field as a count. @throws InputError where it is not an integer from 1 to 10⁹.
std::size_t count(const Cursor& cursor, std::string_view field);

/// A time step in s. @throws InputError unless it is > 0.
double checked_interval(const Cursor& cursor, double interval);

/// The columns of the Fortran format in the last brackets of a line. @throws InputError where there is none.
Columns fortran_columns(const Cursor& cursor, std::string_view line);

/// The next `count` values in fixed columns; a value equal to `null` stands for missing data.
/// @throws InputError at the line where a value is missing, surplus, null or not a number.
std::vector<double> read_columns(Cursor& cursor, std::size_t count, Columns columns,
                                 std::optional<double> null = std::nullopt);

/// All values up to the end of the file, separated by blanks or commas. `marked`: some copies end with "***
/// End Data ***"; overflown values are asterisks too, but alone.
std::vector<double> read_values(Cursor& cursor, bool marked = false);

/// @throws InputError at the last line unless as many values were found as `line` announces.
void check_count(const Cursor& cursor, std::size_t found, std::size_t announced, std::size_t line);

}  // namespace rockstack::records
