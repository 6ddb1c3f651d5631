#pragma once

#include "analytic/scene/ground/records/format.hpp"

namespace rockstack::records {

/// USGS SMC: 11 text lines, the first of which says what the file holds; 48 integers (value 16: comment
/// lines, value 17: samples); 50 reals (value 1: the null, value 2: samples a second); comments; samples in
/// cm/s², eight a line in ten columns each without blanks between. Velocity, displacement and spectra are
/// refused, and so are nulls.
extern const Format smc;

}  // namespace rockstack::records
