#pragma once

#include <utility>

#include "analytic/scene/ground/records/record.hpp"
#include "analytic/scene/ground/records/text.hpp"

namespace rockstack::records {

/// A layout of record files. `recognises` starts at the first line; `read` goes on until the end of the file,
/// or of a channel that others may follow.
struct Format {
  bool (*recognises)(Cursor cursor);
  void (*read)(Cursor& cursor, std::vector<Record>& series);
};

extern const Format knet, esm, cosmos, smc, geonet, volume2, peer, plain_columns;

/// The names of all layouts, for messages.
inline constexpr std::string_view known_formats =
    "PEER AT2, COSMOS, CSMIP volume 2, USGS SMC, ESM, K-NET/KiK-net, GeoNet, columns of numbers";

/// Samples times a factor to m/s².
inline Record make_record(double interval, std::vector<double> samples, double factor, std::string format) {
  for (double& sample : samples) sample *= factor;
  return {interval, std::move(samples), std::move(format)};
}

/// m/s², by definition (ISO 80000-3): what a "g" in a record means.
inline constexpr double standard_gravity = 9.80665;
/// m/s²; also called a gal.
inline constexpr double centimetre_per_second_squared = 0.01;

/// A unit that samples of a ground motion have.
struct Unit {
  double factor = 1;    ///< to m/s², m/s or m
  int derivatives = 0;  ///< by which the samples become an acceleration: of a velocity 1, of a displacement 2

  friend bool operator==(const Unit&, const Unit&) = default;
};

/// Factor to m/s² of a unit of acceleration as files spell it, as gal, cm/sec/sec or m/s^2; none of others.
std::optional<double> unit_factor(std::string_view name);

/// The unit that a line of free text names. One of acceleration stands after "units" or "acceleration" ("IN
/// UNITS OF G", "units are (g)"), or else alone in brackets ("t [s], a [m/s2]"); one of velocity or
/// displacement (m/s, cm/s, mm/s, m, cm, mm) after "units", or in brackets beside a time in such ("t [s], x
/// [mm]"), as other lengths of a header are in brackets too.
std::optional<Unit> find_unit(std::string_view line);

/// The one unit that a header names. Where it names one of acceleration, others are of something else.
class HeaderUnit {
 public:
  /// @throws InputError at a line that names another unit than one before it.
  void read(const Cursor& cursor, std::string_view line);
  /// Of an acceleration. @throws InputError at the cursor's line if no line named one.
  double factor(const Cursor& cursor) const;
  /// @throws InputError likewise, where none of velocity or displacement was named either.
  Unit unit(const Cursor& cursor) const {
    return other_ && !acceleration_ ? other_->unit : Unit{factor(cursor), 0};
  }

 private:
  struct Named {
    Unit unit;
    std::size_t line = 0;
  };
  std::optional<Named> acceleration_, other_;
};

/// The acceleration, linear in pieces, whose integral from v[0] on passes through every sample of a velocity:
/// its knots lie at the middles between samples (a quadratic spline, Subbotin 1967), and so it is given at
/// half the interval. Exact where the acceleration is a straight line; else it differs by O(interval²). An
/// error δ of the samples makes one of up to 4δ/interval. What is lost is what samples do not show: motion
/// above half the sampling rate. Beyond its ends the acceleration is mirrored. Precondition: two samples.
Record acceleration_of_velocity(double interval, const std::vector<double>& velocities);

/// The same of a displacement: the second derivative of the cubic spline through its samples, at rest at the
/// first and the last. An error δ of the samples makes one of up to 12δ/interval²: a displacement that is
/// known to 0.01 mm each 10 ms gives an acceleration to 1.2 m/s². Precondition: two samples.
Record acceleration_of_displacement(double interval, const std::vector<double>& displacements);

}  // namespace rockstack::records
