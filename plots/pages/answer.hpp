#pragma once

#include <string>
#include <vector>

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// What a comparison answers, the shortest answer first, as plain sentences with their numbers: which solver
/// and settings are nearest and furthest at one step, what all runs come to, orders of convergence where they
/// were fitted, shares that topple where scenes were perturbed. Empty where nothing was held against an exact
/// motion.
std::vector<std::string> answer(const Comparison& comparison);

}  // namespace rockstack::plots
