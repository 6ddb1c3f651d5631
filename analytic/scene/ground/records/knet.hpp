#pragma once

#include "analytic/scene/ground/records/format.hpp"

namespace rockstack::records {

/// K-NET and KiK-net ASCII: labelled header lines up to "Memo.", then counts of the recorder. Acceleration in
/// gal is count × "Scale Factor"; the recorder's offset is the mean of the record and is taken off, as the
/// network does for its "Max. Acc.". The number of samples is that of the duration.
extern const Format knet;

}  // namespace rockstack::records
