#pragma once

#include "analytic/scene/ground/records/format.hpp"

namespace rockstack::records {

/// "Volume 2" files of CSMIP and, before it, Caltech and USC: 25 text lines, 100 integers and 100 reals a
/// channel, then blocks of acceleration, velocity and displacement, each under a line such as "15050 points
/// of accel data equally spaced at  .020 sec, in cm/sec2. (8f10.6)"; where that names no format it is
/// (8F10.3). Its time step is rounded to ms; real header value 61 has it in full and is taken where the two
/// agree. Channels end in "/&" lines. Velocity and displacement are passed over.
extern const Format volume2;

}  // namespace rockstack::records
