#pragma once

#include "analytic/scene/ground/records/text.hpp"

namespace rockstack::records {

/// m/s², by definition (ISO 80000-3): what a "g" in a record means.
inline constexpr double standard_gravity = 9.80665;
/// m/s²; also called a gal.
inline constexpr double centimetre_per_second_squared = 0.01;

/// Factor to m/s² of a unit of acceleration as files spell it: g, gal, cm/s2, cm/sec/sec, m/s^2 …; none for
/// others.
std::optional<double> unit_factor(std::string_view name);

/// Factor to m/s² of the unit that a line of free text names: after "units" or "acceleration" ("IN UNITS OF
/// G", "units are (g)"), or else alone in brackets ("t [s], a [m/s2]").
std::optional<double> find_unit(std::string_view line);

/// The one unit that the lines of a header name.
class HeaderUnit {
 public:
  /// @throws InputError at a line that names another unit than one before it.
  void read(const Cursor& cursor, std::string_view line);
  /// @throws InputError at the cursor's line if no line named a unit.
  double factor(const Cursor& cursor) const;

 private:
  std::optional<double> factor_;
  std::size_t line_ = 0;
};

}  // namespace rockstack::records
