#include <algorithm>
#include <cmath>
#include <functional>

#include "analytic/scene/ground/records/format.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack::records {
namespace {

constexpr double step_tolerance = 0.01;

/// A word that stands where a number belongs, right or wrong.
bool is_numeric(std::string_view word) {
  const std::string text = lower(word);
  return (text.front() >= '0' && text.front() <= '9') || text.find_first_of("+-.") == 0 || text == "nan" ||
         text == "inf" || text == "infinity";
}

bool is_header(std::string_view line) {
  const auto fields = words(line);
  if (fields.empty() || is_numeric(fields.front())) return false;
  const char first = lower(fields.front()).front();
  return (first >= 'a' && first <= 'z') || std::string_view("#%!;*/\"").find(first) != std::string_view::npos;
}

/// Whether the lines up to the first with a number are all header.
bool recognises(Cursor cursor) {
  while (!cursor.at_end() && (trimmed(cursor.peek()).empty() || is_header(cursor.peek()))) cursor.next({});
  const auto fields = words(cursor.peek());
  return !fields.empty() && is_numeric(fields.front());
}

/// How many columns a line of the header may name: its words, where no number or unit is among them; else 0.
std::size_t names_in(std::string_view line) {
  const bool comment = std::string_view("#%!*/").find(trimmed(line).front()) != std::string_view::npos;
  const bool numbers = line.find_first_of("0123456789") != std::string_view::npos;
  return comment || numbers || find_unit(line) ? 0 : words(line, ",;").size();
}

struct Header {
  HeaderUnit unit;
  std::optional<double> interval;
  std::size_t names = 0;  ///< of columns, in the last line; 0: none
  std::size_t count = 0;  ///< of values, where a line "NPTS dt" says it; else 0
  std::size_t count_line = 0;
};

/// A line without what stands in round brackets, such as "(sec)" after a name.
std::string without_brackets(std::string_view line) {
  std::string text;
  int depth = 0;
  for (const char c : line) {
    depth += c == '(' ? 1 : 0;
    if (depth == 0) text += c;
    depth -= c == ')' && depth > 0 ? 1 : 0;
  }
  return text;
}

void note_interval(const Cursor& cursor, double interval, Header& header) {
  if (header.interval && *header.interval != interval)
    cursor.fail("names another time step than a line before");
  header.interval = interval;
}

void read_header(const Cursor& cursor, std::string_view line, Header& header) {
  header.unit.read(cursor, line);
  header.names = names_in(line);
  if (contains(line, "(ms)") || contains(line, "[ms]")) cursor.fail("times in ms: must be in s");
  const std::string plain = without_brackets(line);
  for (const std::string_view name :
       {"dt", "time step", "timestep", "interval", "samplerate", "sample rate", "sampling rate"}) {
    const auto field = field_after(plain, name);
    if (field.empty() || !is_numeric(field)) continue;
    const double interval = name.starts_with("sampl") ? checked_interval(cursor, 1 / number(cursor, field))
                                                      : read_interval(cursor, plain, field);
    note_interval(cursor, interval, header);
  }
}

struct Table {
  std::vector<std::vector<double>> rows;
  std::vector<std::size_t> lines;

  std::size_t columns() const { return rows.front().size(); }
  std::vector<double> column(std::size_t index) const {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const auto& row : rows) values.push_back(row[index]);
    return values;
  }
};

/// The numbers of a line. Where semicolons part them, commas are decimal points.
std::vector<double> numbers_in(const Cursor& cursor, std::string_view line) {
  const bool semicolons = line.find(';') != std::string_view::npos;
  std::vector<double> values;
  for (const std::string_view field : words(line, semicolons ? ";" : ",")) {
    std::string text(field);
    if (semicolons) std::replace(text.begin(), text.end(), ',', '.');
    values.push_back(number(cursor, text));
  }
  return values;
}

[[noreturn]] void fail_uneven(const Cursor& cursor, const Table& table) {
  cursor.fail_at(table.lines.back(), std::to_string(table.rows.back().size()) +
                                         " columns where lines before have " +
                                         std::to_string(table.columns()));
}

/// Rows are of one length, but for the last of a series that goes on from line to line.
void read_row(const Cursor& cursor, std::string_view line, Table& table) {
  const auto fields = words(line, ",;");
  if (table.rows.empty() && !std::all_of(fields.begin(), fields.end(), is_numeric))
    cursor.fail("not a known format: must be " + std::string(known_formats));
  if (!table.rows.empty() && table.rows.back().size() < table.columns()) fail_uneven(cursor, table);
  table.rows.push_back(numbers_in(cursor, line));
  table.lines.push_back(cursor.line_number());
  if (table.rows.back().size() > table.columns()) fail_uneven(cursor, table);
}

/// The mean step, which all others must equal.
double constant_step(const Cursor& cursor, const Table& table) {
  const std::vector<double> times = table.column(0);
  if (times.size() < 2) cursor.fail("one time alone gives no time step");
  const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  checked_interval(cursor, step);
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double expected = times.front() + static_cast<double>(k) * step;
    if (std::abs(times[k] - expected) > step_tolerance * step)
      cursor.fail_at(table.lines[k], "time " + number_text(times[k]) + " where a constant step gives " +
                                         number_text(expected));
  }
  return step;
}

