#include "analytic/scene/ground/records/table.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "analytic/scene/ground/records/dialect.hpp"

namespace rockstack::records {
namespace {

bool is_date(std::string_view cell) {
  return cell.size() >= 8 && is_digit(cell.front()) && is_digit(cell.back()) &&
         cell.find_first_not_of("0123456789-/.") == cell.npos &&
         (std::count(cell.begin(), cell.end(), '-') == 2 || std::count(cell.begin(), cell.end(), '/') == 2 ||
          std::count(cell.begin(), cell.end(), '.') == 2);
}

/// A cell that is made as a number is, right or wrong.
bool is_number(std::string_view cell) {
  const std::string plain = lower(cell);
  return is_numeric(cell) && !is_date(cell) &&
         (plain.find_first_not_of("0123456789+-.,ed") == plain.npos || plain.ends_with("nan") ||
          plain.ends_with("inf") || plain.ends_with("infinity"));
}

/// A row has numbers; beside them it may have times and empty cells.
bool is_row(std::string_view line, const Dialect& dialect) {
  const Cells cells = split(line, dialect);
  return std::ranges::any_of(cells, is_number) && std::ranges::all_of(cells, [](std::string_view cell) {
           return cell.empty() || is_number(cell) || is_clock(cell) || is_date(cell);
         });
}

std::vector<Line> lines_of(std::string_view file, std::string_view text) {
  std::vector<Line> lines;
  for (Cursor cursor(file, text); !cursor.at_end();) {
    const std::string_view line = cursor.next({});
    if (!trimmed(line).empty()) lines.push_back({cursor.line_number(), line});
  }
  return lines;
}

/// Whether a line below the first row is of text: "*** End Data ***" is, numbers that overflowed are not.
bool is_text(std::string_view line) {
  const Cells fields = words(line, ",;\"");
  if (fields.empty() || is_numeric(fields.front())) return false;
  return fields.front().find_first_not_of('*') != line.npos || (fields.size() > 1 && contains(line, "end"));
}

/// A time of day, and the day where it has one: "2014-08-24T10:20:44.025".
struct Clock {
  double seconds = 0;
  std::optional<std::chrono::sys_days> day = {};
};

Clock read_clock(const Cursor& cursor, std::string_view cell) {
  const std::size_t start = cell.substr(0, cell.find(':')).find_last_of("T ") + 1;  // 0 without a date
  const auto parts = words(cell.substr(start), ":Z");
  if (parts.size() != 3) cursor.fail(in_quotes(cell) + " is no time of day");
  Clock clock{3600 * number(cursor, parts[0]) + 60 * number(cursor, parts[1]) + number(cursor, parts[2])};
  const auto date = words(cell.substr(0, start), "-/T");
  if (date.size() != 3 || date[0].size() != 4) return clock;
  const auto part = [&](std::size_t k) {
    return static_cast<int>(count(cursor, date[k].substr(date[k].find_first_not_of('0'))));
  };
  const std::chrono::year_month_day day{std::chrono::year(part(0)),
                                        std::chrono::month(static_cast<unsigned>(part(1))),
                                        std::chrono::day(static_cast<unsigned>(part(2)))};
  if (!day.ok()) cursor.fail(in_quotes(cell) + " has no day of the calendar");
  clock.day = std::chrono::sys_days(day);
  return clock;
}

/// Seconds since the beginning of the day of the first time.
double seconds_since(const Clock& first, const Clock& clock) {
  constexpr double day = 86400;
  return clock.seconds +
         (first.day && clock.day ? day * static_cast<double>((*clock.day - *first.day).count()) : 0);
}

/// Takes off an empty last column, of separators at the ends of lines.
void drop_empty_column(RecordTable& table) {
  const auto has_end = [](const Cells& row) { return row.size() > 1 && row.back().empty(); };
  if (!std::ranges::all_of(table.rows, has_end)) return;
  for (Cells& row : table.rows) row.pop_back();
}

bool has_columns(const RecordTable& table, const std::vector<std::string>& names) {
  return std::ranges::all_of(names, [&](const std::string& name) {
    return std::ranges::any_of(table.titles,
                               [&](const Title& title) { return name == title.text || name == title.name; });
  });
}

std::optional<RecordTable> read_below_names(std::string_view file, std::string_view text,
                                            const std::vector<std::string>& names) {
  const std::vector<Line> lines = lines_of(file, text);
  for (auto line = lines.begin(); line != lines.end(); ++line) {
    for (const char separator : {';', '\t', ','}) {
      RecordTable table{.cursor = Cursor(file, text), .dialect = {separator, separator != ','}};
      for (const std::string_view cell : split(line->text, table.dialect))
        table.titles.push_back(read_title(cell));
      if (!has_columns(table, names)) continue;
      table.title_line = line->number;
      table.header.assign(lines.begin(), line);
      for (auto row = line + 1; row != lines.end(); ++row) {
        table.rows.push_back(split(row->text, table.dialect));
        table.lines.push_back(row->number);
      }
      return table.rows.empty() ? std::nullopt : std::optional(std::move(table));
    }
  }
  return std::nullopt;
}

}  // namespace

bool is_numeric(std::string_view word) {
  if (word.empty()) return false;
  const std::string text = lower(word);
  return is_digit(text.front()) || (text.find_first_of("+-.,") == 0 && text.size() > 1) || text == "nan" ||
         text == "inf" || text == "infinity";
}

double RecordTable::number_at(std::size_t row, std::size_t index) const {
  const Cursor place = cursor.at_line(lines[row]);
  const std::string_view cell = rows[row][index];
  if (is_clock(cell))
    return seconds_since(read_clock(cursor.at_line(lines[0]), rows[0][index]), read_clock(place, cell));
  if (!dialect.decimal_comma) return number(place, cell);
  std::string text(cell);
  std::ranges::replace(text, ',', '.');
  return number(place, text);
}

std::vector<double> RecordTable::column(std::size_t index, bool may_be_empty) const {
  std::vector<double> values;
  values.reserve(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows[k].size() <= index) break;
    const bool empty = may_be_empty && rows[k][index].empty();
    values.push_back(empty ? std::numeric_limits<double>::quiet_NaN() : number_at(k, index));
  }
  return values;
}

