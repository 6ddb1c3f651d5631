#include "analytic/scene/ground/records/esm.hpp"

#include "analytic/scene/ground/records/units.hpp"

namespace rockstack::records {
namespace {

bool recognises(Cursor cursor) {
  return starts_with(cursor.peek(), "event_name:");
}

struct Header {
  std::optional<double> factor;
  std::optional<double> interval;
  std::size_t samples = 0;
  std::size_t samples_line = 0;
};

void read_field(const Cursor& cursor, std::string_view line, Header& header) {
  const std::string_view key = line.substr(0, line.find(':'));
  const std::string_view value = trimmed(line.substr(key.size() + 1));
  if (key == "DATA_TYPE" && lower(value) != "acceleration") {
    cursor.fail("DATA_TYPE is " + quoted(value) + ": must be ACCELERATION");
  }
  if (key == "UNITS") {
    header.factor = unit_factor(value);
    if (!header.factor)
      cursor.fail("UNITS " + quoted(value) + " are not known as acceleration: cm/s^2, m/s^2, g are");
  }
  if (key == "SAMPLING_INTERVAL_S") header.interval = checked_interval(cursor, number(cursor, value));
  if (key == "NDATA") {
    header.samples = count(cursor, value);
    header.samples_line = cursor.line_number();
  }
}

/// A key is in capitals, with digits and a few signs.
bool is_field(std::string_view line) {
  const std::size_t colon = line.find(':');
  return colon != std::string_view::npos && colon > 0 && line[0] >= 'A' && line[0] <= 'Z';
}

std::vector<Record> read(Cursor cursor) {
  Header header;
  while (is_field(cursor.peek())) read_field(cursor, cursor.next({}), header);
  if (!header.factor) cursor.fail("the header ends here without UNITS");
  if (!header.interval) cursor.fail("the header ends here without SAMPLING_INTERVAL_S");
  if (header.samples == 0) cursor.fail("the header ends here without NDATA");
  std::vector<double> samples = read_values(cursor);
  check_count(cursor, samples.size(), header.samples, header.samples_line);
  return {make_record(*header.interval, std::move(samples), *header.factor, "ESM ASCII")};
}

}  // namespace

const Format esm{recognises, read};

}  // namespace rockstack::records
