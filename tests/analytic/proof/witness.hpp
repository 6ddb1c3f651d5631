#pragma once

#include <nlohmann/json.hpp>

#include "tests/analytic/proof/accumulation.hpp"

namespace rockstack::proof {

/// One inference of a proof, with all that had to be searched for: what remains is to check inequalities.
/// Numbers are exact texts, "mantissa*2^exponent"; interfaces count from 1.
using Witness = nlohmann::ordered_json;

/// A stretch of smooth motion without an event: the disc, the reaches on it, the length where it does not end
/// with the ground's piece, and inner ends of cells in each of which a guard is positive, where one cell is
/// not enough.
Witness step_witness(const Step& step, const std::vector<ZeroSearch>& searches, bool ends_piece);
/// A stretch up to an event, with the interval in which its guard falls through zero.
Witness event_witness(const Step& step, const std::vector<ZeroSearch>& searches, const Watched& first,
                      const Ball& time);
/// The pattern after an impact, or after what opens at once, and what each other one violates.
Witness decision_witness(const char* kind, std::size_t interface, const Decision& decision);
/// The box of an accumulation.
Witness accumulation_witness(std::size_t interface, const Accumulation& accumulation);

}  // namespace rockstack::proof
