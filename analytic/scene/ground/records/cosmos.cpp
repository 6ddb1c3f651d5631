#include "analytic/scene/ground/records/cosmos.hpp"

#include "analytic/scene/ground/records/units.hpp"

namespace rockstack::records {
namespace {

constexpr std::size_t usual_text_lines = 13;
constexpr double usual_null = -999.0;
constexpr std::size_t units_code_place = 3;     // counted from 1, as are the next two
constexpr std::size_t raw_interval_place = 34;  // s
constexpr std::size_t interval_place = 62;      // ms
constexpr double second_per_millisecond = 0.001;

bool recognises(Cursor cursor) {
  return contains(cursor.peek(), "(format v");
}

/// The text lines of a channel. Gives the value that stands for "unknown".
double read_text_lines(Cursor& cursor) {
  const std::string_view first = cursor.next("text lines");
  if (!contains(first, "(format v"))
    cursor.fail("expected the first text line of a channel, \"… (Format v01.20 …)\"");
  const std::string_view announced = field_after(first, "with");
  double null = usual_null;
  for (std::size_t left = announced.empty() ? usual_text_lines : count(cursor, announced); left > 1; --left) {
    const std::string_view line = cursor.next("the integer header");
    if (contains(line, "unknown") && line.find(':') != std::string_view::npos) {
      const auto values = words(line.substr(line.find(':') + 1));
      if (!values.empty()) null = number(cursor, values.back());
    }
  }
  return null;
}

std::string_view first_word(const Cursor& cursor, std::string_view line) {
  const auto fields = words(line);
  if (fields.empty()) cursor.fail("this line should start with a count");
  return fields.front();
}

/// "100 Integer-header values follow on  10 lines, Format= (10I8)" and the values.
std::vector<double> read_header(Cursor& cursor, std::string_view name) {
  const std::string_view line = cursor.next(name);
  if (!contains(line, name)) cursor.fail("expected the line of the " + std::string(name));
  return read_columns(cursor, count(cursor, first_word(cursor, line)), fortran_columns(cursor, line));
}

void skip_comments(Cursor& cursor) {
  const std::string_view line = cursor.next("comment lines");
  if (!contains(line, "comment line")) cursor.fail("expected the number of comment lines");
  const std::string_view lines = first_word(cursor, line);
  if (number(cursor, lines) != 0) cursor.skip(count(cursor, lines), "the data");
}

double header_interval(const Cursor& cursor, const std::vector<double>& reals, double null) {
  if (reals.size() >= interval_place && reals[interval_place - 1] != null) {
    return checked_interval(cursor, reals[interval_place - 1] * second_per_millisecond);
  }
  if (reals.size() < raw_interval_place || reals[raw_interval_place - 1] == null) {
    cursor.fail("the real header gives no time step, neither value 62 nor value 34");
  }
  return checked_interval(cursor, reals[raw_interval_place - 1]);
}

std::optional<double> code_factor(double code) {
  if (code == 2) return standard_gravity;
  if (code == 4) return centimetre_per_second_squared;
  return std::nullopt;
}

/// The unit of "7000  acceleration pts, approx   70 secs, units=cm/sec2(04),Format=(8F10.5)".
double data_factor(const Cursor& cursor, std::string_view line, const std::vector<double>& integers) {
  const std::string_view field = field_after(line, "units");
  const std::string_view unit = field.substr(0, field.find('('));
  const auto factor = unit_factor(unit);
  if (!factor) cursor.fail("units " + quoted(unit) + " are not known as acceleration: g and cm/sec2 are");
  const auto coded =
      integers.size() < units_code_place ? std::nullopt : code_factor(integers[units_code_place - 1]);
  if (coded && *coded != *factor)
    cursor.fail("units " + quoted(unit) + " contradict the integer header's unit code");
  return *factor;
}

void read_channel(Cursor& cursor, std::vector<Record>& series) {
  const double null = read_text_lines(cursor);
  const std::vector<double> integers = read_header(cursor, "integer-header");
  const std::vector<double> reals = read_header(cursor, "real-header");
  skip_comments(cursor);
  const std::string_view line = cursor.next("the data");
  const std::size_t values = count(cursor, first_word(cursor, line));
  const Columns columns = fortran_columns(cursor, line);
  if (contains(line.substr(0, line.find(',')), "accel")) {
    const double factor = data_factor(cursor, line, integers);
    const double interval = header_interval(cursor, reals, null);
    series.push_back(make_record(interval, read_columns(cursor, values, columns, null), factor, "COSMOS"));
  } else {
    read_columns(cursor, values, columns);
  }
  cursor.skip_blank();
  if (!is_end_of_data(cursor.next("the end of data, \"/&\"")))
    cursor.fail("expected the end of data, \"/&\"");
  cursor.skip_blank();
}

std::vector<Record> read(Cursor cursor) {
  std::vector<Record> series;
  while (!cursor.at_end()) read_channel(cursor, series);
  return series;
}

}  // namespace

const Format cosmos{recognises, read};

}  // namespace rockstack::records
