#include <cmath>
#include <optional>

#include "analytic/scene/ground/records/format.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack::records {
namespace {

constexpr std::size_t text_lines = 16;
constexpr std::size_t count_line = 10;  ///< of the text
constexpr std::size_t integer_count = 40;
constexpr std::size_t first_count = 33;  ///< of the integers: samples of acceleration, velocity, displacement
constexpr std::size_t real_count = 60;
constexpr std::size_t step_place = 25;  ///< of the reals, s
constexpr Columns ten_a_line{10, 8};
constexpr double millimetre_per_second_squared = 1e-3;

bool is_geonet(Cursor cursor) {
  for (std::size_t k = 1; k <= text_lines && !cursor.at_end(); ++k) {
    const std::string_view line = cursor.next({});
    if (k == count_line && !starts_with(line, "number of points")) return false;
    if (k == text_lines) return starts_with(line, "displacement");
  }
  return false;
}

/// A count among the integers of the header, which may be 0.
std::size_t whole(const Cursor& cursor, double value) {
  constexpr double most = 1e9;
  if (!(value >= 0) || value > most || value != std::floor(value))
    cursor.fail("the integers up to here give no count of samples (34th to 36th)");
  return static_cast<std::size_t>(value);
}

void read_component(Cursor& cursor, std::vector<Record>& series) {
  constexpr double half_millisecond = 0.5e-3 * (1 + 1e-9);
  std::optional<double> rounded;
  std::size_t rounded_line = 0;
  for (std::size_t k = 0; k < text_lines; ++k) {
    const std::string_view line = cursor.next("the 16 lines of text of a component");
    if (const std::string_view step = field_after(line, "at intervals of"); !step.empty()) {
      rounded = number(cursor, step);
      rounded_line = cursor.line_number();
    }
    const std::string_view unit = field_after(line, "units of");  // of raw readings
    if (!unit.empty() && number(cursor, unit) != 1) cursor.fail("units must be 1.00 mm/s/s");
  }
  const std::vector<double> header = read_columns(cursor, integer_count, ten_a_line);
  const std::size_t samples = whole(cursor, header[first_count]);
  const std::size_t passed[] = {whole(cursor, header[first_count + 1]),
                                whole(cursor, header[first_count + 2])};
  const double interval = checked_interval(cursor, read_columns(cursor, real_count, ten_a_line)[step_place]);
  if (rounded && std::abs(*rounded - interval) > half_millisecond)
    cursor.fail_at(rounded_line, "time step " + number_text(*rounded) + " s here, and " +
                                     number_text(interval) + " s in the reals below");
  if (samples == 0) cursor.fail("the header announces no samples of acceleration");
  series.push_back(make_record({interval}, read_columns(cursor, samples, ten_a_line),
                               {millimetre_per_second_squared}, "GeoNet"));
  for (const std::size_t count : passed) read_columns(cursor, count, ten_a_line);
  cursor.skip_blank();
}

}  // namespace

/// GeoNet of New Zealand, V1A (uncorrected) and V2A (corrected), after W. J. Cousins, GNS accelerogram data
/// files, 2008. Each of three components has 16 lines of text, 40 integers and 60 reals, then acceleration in
/// mm/s², velocity and displacement, ten values a line in eight columns each. Integers 34 to 36 are the
/// numbers of samples, real 26 is the time step. Velocity and displacement are passed over.
const Format geonet{is_geonet, read_component};

}  // namespace rockstack::records