/// Of two columns the first is time; of more where it rises from row to row, which a series of acceleration
/// that goes on from line to line does not.
bool has_times(const Table& table) {
  if (table.columns() < 3) return table.columns() == 2;
  const std::vector<double> first = table.column(0);
  return first.size() > 2 && std::is_sorted(first.begin(), first.end(), std::less_equal<>());
}

/// What columns hold without times: a component each, or a series from line to line.
std::vector<std::vector<double>> series_of(const Cursor& cursor, const Table& table, bool times,
                                           bool one_each) {
  std::vector<std::vector<double>> series;
  for (std::size_t k = times ? 1 : 0; one_each && k < table.columns(); ++k) series.push_back(table.column(k));
  if (one_each) return series;
  constexpr std::size_t most_components = 4;
  if (table.columns() <= most_components)
    cursor.fail_at(table.lines.front(),
                   std::to_string(table.columns()) +
                       " columns, none of them times: where each is a component, a line of names must stand "
                       "above them");
  series.emplace_back();
  for (const auto& row : table.rows) series.front().insert(series.front().end(), row.begin(), row.end());
  return series;
}

/// Takes a line "NPTS dt" off the front of the rows: a count and a step, before rows of another length.
void take_count(const Cursor& cursor, Header& header, Table& table) {
  constexpr double longest = 1;  // step, s
  const std::vector<double>& first = table.rows.front();
  const bool whole = first.size() == 2 && first[0] >= 2 && first[0] == std::floor(first[0]);
  if (!whole || !(first[1] > 0) || first[1] > longest) return;
  header.count = static_cast<std::size_t>(first[0]);
  header.count_line = table.lines.front();
  note_interval(cursor, first[1], header);
  table.rows.erase(table.rows.begin());
  table.lines.erase(table.lines.begin());
}

/// A record of what its unit says, differentiated as often as that takes.
Record accelerogram(const Cursor& cursor, Record record, int derivatives) {
  if (derivatives == 0) return record;
  if (record.samples.size() < 2)
    cursor.fail("one sample of a velocity or displacement gives no acceleration");
  const bool velocity = derivatives == 1;
  Record motion = velocity ? acceleration_of_velocity(record.interval, record.samples)
                           : acceleration_of_displacement(record.interval, record.samples);
  motion.format = record.format + (velocity ? " of velocity" : " of displacement");
  return motion;
}

void read(Cursor& cursor, std::vector<Record>& records) {
  Header header;
  Table table;
  while (!cursor.at_end()) {
    const std::string_view line = cursor.next({});
    if (trimmed(line).empty()) continue;
    if (is_header(line)) {
      read_header(cursor, line, header);
    } else {
      if (table.rows.size() == 1 && words(line, ",;").size() != table.columns())
        take_count(cursor, header, table);
      read_row(cursor, line, table);
    }
  }
  const Unit unit = header.unit.unit(cursor);
  const bool times = has_times(table);
  if (!times && !header.interval)
    cursor.fail_at(table.lines.front(),
                   (table.columns() == 1 ? "one column" : std::to_string(table.columns()) + " columns") +
                       std::string(", and no time step in the header: say e.g. \"# dt = 0.01\" (s)"));
  const bool one_each = times || table.columns() == 1 || header.names == table.columns();
  if (one_each && table.rows.back().size() < table.columns()) fail_uneven(cursor, table);
  const double step = times ? constant_step(cursor, table) : *header.interval;
  if (header.interval && std::abs(step - *header.interval) > step_tolerance * step)
    cursor.fail("times step by " + number_text(step) +
                " s, the header says dt = " + number_text(*header.interval));
  std::vector<std::vector<double>> series = series_of(cursor, table, times, one_each);
  if (header.count > 0) check_count(cursor, series.front().size(), header.count, header.count_line);
  for (auto& samples : series)
    records.push_back(accelerogram(cursor, make_record(step, std::move(samples), unit.factor, "text columns"),
                                   unit.derivatives));
}

}  // namespace

/// Plain text in columns, separated by blanks, commas or semicolons; beside semicolons a comma is a decimal
/// point. Lines that start with # % ! ; * / or a letter are header, which names the unit ("# units: m/s2", or
/// a column title such as "acceleration [g]"); a velocity or a displacement, as that of a shake table
/// ("units: mm"), is differentiated. Several columns are time (s) and a component each. Times must have a
/// constant step, up to 1 % of it where they are rounded; it is their mean step, and the record starts at its
/// first line whatever time that has. Without times the header, or a line "NPTS dt" above the numbers, names
/// the step ("# dt = 0.01", in s; also "time step", "interval", "sampling rate" in Hz); columns are then
/// components where a line of names stands above them, and else, five or more, one series that goes on from
/// line to line.
const Format plain_columns{recognises, read};

}  // namespace rockstack::records
