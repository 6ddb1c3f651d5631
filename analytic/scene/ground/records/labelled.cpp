#include <cmath>
#include <numeric>

#include "analytic/scene/ground/records/format.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack::records {
namespace {

constexpr int longest_peer_header = 60;

/// Whether a line, which is no comment, tells the number of values.
bool announces_values(std::string_view line) {
  return contains(line, "npts") && trimmed(line).find_first_of("#%!/;") != 0;
}

bool is_peer(Cursor cursor) {
  for (int k = 0; k < longest_peer_header && !cursor.at_end(); ++k)
    if (announces_values(cursor.next({}))) return true;
  return false;
}

void read_peer(Cursor& cursor, std::vector<Record>& series) {
  HeaderUnit unit;
  std::string_view line;
  while (!announces_values(line)) {
    line = cursor.next("NPTS and DT");
    unit.read(cursor, line);
  }
  // "NPTS=  4000, DT= .01000 SEC", or the older "4000  .01000  NPTS, DT".
  const auto fields = words(line);
  const bool older = field_after(line, "npts").empty() && fields.size() > 2;
  const std::string_view step = older ? fields[1] : field_after(line, "dt");
  if (step.empty()) cursor.fail("NPTS without DT: the time step is missing");
  const std::size_t announced = count(cursor, older ? fields[0] : field_after(line, "npts"));
  const double interval = read_interval(cursor, line, step);
  const double factor = unit.factor(cursor);
  const std::size_t header_end = cursor.line_number();
  std::vector<double> values = read_values(cursor, true);
  if (values.size() == announced + 1) values.pop_back();
  if (values.empty() || values.size() + 1 != announced)
    check_count(cursor, values.size(), announced, header_end);
  series.push_back(make_record(interval, std::move(values), factor, "PEER AT2"));
}

}  // namespace

/// PEER AT2 and files like it: any number of header lines up to one that names NPTS and DT, then values in
/// free layout. The unit must be named in the header ("UNITS OF G"), g being 9.80665 m/s². NGA files exist
/// whose last line is filled up with one value more than NPTS, and others that lack one: a surplus value is
/// dropped, a missing one shortens the record; any larger difference is refused.
const Format peer{is_peer, read_peer};

namespace {

/// A key is in capitals, with digits and a few signs.
bool is_esm_field(std::string_view line) {
  const std::size_t colon = line.find(':');
  return colon != std::string_view::npos && colon > 0 && line[0] >= 'A' && line[0] <= 'Z';
}

void read_esm(Cursor& cursor, std::vector<Record>& series) {
  std::optional<double> factor, interval;
  std::size_t announced = 0, announced_in = 0;
  while (is_esm_field(cursor.peek())) {
    const std::string_view line = cursor.next({});
    const std::string_view key = line.substr(0, line.find(':'));
    const std::string_view value = trimmed(line.substr(key.size() + 1));
    if (key == "DATA_TYPE" && lower(value) != "acceleration")
      cursor.fail("DATA_TYPE is " + quoted(value) + ": must be ACCELERATION");
    if (key == "UNITS") factor = unit_factor(value);
    if (key == "UNITS" && !factor)
      cursor.fail("UNITS " + quoted(value) + " are not known as acceleration: cm/s^2, m/s^2, g are");
    if (key == "SAMPLING_INTERVAL_S") interval = checked_interval(cursor, number(cursor, value));
    if (key == "NDATA") {
      announced = count(cursor, value);
      announced_in = cursor.line_number();
    }
  }
  if (!factor) cursor.fail("the header ends here without UNITS");
  if (!interval) cursor.fail("the header ends here without SAMPLING_INTERVAL_S");
  if (announced == 0) cursor.fail("the header ends here without NDATA");
  std::vector<double> samples = read_values(cursor);
  check_count(cursor, samples.size(), announced, announced_in);
  series.push_back(make_record(*interval, std::move(samples), *factor, "ESM ASCII"));
}

}  // namespace

/// ASCII of the Engineering Strong-Motion database and of ITACA: "KEY: value" lines (64 in DYNA 1.2), then
/// one value a line. Used are DATA_TYPE, UNITS, SAMPLING_INTERVAL_S and NDATA.
const Format esm{[](Cursor cursor) { return starts_with(cursor.peek(), "event_name:"); }, read_esm};

namespace {

double positive(const Cursor& cursor, std::string_view field) {
  const double value = number(cursor, field);
  if (!(value > 0)) cursor.fail(quoted(field) + ": must be > 0");
  return value;
}

/// "3920(gal)/6182761".
double scale_factor(const Cursor& cursor, std::string_view field) {
  constexpr std::string_view middle = "(gal)/";
  const std::size_t cut = field.find(middle);
  if (cut == std::string_view::npos)
    cursor.fail("scale factor " + quoted(field) + ": must be like 3920(gal)/6182761");
  return positive(cursor, field.substr(0, cut)) / positive(cursor, field.substr(cut + middle.size()));
}

void read_knet(Cursor& cursor, std::vector<Record>& series) {
  constexpr std::size_t label_width = 18;
  double frequency = 0;  // Hz
  double duration = 0;   // s
  double factor = 0;     // gal a count
  for (std::string_view line; !starts_with(line, "memo");) {
    line = cursor.next("the line \"Memo.\"");
    const std::string_view value = line.size() < label_width ? "" : trimmed(line.substr(label_width));
    if (starts_with(line, "sampling freq")) {
      frequency = positive(cursor, value.substr(0, value.find_first_of("Hh")));
    } else if (starts_with(line, "duration time")) {
      duration = positive(cursor, value);
    } else if (starts_with(line, "scale factor")) {
      factor = scale_factor(cursor, value);
    }
  }
  if (frequency == 0) cursor.fail("the header ends here without \"Sampling Freq(Hz)\"");
  if (duration == 0) cursor.fail("the header ends here without \"Duration Time(s)\"");
  if (factor == 0) cursor.fail("the header ends here without \"Scale Factor\"");
  const double interval = checked_interval(cursor, 1 / frequency);
  std::vector<double> samples = read_values(cursor);
  const double announced = frequency * duration;
  if (samples.empty() || !(std::abs(static_cast<double>(samples.size()) - announced) < 0.5))
    cursor.fail("the file ends after " + std::to_string(samples.size()) +
                " values; frequency and duration announce " + number_text(announced));
  const double sum = std::accumulate(samples.begin(), samples.end(), 0.0);
  const double offset = sum / static_cast<double>(samples.size());
  for (double& sample : samples) sample -= offset;
  series.push_back(make_record(interval, std::move(samples), factor * centimetre_per_second_squared,
                               "K-NET/KiK-net ASCII"));
}

}  // namespace

/// K-NET and KiK-net ASCII: labelled header lines up to "Memo.", then counts of the recorder. Acceleration in
/// gal is count × "Scale Factor"; the recorder's offset is the mean of the record and is taken off, as the
/// network does for its "Max. Acc.". The number of samples is that of the duration.
const Format knet{[](Cursor cursor) { return starts_with(cursor.peek(), "origin time"); }, read_knet};

}  // namespace rockstack::records
