#include "analytic/scene/ground/records/columns.hpp"

#include <array>
#include <cmath>

#include "analytic/scene/ground/records/units.hpp"

namespace rockstack::records {
namespace {

constexpr double step_tolerance = 0.01;

/// A word that stands where a number belongs, right or wrong.
bool is_numeric(std::string_view word) {
  const std::string text = lower(word);
  return (text.front() >= '0' && text.front() <= '9') || text.find_first_of("+-.") == 0 || text == "nan" ||
         text == "inf" || text == "infinity";
}

bool is_header(std::string_view line) {
  const auto fields = words(line);
  if (fields.empty() || is_numeric(fields.front())) return false;
  const char first = lower(fields.front()).front();
  return (first >= 'a' && first <= 'z') || std::string_view("#%!;*/\"").find(first) != std::string_view::npos;
}

/// Whether the lines up to the first with a number are all header.
bool recognises(Cursor cursor) {
  while (!cursor.at_end() && (trimmed(cursor.peek()).empty() || is_header(cursor.peek()))) cursor.next({});
  const auto fields = words(cursor.peek());
  return !fields.empty() && is_numeric(fields.front());
}

struct Header {
  HeaderUnit unit;
  std::optional<double> interval;
};

void read_header(const Cursor& cursor, std::string_view line, Header& header) {
  header.unit.read(cursor, line);
  if (contains(line, "(ms)") || contains(line, "[ms]")) cursor.fail("times in ms: must be in s");
  constexpr std::array<std::string_view, 4> names{"dt", "time step", "timestep", "interval"};
  for (const std::string_view name : names) {
    const std::string_view field = field_after(line, name);
    if (field.empty() || !is_numeric(field)) continue;
    const double interval = read_interval(cursor, line, field);
    if (header.interval && *header.interval != interval)
      cursor.fail("names another time step than a line before");
    header.interval = interval;
  }
}

struct Table {
  std::size_t columns = 0;
  std::vector<double> times;
  std::vector<double> values;
  std::vector<std::size_t> lines;
};

void read_row(const Cursor& cursor, std::string_view line, Table& table) {
  const auto fields = words(line);
  if (table.columns == 0) table.columns = fields.size();
  if (fields.size() > 2) {
    cursor.fail(std::to_string(fields.size()) +
                " columns: must be one (acceleration) or two (time, acceleration)");
  }
  if (fields.size() != table.columns) {
    cursor.fail(std::to_string(fields.size()) + " columns where lines before have " +
                std::to_string(table.columns));
  }
  if (fields.size() == 2) table.times.push_back(number(cursor, fields[0]));
  table.values.push_back(number(cursor, fields.back()));
  table.lines.push_back(cursor.line_number());
}

/// The mean step, which all others must equal.
double constant_step(const Cursor& cursor, const Table& table) {
  const std::vector<double>& times = table.times;
  if (times.size() < 2) cursor.fail("one time alone gives no time step");
  const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  checked_interval(cursor, step);
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double expected = times.front() + static_cast<double>(k) * step;
    if (std::abs(times[k] - expected) > step_tolerance * step) {
      cursor.fail_at(table.lines[k],
                     "time " + shown(times[k]) + " where a constant step gives " + shown(expected));
    }
  }
  return step;
}

std::vector<Record> read(Cursor cursor) {
  Header header;
  Table table;
  while (!cursor.at_end()) {
    const std::string_view line = cursor.next({});
    if (trimmed(line).empty()) continue;
    if (is_header(line))
      read_header(cursor, line, header);
    else
      read_row(cursor, line, table);
  }
  const double factor = header.unit.factor(cursor);
  if (table.columns == 1 && !header.interval) {
    cursor.fail_at(table.lines.front(),
                   "one column, and no time step in the header: say e.g. \"# dt = 0.01\" (s)");
  }
  const double step = table.columns == 2 ? constant_step(cursor, table) : *header.interval;
  if (header.interval && std::abs(step - *header.interval) > step_tolerance * step) {
    cursor.fail("times step by " + shown(step) + " s, the header says dt = " + shown(*header.interval));
  }
  return {make_record(step, std::move(table.values), factor, "text columns")};
}

}  // namespace

const Format columns{recognises, read};

}  // namespace rockstack::records
