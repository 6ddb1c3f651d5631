#pragma once

#include "analytic/scene/ground/records/format.hpp"

namespace rockstack::records {

/// Plain text in columns, separated by blanks, commas or semicolons; beside semicolons a comma is a decimal
/// point. Lines that start with # % ! ; * / or a letter are header, which names the unit ("# units: m/s2", or
/// a column title such as "acceleration [g]"). Several columns are time (s) and a component each. Times must
/// have a constant step, up to 1 % of it where they are rounded; it is their mean step, and the record starts
/// at its first line whatever time that has. Without times the header, or a line "NPTS dt" above the numbers,
/// names the step ("# dt = 0.01", in s; also "time step", "interval", "sampling rate" in Hz); columns are
/// then components where a line of names stands above them, and else, five or more, one series that goes on
/// from line to line.
extern const Format columns;

}  // namespace rockstack::records
