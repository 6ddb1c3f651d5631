#pragma once

#include "plots/gnuplot.hpp"
#include "plots/impact_laws/results.hpp"

namespace rockstack::plots {

/// Every engine run by the distances of its velocities from law paper's and from law consistent's.
Drawing law_engines(const LawResults& results);

}  // namespace rockstack::plots
