#pragma once

#include "analytic/scene/ground/records/format.hpp"

namespace rockstack::records {

/// Plain text: one column (acceleration) or two (time in s, acceleration), separated by blanks or commas.
/// Lines that start with # % ! ; * / or a letter are header. It must name the unit ("# units: m/s2", or a
/// column title such as "acceleration [g]"), and for one column the time step ("# dt = 0.01", in s; also
/// "time step", "interval"). Two columns must have a constant step, up to 1 % of it for rounded times; it is
/// their mean step, and the record starts at its first line whatever time that has.
extern const Format columns;

}  // namespace rockstack::records
