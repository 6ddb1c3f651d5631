#pragma once

#include "analytic/scene/ground/records/format.hpp"

namespace rockstack::records {

/// COSMOS strong-motion format 1.20 (V1 and V2 files): text lines, then counted blocks of integers, reals,
/// comments and data that name their own Fortran format, channel after channel. The time step is real header
/// value 62 (ms), or where that is null, value 34 (s). Unit and quantity come from the line above the data;
/// velocity and displacement are passed over. A sample that equals the file's null (-999) is refused.
extern const Format cosmos;

}  // namespace rockstack::records
