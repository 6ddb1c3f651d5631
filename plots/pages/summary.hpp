#pragma once

#include <string>
#include <vector>

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// What the whole comparison comes to, one sentence an entry, as plain text.
std::vector<std::string> summary(const Comparison& comparison);

/// What the runs of one scene come to.
/// @throws InputError naming a file of the exact run that is missing or malformed.
std::vector<std::string> summary(const Comparison& comparison, const ComparedScene& scene);

}  // namespace rockstack::plots
