#include <algorithm>
#include <cmath>
#include <numeric>

#include "analytic/scene/ground/records/contents.hpp"
#include "analytic/scene/ground/records/format.hpp"
#include "analytic/scene/ground/records/layout_checks.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack::records {
namespace {

/// Whether a line begins with a number, or tells the number of values.
bool recognises(Cursor cursor) {
  while (!cursor.at_end()) {
    const std::string_view line = cursor.next({});
    const auto fields = words(line, ",;\"");
    if (contains(line, "npts") || std::ranges::any_of(fields, is_numeric)) return true;
  }
  return false;
}

/// Refuses a velocity that does not begin at zero and a displacement that begins or ends in motion: grounds
/// begin at rest, and a displacement's end would be a stop within one step.
void check_at_rest(const Cursor& cursor, const std::vector<double>& samples, Quantity quantity) {
  constexpr double small = 0.05;  // of the largest speed
  std::vector<double> speeds = samples;
  if (quantity == Quantity::displacement) {
    std::adjacent_difference(samples.begin(), samples.end(), speeds.begin());
    speeds.erase(speeds.begin());
  }
  double largest = 0;
  for (const double speed : speeds) largest = std::max(largest, std::abs(speed));
  const auto moves = [&](double speed) { return std::abs(speed) > small * largest; };
  if (moves(speeds.front()))
    cursor.fail("the " + std::string(name(quantity)) + " above begins in motion: must begin at rest");
  if (quantity == Quantity::displacement && moves(speeds.back()))
    cursor.fail("the displacement above ends in motion: must end at rest");
}

/// A record of what its unit says, differentiated as often as that takes.
Record accelerogram(const Cursor& cursor, Record record, Quantity quantity) {
  if (quantity == Quantity::acceleration) return record;
  if (record.samples.size() < 2)
    cursor.fail("one sample of a velocity or displacement gives no acceleration");
  check_at_rest(cursor, record.samples, quantity);
  Record motion = quantity == Quantity::velocity
                      ? acceleration_of_velocity(record.interval, record.samples)
                      : acceleration_of_displacement(record.interval, record.samples);
  motion.format = record.format + " of " + std::string(name(quantity));
  motion.unit = record.unit;
  motion.step = record.step + (quantity == Quantity::velocity ? ", halved" : "");
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

void add_columns(const RecordTable& table, const Header& header, const Content& content,
                 std::vector<Record>& records) {
  table.check_even(false);
  check_present(table, header, content.columns);
  for (const std::size_t column : content.columns) {
    check_thousands(table, column);
    check_marks(table, column);
  }
  const Cursor last = table.cursor.at_line(table.lines.back());
  for (std::size_t k = 0; k < content.columns.size(); ++k) {
    Record record =
        make_record(content.interval, table.column(content.columns[k]), content.units[k], "text columns");
    record = accelerogram(last, std::move(record), content.units[k].quantity);
    record.taken = taken_column(table, content, content.columns[k]);
    records.push_back(std::move(record));
  }
}

/// All numbers, from line to line.
std::vector<double> all_numbers(const RecordTable& table, const Header& header) {
  std::vector<std::size_t> columns(table.columns());
  std::iota(columns.begin(), columns.end(), 0);
  check_present(table, header, columns);
  check_cards(table);
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
  std::vector<double> values = table.rows.empty() ? std::vector<double>() : all_numbers(table, header);
  if (values.size() == header.count + 1) values.pop_back();
  if (values.empty() || table.columns() == 1 || values.size() + 1 != header.count)
    check_count(end, values.size(), header.count, header.count_line);
  records.push_back(make_record(step_of(header), std::move(values), unit, "PEER AT2"));
}

/// Five columns or more without times and titles: one series that goes on from line to line.
void add_continued(const RecordTable& table, const Header& header, std::vector<Record>& records) {
  const Unit unit = stated_unit(table, header);
  Record record =
      make_record(interval_of(table, header, std::nullopt), all_numbers(table, header), unit, "text columns");
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

void read(Cursor& cursor, std::vector<Record>& records) {
  RecordTable table = read_rows(cursor.file(), cursor.take_rest());
  check_commas(table);
  if (!table.rows.empty()) check_tail(table);
  if (!table.rows.empty()) label_labview(table);
  Header header = read_header(table);
  const std::size_t rows = table.rows.size();
  if (rows == 0 && header.count == 0)
    cursor.fail_at(header.last_line, "not a known format: must be " + std::string(known_formats));
  if (header.count > 0 && (rows == 0 || rows != header.count || table.columns() == 1)) {
    if (rows > 0) check_whole(table);
    check_history(table, header);
    return add_counted(table, header, records);
  }
  Header counted;
  take_count_row(table, counted);
  table.check_even(true);
  if (table.titles.empty()) find_titles(table);
  unfold_pairs(table);
  if (table.titles.empty()) find_titles(table);
  check_titles(table);
  header = read_header(table);
  check_history(table, header);
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
    add_columns(table, header, titled_content(table, header), records);
  else if (one_each || table.columns() <= most_components)
    add_columns(table, header, plain_content(table, header), records);
  else
    add_continued(table, header, records);
  if (!one_each || !time_column(table, header)) check_whole(table);
  const bool continued = table.titles.empty() && !one_each && table.columns() > most_components;
  if (header.stated_count > 0)
    check_count(cursor.at_line(table.lines.back()),
                continued ? records[first].samples.size() : table.rows.size(), header.stated_count,
                header.stated_count_line);
  if (counted.count > 0)
    check_count(cursor.at_line(table.lines.back()), records[first].samples.size(), counted.count,
                counted.count_line);
}

}  // namespace

/// Plain text in columns. Titles above the columns say which are times and which an acceleration, velocity or
/// displacement, and in which unit; else lines of the header do ("# units: m/s2", "# dt = 0.01"). The highest
/// derivative is taken; of a velocity or a displacement, as that of a shake table, it is differentiated.
/// Where there are titles, time is the column that one calls so or gives a unit of time. Without titles the
/// first of several columns is time where it rises from row to row, and the others are a component each;
/// pairs of a time and a value may stand side by side. Times must have a constant step, up to 1 % of it where
/// they are rounded; it is their mean step, and the record starts at its first line whatever time that has.
/// What the header says of the number of values, the step and the unit must hold; factors and spectra are
/// refused. NPTS and DT, as in PEER's AT2, announce a series that goes on from line to line: NGA files exist
/// whose last line is filled up with one value more, and others that lack one; a surplus value is dropped, a
/// missing one shortens the record. A line "NPTS dt" above the numbers does so too, and five columns or more
/// without times and names are one.
const Format columns{recognises, read};

}  // namespace rockstack::records
