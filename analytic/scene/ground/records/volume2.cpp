#include "analytic/scene/ground/records/volume2.hpp"

#include <cmath>

#include "analytic/scene/ground/records/units.hpp"

namespace rockstack::records {
namespace {

constexpr std::size_t longest_header = 60;  // lines; 45 as a rule
constexpr std::size_t interval_line = 40;   // real header values 57 to 64, eight a line in ten columns each
constexpr std::size_t interval_column = 40;
constexpr Columns usual_columns{8, 10};

bool is_block_header(std::string_view line) {
  return contains(line, "points of") && contains(line, "equally spaced at");
}

bool recognises(Cursor cursor) {
  for (std::size_t k = 0; k < longest_header && !cursor.at_end(); ++k) {
    if (is_block_header(cursor.next({}))) return true;
  }
  return false;
}

/// Passes over the header of a channel; gives the ten characters of real header value 61.
std::string_view read_header(Cursor& cursor) {
  std::string_view interval;
  for (std::size_t k = 1; !is_block_header(cursor.peek()); ++k) {
    const std::string_view line = cursor.next("the line \"… points of accel data equally spaced at …\"");
    if (k > longest_header)
      cursor.fail("expected \"… points of accel data equally spaced at …\" before this line");
    if (k == interval_line && line.size() > interval_column) interval = line.substr(interval_column, 10);
  }
  return interval;
}

double block_interval(const Cursor& cursor, std::string_view line, std::string_view header_field) {
  constexpr double half_millisecond = 0.5e-3 * (1 + 1e-9);
  const double rounded = number(cursor, field_after(line, "spaced at"));
  if (trimmed(header_field).empty()) return checked_interval(cursor, rounded);
  const double full = number(cursor, header_field);
  const bool agree = full > 0 && std::abs(full - rounded) <= half_millisecond;
  return checked_interval(cursor, agree ? full : rounded);
}

/// The unit that follows "sec, in", "SEC.  IN UNITS" or "SEC.  (UNITS:".
double block_factor(const Cursor& cursor, std::string_view line) {
  bool expected = false;
  for (const std::string_view field : words(line, ",():")) {
    const auto factor = unit_factor(field);
    if (expected && factor) return *factor;
    expected = expected || lower(field) == "in" || lower(field) == "units";
  }
  cursor.fail("this line names no unit of acceleration: cm/sec2 or g");
}

/// Those that the last brackets name, where these do not hold the unit.
Columns block_columns(const Cursor& cursor, std::string_view line) {
  const std::size_t open = line.rfind('(');
  if (open == std::string_view::npos) return usual_columns;
  if (starts_with(line.substr(open), "(units")) return block_columns(cursor, line.substr(0, open));
  return fortran_columns(cursor, line);
}

void read_block(Cursor& cursor, std::string_view interval, std::vector<Record>& series) {
  const std::string_view line = cursor.next("a block of data");
  const std::size_t values = count(cursor, words(line).front());
  const Columns columns = block_columns(cursor, line);
  if (starts_with(field_after(line, "points of"), "acc")) {
    const double factor = block_factor(cursor, line);
    const double step = block_interval(cursor, line, interval);
    series.push_back(make_record(step, read_columns(cursor, values, columns), factor, "CSMIP volume 2"));
  } else {
    read_columns(cursor, values, columns);
  }
}

std::vector<Record> read(Cursor cursor) {
  std::vector<Record> series;
  while (!cursor.at_end()) {
    const std::string_view interval = read_header(cursor);
    while (is_block_header(cursor.peek())) read_block(cursor, interval, series);
    if (!cursor.at_end() && !trimmed(cursor.peek()).empty() && !is_end_of_data(cursor.next({}))) {
      cursor.fail("expected another block of data or its end, \"/&\"");
    }
    cursor.skip_blank();
  }
  return series;
}

}  // namespace

const Format volume2{recognises, read};

}  // namespace rockstack::records
