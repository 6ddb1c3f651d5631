#include "analytic/scene/ground/records/contents.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "analytic/scene/ground/records/vocabulary.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack::records {
namespace {

constexpr double step_tolerance = 0.01;

bool rises(const std::vector<double>& values) {
  return std::is_sorted(values.begin(), values.end(), std::less_equal<>());
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

/// Refuses times that leave a gap, or go back: a step that is not half to twice the usual one.
void check_gaps(const RecordTable& table, const std::vector<double>& times) {
  std::vector<double> steps(times.size());
  std::adjacent_difference(times.begin(), times.end(), steps.begin());
  std::vector<double> sorted(steps.begin() + 1, steps.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  for (std::size_t k = 1; k < times.size(); ++k)
    if (!(steps[k] > *middle / 2 && steps[k] < 2 * *middle))
      table.cursor.fail_at(table.lines[k], "time " + number_text(times[k]) + " after " +
                                               number_text(times[k - 1]) + ", where most steps are " +
                                               number_text(*middle, 6) + ": must have a constant step");
}

/// Half a unit in the last place of the decimals that a column has at most; 0 where a number has a power of
/// ten.
double rounding_of(const RecordTable& table, std::size_t column) {
  std::size_t decimals = 0;
  for (const auto& row : table.rows) {
    if (row.size() <= column) break;
    if (row[column].find_first_of("eEdD:") != std::string_view::npos) return 0;
    const std::size_t point = row[column].find_first_of(table.dialect.decimal_comma ? ".," : ".");
    if (point != std::string_view::npos) decimals = std::max(decimals, row[column].size() - point - 1);
  }
  return 0.5 * std::pow(10, -static_cast<double>(decimals));
}

/// The mean step, which all others must equal but for their rounding. `times` and `rounding` in s.
double constant_step(const RecordTable& table, const std::vector<double>& times, double rounding) {
  const Cursor& cursor = table.cursor;
  if (times.size() < 2) cursor.fail_at(table.lines.front(), "one time alone gives no time step");
  const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  checked_interval(cursor.at_line(table.lines.back()), step);
  check_gaps(table, times);
  // The mean step has a rounding of its own. Beyond a tenth of a step roundings tell nothing of steps.
  const double tolerance = std::max(step_tolerance, std::min(2 * rounding / step, 0.2)) * step;
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double expected = times.front() + static_cast<double>(k) * step;
    if (std::abs(times[k] - expected) > tolerance)
      cursor.fail_at(table.lines[k], "time " + number_text(times[k]) + " where a constant step gives " +
                                         number_text(expected));
  }
  return step;
}

Unit unit_of_column(const RecordTable& table, const Header& header, std::size_t column) {
  const Title& title = table.titles[column];
  const Unit unit = title.unit ? *title.unit : stated_unit(table, header);
  const Stated& stated = header.acceleration;
  if (unit.quantity == Quantity::acceleration && stated.unit && stated.contradicted == 0 &&
      *stated.unit != unit)
    table.cursor.fail_at(stated.line,
                         "names another unit of acceleration than the title of " + table.column_name(column));
  if (title.quantity && unit.quantity != *title.quantity)
    table.cursor.fail_at(table.title_line, table.column_name(column) + " has no unit of " +
                                               std::string(name(*title.quantity)) +
                                               (title.unit ? "" : ", nor has the header") +
                                               ": say e.g. \"units: m/s2\", or (m/s2) in its title");
  return unit;
}

[[noreturn]] void fail_unknown(const RecordTable& table, std::size_t column) {
  table.cursor.fail_at(table.title_line,
                       table.column_name(column) + ": " + in_quotes(table.titles[column].unknown_unit) +
                           " is no unit of acceleration: must be e.g. m/s2, cm/s2, gal or g");
}

/// Whether a title without a quantity and a unit may name a channel: a short one, a direction, a sensor.
bool may_name_channel(const Title& title) {
  constexpr std::size_t longest = 3;  // letters
  const std::string plain = folded(title.name);
  return std::ranges::all_of(words_in(plain), [](std::string_view word) {
    return word.size() <= longest || is_of(word, Topic::channel) || is_of(word, Topic::history);
  });
}

/// Columns of the highest derivative that titles name; else those that no title says to be something else.
std::vector<std::size_t> titled_series(const RecordTable& table, const std::optional<std::size_t>& time) {
  const auto those = [&](std::optional<Quantity> quantity) {
    std::vector<std::size_t> list;
    for (std::size_t k = 0; k < table.columns(); ++k) {
      const Title& title = table.titles[k];
      if (k != time && title.quantity == quantity && !title.counts && !title.other) list.push_back(k);
    }
    return list;
  };
  for (const Quantity quantity : {Quantity::acceleration, Quantity::velocity, Quantity::displacement})
    if (auto list = those(quantity); !list.empty()) return list;
  return those(std::nullopt);
}

/// In s: that of the title, or else of the header; of times of day 1.
double unit_of_times(const RecordTable& table, std::size_t time) {
  if (!table.titles.empty() && table.titles[time].unit) return table.titles[time].unit->factor;
  if (table.rows.front()[time].find(':') != std::string_view::npos) return 1;
  const auto unit = unit_in_header(table, Topic::time, Quantity::time);
  return unit ? unit->factor : 1;
}

/// Refuses a factor in a title: whether the numbers are multiplied by it is not said.
void check_unscaled(const RecordTable& table, std::size_t column) {
  if (table.titles[column].scaled)
    table.cursor.fail_at(table.title_line,
                         table.column_name(column) +
                             ", names a factor, or numbers that are normalised: a factor must be "
                             "applied to them and taken out of the title");
}

}  // namespace

bool counts(const std::vector<double>& values) {
  for (std::size_t k = 1; k < values.size(); ++k)
    if (values[k] != values[k - 1] + 1) return false;
  return true;
}

bool rises_evenly(const std::vector<double>& values) {
  if (values.size() < 3) return false;
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  for (std::size_t k = 1; k < values.size(); ++k)
    if (!(std::abs(values[k] - values.front() - static_cast<double>(k) * step) <= step_tolerance * step))
      return false;
  return step > 0;
}

std::optional<std::size_t> time_column(const RecordTable& table, const Header& header) {
  std::optional<std::size_t> time;
  for (std::size_t k = 0; k < table.titles.size(); ++k) {
    if (table.titles[k].quantity != Quantity::time) continue;
    if (time)
      table.cursor.fail_at(table.title_line, table.column_name(*time) + ", and " + table.column_name(k) +
                                                 ", are both times: leave one out");
    time = k;
  }
  if (time) {
    const Title& title = table.titles[*time];
    const bool clock = table.rows.front()[*time].find(':') != std::string_view::npos;
    if (clock || (title.unknown_unit.empty() && (!title.unit || title.unit->quantity == Quantity::time)))
      return time;
    table.cursor.fail_at(table.title_line,
                         table.column_name(*time) + ": its unit is no unit of time: must be s, ms or min");
  }
  if (!table.titles.empty()) return std::nullopt;
  if (table.columns() < 2 || table.rows.size() < (table.columns() > 2 ? 3U : 1U)) return std::nullopt;
  const std::vector<double> first = table.column(0);
  const bool numbers = header.interval && counts(first) && *header.interval != 1;
  if (table.columns() == 2 && !header.interval) return 0;
  return rises(first) && !numbers ? std::optional<std::size_t>(0) : std::nullopt;
}

Interval step_of(const Header& header) {
  return {*header.interval, "line " + std::to_string(header.interval_line)};
}

Interval interval_of(const RecordTable& table, const Header& header, const std::optional<std::size_t>& time) {
  if (!time) {
    if (header.interval && header.resampled_line != 0)
      table.cursor.fail_at(
          header.resampled_line,
          "says that samples were left out, averaged or interpolated: the step of the numbers "
          "below must be said alone");
    if (header.interval) return step_of(header);
    const std::size_t columns = table.columns();
    table.cursor.fail_at(
        table.lines.front(),
        (columns == 1 ? "one column"
                      : std::to_string(columns) + " columns, none of them times" +
                            (table.titles.empty() ? "" : " by its title, as \"time (s)\" is")) +
            std::string(", and no time step in the header: say e.g. \"# dt = 0.01\" (s)"));
  }
  const double unit = unit_of_times(table, *time), rounding = unit * rounding_of(table, *time);
  const double step = constant_step(table, scaled(table.column(*time), unit), rounding);
  // What roundings hide of the step, the header may know.
  if (header.interval && rounding > step_tolerance * step &&
      std::abs(step - *header.interval) <= 2 * rounding / static_cast<double>(table.rows.size() - 1))
    return step_of(header);
  if (header.interval && std::abs(step - *header.interval) > step_tolerance * step)
    table.cursor.fail_at(header.interval_line, "dt = " + number_text(*header.interval) +
                                                   " s here, and times step by " + number_text(step) + " s");
  return {step, table.column_name(*time)};
}

Content titled_content(const RecordTable& table, const Header& header) {
  for (std::size_t k = 0; k < table.columns(); ++k)
    if (table.titles[k].spectral)
      table.cursor.fail_at(table.title_line,
                           table.column_name(k) + ": a spectrum is no record: must be a history in time");
  const auto time = time_column(table, header);
  Content content{{}, titled_series(table, time), {}};
  if (content.columns.empty())
    table.cursor.fail_at(table.title_line,
                         "no column is an acceleration, velocity or displacement by its title");
  if (time) check_unscaled(table, *time);
  for (const std::size_t column : content.columns) {
    check_unscaled(table, column);
    const Title& title = table.titles[column];
    if (!title.quantity && title.unknown_unit.empty() && !may_name_channel(title))
      table.cursor.fail_at(
          table.title_line,
          table.column_name(column) + ": whether this is an acceleration must be said in the title");
    if (!table.titles[column].unknown_unit.empty() && !table.titles[column].unit) fail_unknown(table, column);
    content.units.push_back(unit_of_column(table, header, column));
  }
  content.interval = interval_of(table, header, time);
  return content;
}

Content plain_content(const RecordTable& table, const Header& header) {
  const Unit unit = stated_unit(table, header);
  const auto time = time_column(table, header);
  Content content{interval_of(table, header, time), {}, {}};
  const bool numbered = !time && table.columns() > 1 && counts(table.column(0));
  for (std::size_t k = time || numbered ? 1 : 0; k < table.columns(); ++k) content.columns.push_back(k);
  content.units.assign(content.columns.size(), unit);
  for (const std::size_t column : content.columns)
    if (time && table.column(column) == table.column(*time))
      table.cursor.fail_at(table.lines.front(),
                           table.column_name(column) +
                               " has the times of column 1 again: a line of titles must say what "
                               "the columns are");
  if (content.columns.size() > 1 && header.mixed_line != 0)
    table.cursor.fail_at(
        header.mixed_line,
        "names an acceleration and a velocity or displacement, and is no line of titles: one "
        "above the numbers, parted as they are, must say which columns have which");
  return content;
}

}  // namespace rockstack::records