void RecordTable::check_even(bool but_last) const {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bool short_last = but_last && k + 1 == rows.size() && rows[k].size() < columns();
    if (rows[k].size() != columns() && !short_last)
      cursor.fail_at(lines[k], std::to_string(rows[k].size()) + " columns where lines before have " +
                                   std::to_string(columns()));
  }
}

std::string RecordTable::column_name(std::size_t index) const {
  const std::string name = "column " + std::to_string(index + 1);
  return titles.empty() || titles[index].text.empty() ? name : name + ", \"" + titles[index].text + "\"";
}

RecordTable read_rows(std::string_view file, std::string_view text) {
  const std::vector<Line> lines = lines_of(file, text);
  RecordTable table{Cursor(file, text)};
  table.dialect = dialect_of(lines);
  for (const Line& line : lines) {
    if (table.rows.empty() ? !is_row(line.text, table.dialect) : is_text(line.text)) {
      table.header.push_back(line);
      continue;
    }
    table.rows.push_back(split(line.text, table.dialect));
    table.lines.push_back(line.number);
  }
  if (!table.rows.empty()) drop_empty_column(table);
  return table;
}

RecordTable read_titled(std::string_view file, std::string_view text, const std::vector<std::string>& names) {
  RecordTable table = read_rows(file, text);
  if (!table.rows.empty()) {
    find_titles(table);
    if (has_columns(table, names)) return table;
  }
  if (std::optional<RecordTable> named = read_below_names(file, text, names)) return *std::move(named);
  if (table.rows.empty()) table.cursor.fail("no line of numbers");
  return table;
}

}  // namespace rockstack::records
