#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rockstack::records {

/// A quantity that columns hold. The first three are derivatives of the displacement, in falling order.
enum class Quantity { acceleration, velocity, displacement, time, frequency, angle };

/// Factor to SI units: m/s², m/s, m, s, Hz, rad.
struct Unit {
  double factor = 1;
  Quantity quantity = Quantity::acceleration;

  friend bool operator==(const Unit&, const Unit&) = default;
};

/// m/s², by definition (ISO 80000-3): what a "g" in a record means.
inline constexpr double standard_gravity = 9.80665;
/// m/s²; also called a gal.
inline constexpr double centimetre_per_second_squared = 0.01;

/// A unit as files spell it: products, quotients and powers of m, cm, mm, in, ft, s, ms, min and the like, as
/// "cm/s^2", "m s⁻²", "M/S**2", "in/sec/sec"; g, %g, mg, gal; Hz, deg. Letters may be capitals. None where
/// anything is left over or may mean two things, as in "m/s 2" and "m/s*s".
std::optional<Unit> read_unit(std::string_view text);

/// Whether a text begins with a symbol of a length or an acceleration as units do, though it may be none.
bool resembles_unit(std::string_view text);

/// The factor of a unit of acceleration to m/s², none of others.
std::optional<double> unit_factor(std::string_view name);

/// "acceleration", "velocity" …
std::string_view name(Quantity quantity);

/// "0.01 m/s²".
std::string text(const Unit& unit);

}  // namespace rockstack::records
