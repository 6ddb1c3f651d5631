#pragma once

#include <ostream>

#include "tests/analytic/proof/prover.hpp"

namespace rockstack::proof {

/// Writes events as CSV: event, interface, patterns before and after, and bounds of the time in s and of
/// absolute angles in rad, with 30 decimals. An accumulation is a "closure", or a "rest" where all interfaces
/// are closed after it. Impacts less than a microsecond before the accumulation that they lead to are left
/// out.
void write_table(std::ostream& output, const Proof& proof);

}  // namespace rockstack::proof
