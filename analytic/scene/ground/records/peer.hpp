#pragma once

#include "analytic/scene/ground/records/format.hpp"

namespace rockstack::records {

/// PEER AT2 and files like it: any number of header lines up to one that names NPTS and DT, then values in
/// free layout. The unit must be named in the header ("UNITS OF G"), g being 9.80665 m/s². NGA files exist
/// whose last line is filled up with one value more than NPTS, and others that lack one: a surplus value is
/// dropped, a missing one shortens the record; any larger difference is refused.
extern const Format peer;

}  // namespace rockstack::records
