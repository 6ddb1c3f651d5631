#pragma once

#include "analytic/scene/ground/records/format.hpp"

namespace rockstack::records {

/// ASCII of the Engineering Strong-Motion database and of ITACA: "KEY: value" lines (64 in DYNA 1.2), then
/// one value a line. Used are DATA_TYPE, UNITS, SAMPLING_INTERVAL_S and NDATA.
extern const Format esm;

}  // namespace rockstack::records
