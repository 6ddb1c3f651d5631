#pragma once

#include "plots/data/results.hpp"
#include "plots/drawing/gnuplot.hpp"

namespace rockstack::plots {

/// Angles over time, a panel a block, with the exact impacts and the exact pattern.
Drawing histories(const Comparison& comparison, const ComparedScene& scene);

/// Absolute angle differences over time, a panel a block, with the tolerance and the end of agreement.
Drawing differences(const Comparison& comparison, const ComparedScene& scene);

/// Time differences of matched impacts by number; missed and extra ones in rows of their own.
Drawing impact_times(const Comparison& comparison, const ComparedScene& scene);

/// The full equations beside the linear ones, a panel a block. Precondition: the scene has runs of both.
Drawing equations(const Comparison& comparison, const ComparedScene& scene);

/// Angle against angular velocity, a panel a block.
Drawing phase(const Comparison& comparison, const ComparedScene& scene);

/// Energy over time, the exact staircase beside engines, and how far they are from it.
Drawing energy(const Comparison& comparison, const ComparedScene& scene);

/// The energy that each impact loses, exact and in engines. Precondition: the ground does not move.
Drawing impact_energy(const Comparison& comparison, const ComparedScene& scene);

/// The share of time spent in each pattern.
Drawing occupancy(const Comparison& comparison, const ComparedScene& scene);

/// RMS angle difference against stepping time, a line over time steps for each engine, solver and settings.
Drawing error_time(const Comparison& comparison, const ComparedScene& scene);

/// RMS angle difference against time step, with the fitted curves and the model errors that they fall to.
Drawing error_step(const Comparison& comparison, const ComparedScene& scene);

/// The same of the first impact's time difference.
Drawing first_impact_step(const Comparison& comparison, const ComparedScene& scene);

/// Shares of perturbed scenes at or below each value of a quantity, a panel each: the exact solution's and
/// the engines'. Precondition: the scene has such distributions.
Drawing distributions(const Comparison& comparison, const ComparedScene& scene);

/// Shares of perturbed scenes that topple, with bounds. Precondition: likewise.
Drawing toppling(const Comparison& comparison, const ComparedScene& scene);

/// RMS angle differences by rank, a column a time step, with quartiles and ranges over draws.
Drawing ranking(const Comparison& comparison, const ComparedScene& scene);

/// The parts of each difference: contact model, contact softness, time step. Precondition: the scene is
/// split.
Drawing split_parts(const Comparison& comparison, const ComparedScene& scene);

/// The ground's acceleration, a panel for each axis that moves. Precondition: the scene has a ground motion.
Drawing ground_motion(const Comparison& comparison, const ComparedScene& scene);

}  // namespace rockstack::plots
