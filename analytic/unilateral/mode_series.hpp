#pragma once

#include "analytic/polynomials/polynomial.hpp"
#include "analytic/steps/body_force.hpp"
#include "analytic/unilateral/contact_modes.hpp"

namespace rockstack {

using Series = Polynomial<double>;

/// A block's placement over a step, with the cosine and sine of its angle.
struct BodySeries {
  Series x, y, angle, cosine, sine;
};

/// A point over a face along a step: its place along the face and above the middle of the face's body, in
/// that body's frame, m.
struct FaceSeries {
  Series along, above;
};

/// What an interface carries over a step, in units of the step's own; see ContactForce.
struct ForceSeries {
  Series normal, tangential, moment;
};

/// The motion in one mode as Taylor series in s, the share of the step: 0 ≤ s ≤ 1.
///
/// Gaps that are held stay zero: each order of the accelerations and forces solves the same linear equations,
/// those of respond(), with what lower orders add to forces and gaps on their right side.
struct ModeSeries {
  double length = 0;      ///< s
  double force_unit = 0;  ///< of the series of forces, N; that of moments is N·m
  std::vector<BodySeries> bodies;
  std::vector<ForceSeries> forces;
  std::vector<FaceSeries> held;  ///< of held points; empty where apart

  Bodies at(double s) const;
};

/// The series over `length`, or less of it where they would leave out more than rounding. `lengthens` tells
/// whether they reached that early.
struct ModeStep {
  ModeSeries series;
  bool lengthens;
};
ModeStep mode_step(const FrictionStack& stack, const std::vector<Joint>& joints, const Bodies& bodies,
                   const ScaledBodyForce<double>& body_force, double length);

/// Any corner over any face along a step.
FaceSeries corner_series(const std::vector<Block>& blocks, const ModeSeries& series,
                         const CornerOnFace& corner);

Series product(const Series& first, const Series& second);

}  // namespace rockstack
