#include <algorithm>
#include <cmath>
#include <functional>

#include "analytic/scene/ground/records/format.hpp"
#include "analytic/scene/ground/records/header.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack::records {
namespace {

constexpr double step_tolerance = 0.01;

/// Whether a line begins with a number, or tells the number of values.
bool recognises(Cursor cursor) {
  while (!cursor.at_end()) {
    const std::string_view line = cursor.next({});
    const auto fields = words(line, ",;\"");
    if (contains(line, "npts") || std::ranges::any_of(fields, is_numeric)) return true;
  }
  return false;
}

bool rises(const std::vector<double>& values) {
  return std::is_sorted(values.begin(), values.end(), std::less_equal<>());
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

/// The mean step, which all others must equal. `times` in s.
double constant_step(const RecordTable& table, const std::vector<double>& times) {
  const Cursor& cursor = table.cursor;
  if (times.size() < 2) cursor.fail_at(table.lines.front(), "one time alone gives no time step");
  const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  checked_interval(cursor.at_line(table.lines.back()), step);
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double expected = times.front() + static_cast<double>(k) * step;
    if (std::abs(times[k] - expected) > step_tolerance * step)
      cursor.fail_at(table.lines[k], "time " + number_text(times[k]) + " where a constant step gives " +
                                         number_text(expected));
  }
  return step;
}

/// What a table holds: its time step, and columns that are a series each.
struct Content {
  double interval = 0;
  std::vector<std::size_t> columns;
  std::vector<Unit> units;  ///< of those
};

/// The step of the header, which times must agree with.
double interval_of(const RecordTable& table, const Header& header, const std::optional<std::size_t>& time) {
  if (!time) {
    if (header.interval) return *header.interval;
    const std::size_t columns = table.columns();
    table.cursor.fail_at(
        table.lines.front(),
        (columns == 1 ? "one column" : std::to_string(columns) + " columns, none of them times") +
            std::string(", and no time step in the header: say e.g. \"# dt = 0.01\" (s)"));
  }
  const bool titled = !table.titles.empty() && table.titles[*time].unit;
  const double step =
      constant_step(table, scaled(table.column(*time), titled ? table.titles[*time].unit->factor : 1));
  if (header.interval && std::abs(step - *header.interval) > step_tolerance * step)
    table.cursor.fail_at(header.interval_line, "dt = " + number_text(*header.interval) +
                                                   " s here, and times step by " + number_text(step) + " s");
  return step;
}

/// Whether the numbers of a column count rows, one by one.
bool counts(const std::vector<double>& values) {
  for (std::size_t k = 1; k < values.size(); ++k)
    if (values[k] != values[k - 1] + 1) return false;
  return true;
}

/// The column of times: the one whose title says so; else the first that no title says to be something else,
/// where it rises from row to row as no acceleration does.
std::optional<std::size_t> time_column(const RecordTable& table, const Header& header) {
  std::optional<std::size_t> time;
  for (std::size_t k = 0; k < table.titles.size(); ++k) {
    if (table.titles[k].quantity != Quantity::time) continue;
    if (time)
      table.cursor.fail_at(table.title_line, table.column_name(*time) + ", and " + table.column_name(k) +
                                                 ", are both times: leave one out");
    time = k;
  }
  if (time) {
    const Title& title = table.titles[*time];
    const bool clock = table.rows.front()[*time].find(':') != std::string_view::npos;
    if (clock || (title.unknown_unit.empty() && (!title.unit || title.unit->quantity == Quantity::time)))
      return time;
    table.cursor.fail_at(table.title_line,
                         table.column_name(*time) + ": its unit is no unit of time: must be s, ms or min");
  }
  const bool free = table.titles.empty() || (!table.titles[0].quantity && !table.titles[0].counts);
  if (!free || table.columns() < 2 || table.rows.size() < (table.columns() > 2 ? 3U : 1U))
    return std::nullopt;
  const std::vector<double> first = table.column(0);
  const bool numbers = header.interval && counts(first) && *header.interval != 1;
  if (table.columns() == 2 && !header.interval && table.titles.empty()) return 0;
  return rises(first) && !numbers ? std::optional<std::size_t>(0) : std::nullopt;
}

Unit unit_of_column(const RecordTable& table, const Header& header, std::size_t column) {
  const Title& title = table.titles[column];
  const Unit unit = title.unit ? *title.unit : stated_unit(table, header);
  if (title.quantity && unit.quantity != *title.quantity)
    table.cursor.fail_at(table.title_line, table.column_name(column) + " has no unit of " +
                                               std::string(name(*title.quantity)) +
                                               (title.unit ? "" : ", nor has the header") +
                                               ": say e.g. \"units: m/s2\", or (m/s2) in its title");
  return unit;
}

[[noreturn]] void fail_unknown(const RecordTable& table, std::size_t column) {
  table.cursor.fail_at(table.title_line,
                       table.column_name(column) + ": " + in_quotes(table.titles[column].unknown_unit) +
                           " is no unit of acceleration: must be e.g. m/s2, cm/s2, gal or g");
}

/// Columns of the highest derivative that titles name; else those that no title says to be something else.
std::vector<std::size_t> titled_series(const RecordTable& table, const std::optional<std::size_t>& time) {
  const auto those = [&](std::optional<Quantity> quantity) {
    std::vector<std::size_t> list;
    for (std::size_t k = 0; k < table.columns(); ++k) {
      const Title& title = table.titles[k];
      if (k != time && title.quantity == quantity && !title.counts) list.push_back(k);
    }
    return list;
  };
  for (const Quantity quantity : {Quantity::acceleration, Quantity::velocity, Quantity::displacement})
    if (auto list = those(quantity); !list.empty()) return list;
  return those(std::nullopt);
}

Content titled_content(const RecordTable& table, const Header& header) {
  for (std::size_t k = 0; k < table.columns(); ++k)
    if (table.titles[k].spectral)
      table.cursor.fail_at(table.title_line,
                           table.column_name(k) + ": a spectrum is no record: must be a history in time");
  const auto time = time_column(table, header);
  Content content{0, titled_series(table, time), {}};
  if (content.columns.empty())
    table.cursor.fail_at(table.title_line,
                         "no column is an acceleration, velocity or displacement by its title");
  for (const std::size_t column : content.columns) {
    if (!table.titles[column].unknown_unit.empty() && !table.titles[column].unit) fail_unknown(table, column);
    content.units.push_back(unit_of_column(table, header, column));
  }
  content.interval = interval_of(table, header, time);
  return content;
}

Content plain_content(const RecordTable& table, const Header& header) {
  const Unit unit = stated_unit(table, header);
  const auto time = time_column(table, header);
  Content content{interval_of(table, header, time), {}, {}};
  const bool numbered = !time && table.columns() > 1 && counts(table.column(0));
  for (std::size_t k = time || numbered ? 1 : 0; k < table.columns(); ++k) content.columns.push_back(k);
  content.units.assign(content.columns.size(), unit);
  if (content.columns.size() > 1 && header.mixed_line != 0)
    table.cursor.fail_at(
        header.mixed_line,
        "names an acceleration and a velocity or displacement, and is no line of titles: one "
        "above the numbers, parted as they are, must say which columns have which");
  return content;
}

/// A record of what its unit says, differentiated as often as that takes.
Record accelerogram(const Cursor& cursor, Record record, Quantity quantity) {
  if (quantity == Quantity::acceleration) return record;
  if (record.samples.size() < 2)
    cursor.fail("one sample of a velocity or displacement gives no acceleration");
  Record motion = quantity == Quantity::velocity
                      ? acceleration_of_velocity(record.interval, record.samples)
                      : acceleration_of_displacement(record.interval, record.samples);
  motion.format = record.format + " of " + std::string(name(quantity));
  return motion;
}

/// Which column a series is, of how many, and what was left out.
std::string taken_column(const RecordTable& table, const Content& content, std::size_t column) {
  if (table.columns() == 1) return "";
  const std::size_t number_length = ("column " + std::to_string(column + 1)).size();
  std::string text = table.column_name(column);
  text.insert(number_length, " of " + std::to_string(table.columns()));
  return content.columns.size() == 1
             ? text
             : text + ", one of " + std::to_string(content.columns.size()) + " series";
}

void add_columns(const RecordTable& table, const Content& content, std::vector<Record>& records) {
  table.check_even(false);
  const Cursor last = table.cursor.at_line(table.lines.back());
  for (std::size_t k = 0; k < content.columns.size(); ++k) {
    Record record = make_record(content.interval, table.column(content.columns[k]), content.units[k].factor,
                                "text columns");
    record = accelerogram(last, std::move(record), content.units[k].quantity);
    record.taken = taken_column(table, content, content.columns[k]);
    records.push_back(std::move(record));
  }
}

/// All numbers, from line to line.
std::vector<double> all_numbers(const RecordTable& table) {
  std::vector<double> values;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    for (std::size_t k = 0; k < table.rows[row].size(); ++k) values.push_back(table.number_at(row, k));
  return values;
}

/// A series of as many values as NPTS says, one more or one less.
void add_counted(const RecordTable& table, const Header& header, std::vector<Record>& records) {
  const Cursor end = table.cursor.at_line(table.lines.empty() ? header.last_line : table.lines.back());
  if (!header.interval) end.fail_at(header.count_line, "NPTS without DT: the time step is missing");
  const Unit unit = stated_unit(table, header);
  if (unit.quantity != Quantity::acceleration)
    end.fail_at(
        header.last_line,
        "the header up to here names no unit of acceleration: say e.g. \"units: m/s2\" (or cm/s2, gal, g)");
  std::vector<double> values = all_numbers(table);
  if (values.size() == header.count + 1) values.pop_back();
  if (values.empty() || values.size() + 1 != header.count)
    check_count(end, values.size(), header.count, header.count_line);
  records.push_back(make_record(*header.interval, std::move(values), unit.factor, "PEER AT2"));
}

/// Five columns or more without times and titles: one series that goes on from line to line.
void add_continued(const RecordTable& table, const Header& header, std::vector<Record>& records) {
  const Unit unit = stated_unit(table, header);
  const double interval = interval_of(table, header, std::nullopt);
  Record record = make_record(interval, all_numbers(table), unit.factor, "text columns");
  records.push_back(accelerogram(table.cursor.at_line(table.lines.back()), std::move(record), unit.quantity));
}

/// Takes a line "NPTS dt" off the front of the rows: a count of rows or values and their step.
void take_count_row(RecordTable& table, Header& header) {
  constexpr double longest = 1;  // step, s
  if (table.rows.size() < 2 || table.rows.front().size() != 2) return;
  const double count = table.number_at(0, 0), step = table.number_at(0, 1);
  if (!(count >= 2) || count != std::floor(count) || !(step > 0) || step > longest) return;
  const bool pairs = table.rows[1].size() == 2;
  if (pairs && count != static_cast<double>(table.rows.size() - 1)) return;
  header.count = static_cast<std::size_t>(count);
  header.count_line = table.lines.front();
  note_interval(table.cursor.at_line(table.lines.front()), step, header);
  table.rows.erase(table.rows.begin());
  table.lines.erase(table.lines.begin());
}

/// Refuses text between the numbers of a series, which may be the head of another.
void check_whole(const RecordTable& table) {
  for (const Line& line : table.header)
    if (line.number > table.lines.front() && line.number < table.lines.back())
      table.cursor.fail_at(line.number, "text between the numbers: " + in_quotes(trimmed(line.text)) +
                                            "; a second series must be in a file of its own");
}

/// Refuses numbers such as 025 between commas: what parts columns may be a decimal point as well.
void check_commas(const RecordTable& table) {
  const auto is_cut = [](std::string_view cell) {
    return cell.size() > 1 && cell.front() == '0' && cell.find_first_not_of("0123456789") == cell.npos;
  };
  for (std::size_t k = 0; k < table.rows.size() && table.dialect.separator == ','; ++k)
    if (std::ranges::any_of(table.rows[k], is_cut))
      table.cursor.fail_at(table.lines[k],
                           "commas part columns and may be decimal points: columns must be parted by "
                           "semicolons or tabs");
}

void read(Cursor& cursor, std::vector<Record>& records) {
  RecordTable table = read_rows(cursor.file(), cursor.take_rest());
  check_commas(table);
  Header header = read_header(table);
  const std::size_t rows = table.rows.size();
  if (rows == 0 && header.count == 0)
    cursor.fail_at(header.last_line, "not a known format: must be " + std::string(known_formats));
  if (header.count > 0 && (rows == 0 || rows != header.count || table.columns() == 1)) {
    if (rows > 0) check_whole(table);
    return add_counted(table, header, records);
  }
  Header counted;
  take_count_row(table, counted);
  table.check_even(true);
  find_titles(table);
  header = read_header(table);
  if (counted.interval) note_interval(cursor.at_line(counted.count_line), *counted.interval, header);
  const bool one_each = !table.titles.empty() || table.columns() == 1 || time_column(table, header);
  constexpr std::size_t most_components = 4;
  if (!one_each && header.interval && table.columns() <= most_components && !counts(table.column(0)))
    cursor.fail_at(table.lines.front(),
                   std::to_string(table.columns()) +
                       " columns, none of them times: where each is a component, a line of names must stand "
                       "above them");
  const std::size_t first = records.size();
  if (!table.titles.empty())
    add_columns(table, titled_content(table, header), records);
  else if (one_each || table.columns() <= most_components)
    add_columns(table, plain_content(table, header), records);
  else
    add_continued(table, header, records);
  if (!one_each || !time_column(table, header)) check_whole(table);
  if (counted.count > 0)
    check_count(cursor.at_line(table.lines.back()), records[first].samples.size(), counted.count,
                counted.count_line);
}

}  // namespace

/// Plain text in columns. Titles above the columns say which are times and which an acceleration, velocity or
/// displacement, and in which unit; else lines of the header do ("# units: m/s2", "# dt = 0.01"). The highest
/// derivative is taken; of a velocity or a displacement, as that of a shake table, it is differentiated.
/// Without titles the first of several columns is time where it rises from row to row, and the others are a
/// component each. Times must have a constant step, up to 1 % of it where they are rounded; it is their mean
/// step, and the record starts at its first line whatever time that has. NPTS and DT, as in PEER's AT2,
/// announce a series that goes on from line to line: NGA files exist whose last line is filled up with one
/// value more, and others that lack one; a surplus value is dropped, a missing one shortens the record. A
/// line "NPTS dt" above the numbers does so too, and five columns or more without times and names are one.
const Format columns{recognises, read};

}  // namespace rockstack::records
