#pragma once

#include "plots/data/results.hpp"
#include "plots/drawing/gnuplot.hpp"

namespace rockstack::plots {

/// How far each block has slipped along what is below it, and its distance from it, over time.
/// Precondition: a run of the scene tells slips.
Drawing slip(const Comparison& comparison, const ComparedScene& scene);

/// Angles and slips of the exact solver at several coefficients of friction, beside its scene's law.
/// Precondition: the scene has runs of other friction.
Drawing friction(const Comparison& comparison, const ComparedScene& scene);

}  // namespace rockstack::plots
