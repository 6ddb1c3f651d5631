#pragma once

#include "analytic/mechanics/dynamics.hpp"
#include "tests/analytic/paper/geometry.hpp"

namespace rockstack::paper {

/// The paper's two blocks as the solver takes them.
Model<double> model_of(const Geometry& q, double gravity, Equations equations);
Model<double> model_of(const Geometry& q, const Motion& s, Equations equations);

/// Sides of the pivots by sign, 0 for closed.
Pattern pattern_with(double base, double top);

/// Angles and rates of the paper, relative as the solver has them, exactly zero where closed.
State<double> state_of(const Pattern& pattern, const Motion& s);

}  // namespace rockstack::paper
