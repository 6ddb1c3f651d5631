#include "analytic/scene/ground/records/peer.hpp"

#include "analytic/scene/ground/records/units.hpp"

namespace rockstack::records {
namespace {

constexpr int longest_header = 60;

bool is_comment(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.empty() || std::string_view("#%!/;").find(text.front()) != std::string_view::npos;
}

bool announces_values(std::string_view line) {
  return contains(line, "npts") && !is_comment(line);
}

bool recognises(Cursor cursor) {
  for (int k = 0; k < longest_header && !cursor.at_end(); ++k) {
    if (announces_values(cursor.next({}))) return true;
  }
  return false;
}

struct Announced {
  std::size_t values = 0;
  double interval = 0;
};

/// "NPTS=  4000, DT= .01000 SEC", or the older "4000  .01000  NPTS, DT".
Announced read_announcement(const Cursor& cursor, std::string_view line) {
  std::string_view values = field_after(line, "npts");
  std::string_view interval = field_after(line, "dt");
  const auto fields = words(line);
  if (values.empty() && fields.size() > 2) {
    values = fields[0];
    interval = fields[1];
  }
  if (interval.empty()) cursor.fail("NPTS without DT: the time step is missing");
  return {count(cursor, values), read_interval(cursor, line, interval)};
}

/// Some copies end with "*** End Data ***"; overflown values are asterisks too, but alone.
bool is_end_marker(std::string_view line) {
  return starts_with(line, "***") && contains(line, "end");
}

std::vector<double> read_samples(Cursor& cursor) {
  std::vector<double> values;
  while (!cursor.at_end()) {
    const std::string_view line = cursor.next({});
    if (!is_end_marker(line)) append_values(cursor, line, values);
  }
  return values;
}

std::vector<Record> read(Cursor cursor) {
  HeaderUnit unit;
  std::string_view line;
  while (!announces_values(line)) {
    line = cursor.next("NPTS and DT");
    unit.read(cursor, line);
  }
  const Announced announced = read_announcement(cursor, line);
  const double factor = unit.factor(cursor);
  const std::size_t header_end = cursor.line_number();
  std::vector<double> values = read_samples(cursor);
  if (values.size() == announced.values + 1) values.pop_back();
  if (values.empty() || values.size() + 1 != announced.values) {
    check_count(cursor, values.size(), announced.values, header_end);
  }
  return {make_record(announced.interval, std::move(values), factor, "PEER AT2")};
}

}  // namespace

const Format peer{recognises, read};

}  // namespace rockstack::records
