#pragma once

#include <string>

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// What the differences of a scene are made of: a sentence, and a row for each run with its contact model,
/// contact softness and time step; nothing where none is split.
std::string parts_table(const Comparison& comparison, const std::string& scene);

}  // namespace rockstack::plots
