#include "analytic/scene/ground/records/knet.hpp"

#include <cmath>
#include <numeric>

#include "analytic/scene/ground/records/units.hpp"

namespace rockstack::records {
namespace {

bool recognises(Cursor cursor) {
  return starts_with(cursor.peek(), "origin time");
}

struct Header {
  double frequency = 0;  ///< Hz
  double duration = 0;   ///< s
  double factor = 0;     ///< gal a count
};

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

Header read_header(Cursor& cursor) {
  constexpr std::size_t label_width = 18;
  Header header;
  for (std::string_view line; !starts_with(line, "memo");) {
    line = cursor.next("the line \"Memo.\"");
    const std::string_view value = line.size() < label_width ? "" : trimmed(line.substr(label_width));
    if (starts_with(line, "sampling freq")) {
      header.frequency = positive(cursor, value.substr(0, value.find_first_of("Hh")));
    } else if (starts_with(line, "duration time")) {
      header.duration = positive(cursor, value);
    } else if (starts_with(line, "scale factor")) {
      header.factor = scale_factor(cursor, value);
    }
  }
  if (header.frequency == 0) cursor.fail("the header ends here without \"Sampling Freq(Hz)\"");
  if (header.duration == 0) cursor.fail("the header ends here without \"Duration Time(s)\"");
  if (header.factor == 0) cursor.fail("the header ends here without \"Scale Factor\"");
  return header;
}

std::vector<Record> read(Cursor cursor) {
  const Header header = read_header(cursor);
  const double interval = checked_interval(cursor, 1 / header.frequency);
  std::vector<double> samples = read_values(cursor);
  const double announced = header.frequency * header.duration;
  if (samples.empty() || !(std::abs(static_cast<double>(samples.size()) - announced) < 0.5)) {
    cursor.fail("the file ends after " + std::to_string(samples.size()) +
                " values; frequency and duration announce " + shown(announced));
  }
  const double sum = std::accumulate(samples.begin(), samples.end(), 0.0);
  const double offset = sum / static_cast<double>(samples.size());
  for (double& sample : samples) sample -= offset;
  return {make_record(interval, std::move(samples), header.factor * centimetre_per_second_squared,
                      "K-NET/KiK-net ASCII")};
}

}  // namespace

const Format knet{recognises, read};

}  // namespace rockstack::records
