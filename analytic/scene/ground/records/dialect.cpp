#include "analytic/scene/ground/records/dialect.hpp"

#include <algorithm>
#include <limits>

#include "analytic/scene/ground/records/text.hpp"

namespace rockstack::records {
namespace {

std::string_view unquoted(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return cell;
  return trimmed(cell.substr(1, cell.size() - 2));
}

/// The pieces between separators that stand outside quotes.
Cells pieces(std::string_view line, char separator) {
  Cells cells;
  std::size_t start = 0;
  bool quoted = false;
  for (std::size_t k = 0; k <= line.size(); ++k) {
    if (k < line.size() && line[k] == '"') quoted = !quoted;
    if (k < line.size() && (quoted || line[k] != separator)) continue;
    cells.push_back(unquoted(line.substr(start, k - start)));
    start = k + 1;
  }
  return cells;
}

/// Takes the numbers of a word apart that Fortran's columns leave no blank between: "-.1E-03-.2E-03".
void split_run(std::string_view word, Cells& cells) {
  for (std::size_t k = 1; k < word.size(); ++k) {
    const std::string_view first = word.substr(0, k), rest = word.substr(k);
    const bool sign = (word[k] == '-' || word[k] == '+') && is_digit(word[k - 1]);
    if (!sign || first.find('.') == first.npos || rest.find('.') == rest.npos) continue;
    cells.push_back(first);
    return split_run(rest, cells);
  }
  cells.push_back(word);
}

/// What the lines of numbers of a file have among them.
struct Signs {
  bool semicolon = false, tab = false, comma = false, point = false, quoted_comma = false;
  bool blank = false;        ///< inside what commas or tabs part
  bool loose_comma = false;  ///< beside which there is no digit
};

bool has_blank_inside(std::string_view line, char separator) {
  return std::ranges::any_of(pieces(line, separator), [](std::string_view cell) {
    return !is_clock(cell) && cell.find_first_of(" \t") != cell.npos;
  });
}

void note_commas(std::string_view line, Signs& signs) {
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k] == '"') quoted = !quoted;
    if (line[k] != ',') continue;
    signs.comma = true;
    signs.quoted_comma = signs.quoted_comma || quoted;
    if (k + 1 >= line.size() || !is_digit(line[k + 1])) signs.loose_comma = true;
  }
}

bool is_line_of_numbers(std::string_view line) {
  line = trimmed(line);
  return line.find_first_of("0123456789") != line.npos &&
         line.find_first_not_of("0123456789+-.,;:/eEdDTZ \t\"") == line.npos;
}

/// Whether each line is a number with a decimal comma: digits after it of one length, a number before it that
/// does not count the lines.
bool is_one_decimal(const std::vector<Line>& lines) {
  std::size_t digits = 0;
  bool rising = true;
  double before = -std::numeric_limits<double>::infinity();
  for (const Line& line : lines) {
    const std::string_view text = trimmed(line.text);
    const std::size_t comma = text.find(',');
    if (comma == text.npos || text.find_first_not_of("0123456789", comma + 1) != text.npos) return false;
    const std::size_t after = text.size() - comma - 1;
    if (after < 2 || (digits != 0 && after != digits)) return false;
    digits = after;
    double whole = 0;
    for (const char c : text.substr(0, comma)) whole = is_digit(c) ? 10 * whole + (c - '0') : whole;
    if (text.starts_with('-')) whole = -whole;
    rising = rising && whole > before;
    before = whole;
  }
  return digits > 0 && !rising;
}

}  // namespace

Cells split(std::string_view line, const Dialect& dialect) {
  if (dialect.separator != ' ') return pieces(line, dialect.separator);
  Cells cells;
  for (const std::string_view word : words(line, dialect.decimal_comma ? "\"" : ",\""))
    split_run(word, cells);
  return cells;
}

bool is_clock(std::string_view cell) {
  return std::count(cell.begin(), cell.end(), ':') == 2 && is_digit(cell.front()) && cell.find(':') > 0 &&
         cell.find_first_not_of("0123456789:.,-/TZ ") == cell.npos;
}

Dialect dialect_of(const std::vector<Line>& lines) {
  Signs signs;
  std::vector<Line> numbers;
  std::ranges::copy_if(lines, std::back_inserter(numbers),
                       [](const Line& line) { return is_line_of_numbers(line.text); });
  for (const Line& line : numbers) {
    signs.semicolon = signs.semicolon || line.text.find(';') != line.text.npos;
    signs.tab = signs.tab || trimmed(line.text).find('\t') != line.text.npos;
    signs.point = signs.point || line.text.find('.') != line.text.npos;
    note_commas(line.text, signs);
  }
  if (signs.semicolon) return {';', true};
  const bool decimals = signs.comma && !signs.point && !signs.loose_comma;
  const auto blank_in = [&](char separator) {
    return std::ranges::any_of(
        numbers, [&](const Line& line) { return has_blank_inside(trimmed(line.text), separator); });
  };
  if (signs.tab && !blank_in('\t') && (decimals || !signs.comma)) return {'\t', decimals};
  if (signs.quoted_comma) return {',', true};
  if (!signs.comma) return {};
  if (!blank_in(',')) return is_one_decimal(numbers) && decimals ? Dialect{' ', true} : Dialect{',', false};
  return {' ', decimals};
}

}  // namespace rockstack::records
