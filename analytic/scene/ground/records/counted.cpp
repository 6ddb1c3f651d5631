#include <cmath>

#include "analytic/scene/ground/records/format.hpp"

namespace rockstack::records {
namespace {

constexpr std::size_t usual_text_lines = 13;
constexpr double usual_null = -999.0;
constexpr std::size_t units_code_place = 3;     // counted from 1, as are the next two
constexpr std::size_t raw_interval_place = 34;  // s
constexpr std::size_t interval_place = 62;      // ms
constexpr double second_per_millisecond = 0.001;

/// "/& ---- End of data for channel 1", or "End-of-data for Chan  1 acceleration".
bool is_end_of_data(std::string_view line) {
  return starts_with(line, "/&") || starts_with(line, "end-of-data");
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
std::vector<double> read_counted_header(Cursor& cursor, std::string_view name) {
  const std::string_view line = cursor.next(name);
  if (!contains(line, name)) cursor.fail("expected the line of the " + std::string(name));
  return read_columns(cursor, count(cursor, first_word(cursor, line)), fortran_columns(cursor, line));
}

double header_interval(const Cursor& cursor, const std::vector<double>& reals, double null) {
  if (reals.size() >= interval_place && reals[interval_place - 1] != null)
    return checked_interval(cursor, reals[interval_place - 1] * second_per_millisecond);
  if (reals.size() < raw_interval_place || reals[raw_interval_place - 1] == null)
    cursor.fail("the real header gives no time step, neither value 62 nor value 34");
  return checked_interval(cursor, reals[raw_interval_place - 1]);
}

/// The unit of "7000  acceleration pts, approx   70 secs, units=cm/sec2(04),Format=(8F10.5)".
double data_factor(const Cursor& cursor, std::string_view line, const std::vector<double>& integers) {
  const std::string_view field = field_after(line, "units");
  const std::string_view unit = field.substr(0, field.find('('));
  const auto factor = unit_factor(unit);
  if (!factor) cursor.fail("units " + in_quotes(unit) + " are not known as acceleration: g and cm/sec2 are");
  const double code = integers.size() < units_code_place ? 0 : integers[units_code_place - 1];
  if ((code == 2 && *factor != standard_gravity) || (code == 4 && *factor != centimetre_per_second_squared))
    cursor.fail("units " + in_quotes(unit) + " contradict the integer header's unit code");
  return *factor;
}

void read_channel(Cursor& cursor, std::vector<Record>& series) {
  const double null = read_text_lines(cursor);
  const std::vector<double> integers = read_counted_header(cursor, "integer-header");
  const std::vector<double> reals = read_counted_header(cursor, "real-header");
  const std::string_view comments = cursor.next("comment lines");
  if (!contains(comments, "comment line")) cursor.fail("expected the number of comment lines");
  const std::string_view lines = first_word(cursor, comments);
  if (number(cursor, lines) != 0) cursor.skip(count(cursor, lines), "the data");
  const std::string_view line = cursor.next("the data");
  const std::size_t values = count(cursor, first_word(cursor, line));
  const Columns columns = fortran_columns(cursor, line);
  if (contains(line.substr(0, line.find(',')), "accel")) {
    const double factor = data_factor(cursor, line, integers);
    const double interval = header_interval(cursor, reals, null);
    series.push_back(
        make_record({interval}, read_columns(cursor, values, columns, null), {factor}, "COSMOS"));
  } else {
    read_columns(cursor, values, columns);
  }
  cursor.skip_blank();
  if (!is_end_of_data(cursor.next("the end of data, \"/&\"")))
    cursor.fail("expected the end of data, \"/&\"");
  cursor.skip_blank();
}

}  // namespace

/// COSMOS strong-motion format 1.20 (V1 and V2 files): text lines, then counted blocks of integers, reals,
/// comments and data that name their own Fortran format, channel after channel. The time step is real header
/// value 62 (ms), or where that is null, value 34 (s). Unit and quantity come from the line above the data;
/// velocity and displacement are passed over. A sample that equals the file's null (-999) is refused.
const Format cosmos{[](Cursor cursor) { return contains(cursor.peek(), "(format v"); }, read_channel};

namespace {

constexpr std::size_t smc_text_lines = 11;
constexpr std::size_t smc_reals = 50;
constexpr std::size_t integer_lines = 6, comments_line = 2, comments_place = 7, samples_line = 3;

/// "2 CORRECTED ACCELEROGRAM", "3 VELOCITY" …
bool is_smc(Cursor cursor) {
  const std::string_view line = trimmed(cursor.peek());
  if (line.size() < 2 || line[0] < '1' || line[0] > '9' || line[1] != ' ') return false;
  return contains(line, "accelerogram") || contains(line, "velocity") || contains(line, "displacement") ||
         contains(line, "spectr");
}

std::string_view smc_field(std::string_view line, std::size_t place) {
  constexpr std::size_t width = 10;
  return line.size() <= place * width ? std::string_view() : line.substr(place * width, width);
}

void read_smc(Cursor& cursor, std::vector<Record>& series) {
  const std::string_view title = cursor.next("the title");
  if (!contains(title, "accelerogram"))
    cursor.fail("holds " + in_quotes(trimmed(title)) + ": only an accelerogram can be used");
  cursor.skip(smc_text_lines - 1, "the header");
  std::size_t comments = 0, announced = 0;
  for (std::size_t k = 1; k <= integer_lines; ++k) {
    const std::string_view line = cursor.next("the 48 integers of the header");
    const std::string_view field = smc_field(line, comments_place);
    if (k == comments_line && number(cursor, field) != 0) comments = count(cursor, field);
    if (k == samples_line) announced = count(cursor, smc_field(line, 0));
  }
  const std::vector<double> header = read_columns(cursor, smc_reals, {5, 15});
  const double null = header[0];
  if (header[1] == null) cursor.fail("the header gives no sampling rate (second of the 50 reals)");
  const double interval = checked_interval(cursor, 1 / header[1]);
  for (; comments > 0; --comments)
    if (!cursor.next("comment lines").starts_with('|')) cursor.fail("expected a comment line, \"|…\"");
  std::vector<double> samples = read_columns(cursor, announced, {8, 10}, null);
  cursor.skip_blank();
  if (!cursor.at_end()) {
    cursor.next({});
    cursor.fail("surplus line after " + std::to_string(announced) + " samples");
  }
  series.push_back(make_record({interval}, std::move(samples), {centimetre_per_second_squared}, "USGS SMC"));
}

}  // namespace

/// USGS SMC: 11 text lines, the first of which says what the file holds; 48 integers (value 16: comment
/// lines, value 17: samples); 50 reals (value 1: the null, value 2: samples a second); comments; samples in
/// cm/s², eight a line in ten columns each without blanks between. Velocity, displacement and spectra are
/// refused, and so are nulls.
const Format smc{is_smc, read_smc};

namespace {

constexpr std::size_t longest_volume2_header = 60;  // lines; 45 as a rule
constexpr std::size_t interval_line = 40;  // real header values 57 to 64, eight a line in ten columns each
constexpr std::size_t interval_column = 40;
constexpr Columns usual_columns{8, 10};

bool is_block_header(std::string_view line) {
  return contains(line, "points of") && contains(line, "equally spaced at");
}

bool is_volume2(Cursor cursor) {
  for (std::size_t k = 0; k < longest_volume2_header && !cursor.at_end(); ++k)
    if (is_block_header(cursor.next({}))) return true;
  return false;
}

/// Passes over the header of a channel; gives the ten characters of real header value 61.
std::string_view read_volume2_header(Cursor& cursor) {
  std::string_view interval;
  for (std::size_t k = 1; !is_block_header(cursor.peek()); ++k) {
    const std::string_view line = cursor.next("the line \"… points of accel data equally spaced at …\"");
    if (k > longest_volume2_header)
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
    series.push_back(make_record({step}, read_columns(cursor, values, columns), {factor}, "CSMIP volume 2"));
  } else {
    read_columns(cursor, values, columns);
  }
}

void read_volume2(Cursor& cursor, std::vector<Record>& series) {
  const std::string_view interval = read_volume2_header(cursor);
  while (is_block_header(cursor.peek())) read_block(cursor, interval, series);
  if (!cursor.at_end() && !trimmed(cursor.peek()).empty() && !is_end_of_data(cursor.next({})))
    cursor.fail("expected another block of data or its end, \"/&\"");
  cursor.skip_blank();
}

}  // namespace

/// "Volume 2" files of CSMIP and, before it, Caltech and USC: 25 text lines, 100 integers and 100 reals a
/// channel, then blocks of acceleration, velocity and displacement, each under a line such as "15050 points
/// of accel data equally spaced at  .020 sec, in cm/sec2. (8f10.6)"; where that names no format it is
/// (8F10.3). Its time step is rounded to ms; real header value 61 has it in full and is taken where the two
/// agree. Channels end in "/&" lines. Velocity and displacement are passed over.
const Format volume2{is_volume2, read_volume2};

}  // namespace rockstack::records
