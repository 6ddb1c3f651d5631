#pragma once

#include "analytic/scene/ground/records/record.hpp"
#include "analytic/scene/ground/records/text.hpp"
#include "analytic/scene/ground/records/units.hpp"

namespace rockstack::records {

/// A time step, and where it was found.
struct Interval {
  double length = 0;  ///< s
  std::string place = "the header";
};

/// A layout of record files. `recognises` starts at the first line; `read` goes on until the end of the file,
/// or of a channel that others may follow.
struct Format {
  bool (*recognises)(Cursor cursor);
  void (*read)(Cursor& cursor, std::vector<Record>& series);
};

extern const Format knet, esm, cosmos, smc, geonet, volume2, obspy, columns;

/// The names of all layouts, for messages.
inline constexpr std::string_view known_formats =
    "PEER AT2, COSMOS, CSMIP volume 2, USGS SMC, ESM, K-NET/KiK-net, GeoNet, ObsPy, columns of numbers";

/// Samples of that unit, in SI units.
Record make_record(const Interval& interval, std::vector<double> samples, const Unit& unit,
                   std::string format);

/// The acceleration, linear in pieces, whose integral from v[0] on passes through every sample of a velocity:
/// its knots lie at the middles between samples (a quadratic spline, Subbotin 1967), and so it is given at
/// half the interval. Exact where the acceleration is a straight line; else it differs by O(interval²). An
/// error δ of the samples makes one of up to 4δ/interval. What is lost is what samples do not show: motion
/// above half the sampling rate. Beyond its ends the acceleration is mirrored. Precondition: two samples.
Record acceleration_of_velocity(double interval, const std::vector<double>& velocities);

/// Second derivative of a displacement: that of the cubic spline through its samples, at rest at the
/// first and the last. An error δ of the samples makes one of up to 12δ/interval²: a displacement that is
/// known to 0.01 mm each 10 ms gives an acceleration to 1.2 m/s². Precondition: two samples.
Record acceleration_of_displacement(double interval, const std::vector<double>& displacements);

}  // namespace rockstack::records
