#pragma once

#include "plots/data/law_results.hpp"
#include "plots/drawing/gnuplot.hpp"

namespace rockstack::plots {

/// Every engine run by the distances of its velocities from law paper's and from law consistent's.
Drawing law_engines(const LawResults& results);

}  // namespace rockstack::plots
