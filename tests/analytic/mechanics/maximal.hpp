#pragma once

#include <Eigen/Dense>

#include "analytic/mechanics/pattern_solution.hpp"

namespace rockstack::testing {

// The stack in maximal coordinates: every block has its own x, y and θ, and pivots are constraint equations
// with a force each. Nothing of the solver's chain is used. All in long double.
//
//     [ M  −Gᵀ ] [ a ]   [ M f ]     f: what the blocks would do without constraints
//     [ G   0  ] [ λ ] = [  c  ]     c: the constraints' own velocity terms

using Number = long double;
using Dense = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
using Column = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

/// The first of a block's three entries.
inline Eigen::Index row(int block) {
  return 3 * static_cast<Eigen::Index>(block);
}

/// Places of the blocks' centres, and per interface the arms from the centres below and above it to its
/// pivot.
struct Placement {
  std::vector<Point<Number>> centres, below, above;
  std::vector<Number> angles;
};

Placement place(const Model<Number>& model, const Pattern& pattern, const Vector<Number>& relative_angles);

/// Centre velocities (x, y) and absolute angular velocities, three entries a block.
Column velocities(const Placement& placement, const Vector<Number>& relative_velocities);

/// What the constrained stack does.
struct Solution {
  Column motion;            ///< (ẍ, ÿ, θ̈) or (ẋ, ẏ, θ̇) a block
  Vector<Number> relative;  ///< of interfaces
  Points<Number> force;     ///< at each pivot on the block above
  Vector<Number> moment;    ///< at each closed interface about its middle, clockwise
};

/// `pushed`: what pushes alone make of free blocks; empty where there are none.
Solution accelerate(const Model<Number>& model, const State<Number>& state, const Point<Number>& ground,
                    const Column& pushed = {});

/// The velocities after an impact that leads to `pattern`, from those before.
Solution strike(const Model<Number>& model, const State<Number>& before, const Pattern& pattern,
                const Column& pushed = {});

/// Angular momentum of the blocks from `interface` up about its pivot, clockwise.
Number angular_momentum(const Model<Number>& model, const Placement& placement, const Column& motion,
                        int interface);

Number kinetic_energy(const Model<Number>& model, const Column& motion);

}  // namespace rockstack::testing
