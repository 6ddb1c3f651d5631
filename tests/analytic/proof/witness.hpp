#pragma once

#include <nlohmann/json.hpp>

#include "tests/analytic/proof/accumulation.hpp"

namespace rockstack::proof {

/// One inference of a proof, with all that had to be searched for: what remains is to check inequalities.
/// Numbers are exact texts, "mantissa*2^exponent"; interfaces count from 1.
using Witness = nlohmann::ordered_json;

/// A stretch of smooth motion: the disc, the reaches on it, and cells in which each guard is positive; with
/// an event also the interval in which its guard falls through zero.
Witness step_witness(const Step& step, const std::vector<ZeroSearch>& searches, const Watched* first,
                     const Ball& time);
/// The pattern after an impact, or after what opens at once, and what each other one violates.
Witness decision_witness(const char* kind, std::size_t interface, const Decision& decision);
/// The box of an accumulation.
Witness accumulation_witness(std::size_t interface, const Accumulation& accumulation);

}  // namespace rockstack::proof
