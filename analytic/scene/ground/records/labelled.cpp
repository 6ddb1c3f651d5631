#include <algorithm>
#include <cmath>
#include <numeric>

#include "analytic/scene/ground/records/format.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack::records {
namespace {

/// A key is in capitals, with digits and a few signs.
bool is_esm_field(std::string_view line) {
  const std::size_t colon = line.find(':');
  return colon != std::string_view::npos && colon > 0 && line[0] >= 'A' && line[0] <= 'Z';
}

/// Refuses samples whose peak is not that of the header, m/s², where that names one.
void check_peak(const Cursor& cursor, double peak, const std::vector<double>& samples, double factor) {
  constexpr double tolerance = 0.05;  // of what is rounded, or taken from data before their last processing
  double largest = 0;
  for (const double sample : samples) largest = std::max(largest, std::abs(sample * factor));
  if (peak > 0 && std::abs(largest - peak) > tolerance * peak)
    cursor.fail("PGA is " + number_text(peak, 6) + " m/s² here, and the samples below peak at " +
                number_text(largest, 6) + " m/s²");
}

void read_esm(Cursor& cursor, std::vector<Record>& series) {
  std::optional<double> factor, interval;
  double peak = 0;  // cm/s²; 0: not said
  std::size_t announced = 0, announced_in = 0, peak_line = 0;
  while (is_esm_field(cursor.peek())) {
    const std::string_view line = cursor.next({});
    const std::string_view key = line.substr(0, line.find(':'));
    const std::string_view value = trimmed(line.substr(key.size() + 1));
    if (key == "DATA_TYPE" && lower(value) != "acceleration")
      cursor.fail("DATA_TYPE is " + in_quotes(value) + ": must be ACCELERATION");
    if (key == "UNITS") factor = unit_factor(value);
    if (key == "UNITS" && !factor)
      cursor.fail("UNITS " + in_quotes(value) + " are not known as acceleration: cm/s^2, m/s^2, g are");
    if (key == "PGA_CM/S^2" && !value.empty()) {
      peak = std::abs(number(cursor, value));
      peak_line = cursor.line_number();
    }
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
  check_peak(cursor.at_line(peak_line), peak * centimetre_per_second_squared, samples, *factor);
  series.push_back(make_record({*interval}, std::move(samples), {*factor}, "ESM ASCII"));
}

}  // namespace

/// ASCII of the Engineering Strong-Motion database and of ITACA: "KEY: value" lines (64 in DYNA 1.2), then
/// one value a line. Used are DATA_TYPE, UNITS, SAMPLING_INTERVAL_S and NDATA.
const Format esm{[](Cursor cursor) { return starts_with(cursor.peek(), "event_name:"); }, read_esm};

namespace {

double positive(const Cursor& cursor, std::string_view field) {
  const double value = number(cursor, field);
  if (!(value > 0)) cursor.fail(in_quotes(field) + ": must be > 0");
  return value;
}

/// "3920(gal)/6182761".
double scale_factor(const Cursor& cursor, std::string_view field) {
  constexpr std::string_view middle = "(gal)/";
  const std::size_t cut = field.find(middle);
  if (cut == std::string_view::npos)
    cursor.fail("scale factor " + in_quotes(field) + ": must be like 3920(gal)/6182761");
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
  series.push_back(make_record({interval}, std::move(samples), {factor * centimetre_per_second_squared},
                               "K-NET/KiK-net ASCII"));
}

}  // namespace

/// K-NET and KiK-net ASCII: labelled header lines up to "Memo.", then counts of the recorder. Acceleration in
/// gal is count × "Scale Factor"; the recorder's offset is the mean of the record and is taken off, as the
/// network does for its "Max. Acc.". The number of samples is that of the duration.
const Format knet{[](Cursor cursor) { return starts_with(cursor.peek(), "origin time"); }, read_knet};

namespace {

/// "TIMESERIES NET_STA_LOC_CHA_Q, 40 samples, 40 sps, START, SLIST, FLOAT, M/S**2".
void read_obspy(Cursor& cursor, std::vector<Record>& series) {
  const std::string_view line = cursor.next("a line TIMESERIES");
  const auto fields = words(line, ",");
  const bool whole = fields.size() >= 9 && fields[3] == "samples" && fields[5] == "sps";
  if (!whole || !starts_with(line, "timeseries"))
    cursor.fail("expected \"TIMESERIES NAME, n samples, r sps, START, SLIST or TSPAIR, FLOAT, UNIT\"");
  const std::size_t announced = count(cursor, fields[2]), announced_in = cursor.line_number();
  const double interval = checked_interval(cursor, 1 / number(cursor, fields[4]));
  const std::string_view unit = trimmed(line.substr(line.rfind(',') + 1));
  const auto factor = unit_factor(unit);
  if (!factor)
    cursor.fail(in_quotes(unit) + " at the end of this line is no unit of acceleration: must be e.g. M/S**2");
  const bool pairs = fields[7] == "TSPAIR";
  std::vector<double> samples;
  while (!cursor.at_end() && !starts_with(cursor.peek(), "timeseries")) {
    const auto values = words(cursor.next({}), ",");
    if (pairs && values.size() == 1) cursor.fail("expected a time and a value");
    for (std::size_t k = pairs ? 1 : 0; k < values.size(); ++k) samples.push_back(number(cursor, values[k]));
  }
  check_count(cursor, samples.size(), announced, announced_in);
  series.push_back(make_record({interval}, std::move(samples), {*factor}, "ObsPy " + std::string(fields[7])));
}

}  // namespace

/// ASCII of ObsPy and of IRIS, SLIST and TSPAIR: a line for each series that tells samples, rate and unit,
/// then values in free layout, or a time and a value a line.
const Format obspy{[](Cursor cursor) { return starts_with(cursor.peek(), "timeseries"); }, read_obspy};

}  // namespace rockstack::records
