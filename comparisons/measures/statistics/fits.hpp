#pragma once

#include "comparisons/measures/results/run_metrics.hpp"

namespace rockstack {

/// The error of a run at one time step.
struct StepError {
  double step = 0;   ///< s, > 0
  double error = 0;  ///< > 0, in any unit
};

/// An estimate with its 95 % confidence bounds.
struct Bounded {
  double value = 0, low = 0, high = 0;
};

/// error(dt) = model_error + c·dtᵖ, which tells the error of taking steps from the difference between two
/// models that no step closes.
///
/// The fit is the one of least squares of ln error, so that every step counts by its relative deviation:
/// over model_error ≥ 0, c > 0 and p between 0.1 and 6. Bounds are those of the profile: all values with
/// which the others can still bring the sum of squares S to at most S_min (1 + t²/ν), ν = points − 3 and t
/// the 97.5 % point of Student's distribution (Bates & Watts, "Nonlinear regression analysis and its
/// applications", 1988, chapter 6).
struct StepFit {
  std::size_t points = 0;
  Bounded model_error;     ///< in the error's unit; may be 0
  Bounded order;           ///< p
  double coefficient = 0;  ///< c, in the error's unit at a step of 1 s
  double scatter = 0;      ///< √(S_min/ν): the errors' typical relative deviation from the curve, in ln
  /// Why the fit does not hold; empty where it does. In this order: fewer than 5 steps; a scatter above
  /// ln 3; errors that do not fall with the step (a constant is within the bounds of S too); an order that
  /// is bounded by the range of the search alone.
  std::string reason;

  bool holds() const { return reason.empty(); }
};

/// Fits errors at different steps. Errors that are not finite or not above zero are left out.
StepFit fit_steps(std::vector<StepError> errors);

/// The errors of one engine, solver and parameter set on one scene, fitted over its time steps.
struct SeriesFit {
  std::string scene, engine, solver, settings;
  std::string quantity;  ///< the column whose absolute value is the error
  StepFit fit;
};

/// Fits rms_angle_difference and first_impact_time_difference of every series that was asked for at five time
/// steps or more, in the order of the rows; steps whose runs are not done or lack the column are left out.
std::vector<SeriesFit> fit_runs(const std::vector<RunMetrics>& rows);

/// With scene, engine, solver, settings, quantity, steps, gap, gap_low, gap_high, order, order_low,
/// order_high, coefficient, scatter, holds and reason, numbers as null where there is no fit at all; and
/// back.
void to_json(Json& json, const SeriesFit& fit);
void from_json(const Json& json, SeriesFit& fit);

/// What is fitted and how, in one sentence each.
inline constexpr const char* fit_definition =
    "error(dt) = gap + coefficient · dt^order, gap being the model error that no step takes away, by "
    "least squares of ln error, gap ≥ 0 and order from 0.1 to 6; low and high are 95 % bounds of the "
    "profile of the sum of squares; scatter is the root of the mean square deviation in ln error. A fit "
    "holds with at least five steps, a scatter of at most ln 3, errors that fall with the step, and an "
    "order that is bounded.";

}  // namespace rockstack
