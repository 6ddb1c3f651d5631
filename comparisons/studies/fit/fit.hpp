#pragma once

#include <Eigen/Core>

#include "analytic/scene/input/json.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "comparisons/suites/measurement.hpp"
#include "comparisons/suites/varied_key.hpp"

namespace rockstack {

/// How late the test's clock is, s: by which its times are after those of the scene.
inline constexpr const char* clock_key = "clock";

/// A number that a test does not tell, and where it is looked for: of the scene, or clock_key.
inline bool is_clock(const VariedKey& parameter) {
  return parameter.key == clock_key;
}

/// The motion of a scene as a function of some of its numbers, in the place of what was measured of it.
class FittedScene {
 public:
  /// Up to `horizon`, s. @throws InputError where there are not more readings than parameters.
  FittedScene(const SceneDocument& document, const Measurement& measured,
              const std::vector<VariedKey>& parameters, double horizon);

  /// Readings up to the horizon, those that are missing left out.
  std::size_t size() const { return places_.size(); }
  /// With which values of the parameters. @throws InputError where they are out of range.
  Scene scene(const std::vector<double>& values) const;
  /// What the scene has in the place of readings, as Measurement::values: before its start its first, after a
  /// motion that ends early its last. @throws as solve().
  std::vector<double> motion(const std::vector<double>& values) const;
  /// The motion less what was measured, rad or m. What has no motion is off by 10.
  Eigen::VectorXd residuals(const std::vector<double>& values) const;
  /// Derivatives of the residuals by each parameter, a column each: central differences of the exact motion
  /// over a hundred-thousandth of its range on either side, one-sided at its ends.
  Eigen::MatrixXd derivatives(const std::vector<double>& values) const;

  const std::vector<VariedKey>& parameters() const { return parameters_; }
  const std::vector<double>& times() const { return times_; }         ///< up to the horizon, s
  const std::vector<std::size_t>& places() const { return places_; }  ///< of readings among all values

 private:
  const SceneDocument& document_;
  const Measurement& measured_;
  const std::vector<VariedKey>& parameters_;
  mutable MotionLibrary library_;
  std::vector<double> times_;
  std::vector<std::size_t> places_;
};

/// A parameter as it was found.
struct FittedParameter {
  VariedKey parameter;
  double value = 0;
  double lower = 0, upper = 0;  ///< of the confidence interval of 95 %; infinite where the test does not tell
  bool flat = false;            ///< whether that is of values that come as near to the test

  bool holds(double number) const { return lower < number && number < upper; }
  /// Whether it stands at an end of its range, to a thousandth of that.
  bool at_end() const;
};

/// What was found.
struct Fit {
  std::vector<FittedParameter> parameters;  ///< the clock last, unless it was asked for
  double horizon = 0;                       ///< up to which motion and test were compared, s
  std::size_t readings = 0;
  double residual = 0;                ///< root of the mean square, over readings less parameters, rad or m
  double correlation = 0;             ///< of neighbouring residuals
  bool rounding = false;              ///< whether the motion is the test's to rounding
  std::vector<double> times, motion;  ///< of the fitted scene at all measured times, as Measurement::values
};

/// Finds the parameters, and how late the clock is within a tenth of the test's time, by least squares up to
/// the horizon of predictability: a grid of their ranges, in the middle of the clock's, then Levenberg and
/// Marquardt's method (Eigen's MINPACK) from its three best places. The horizon is that of the
/// grid's best. Intervals are s² (JᵀJ)⁻¹ by Student's distribution, with s the residual and J the
/// derivatives, which holds for readings with independent errors alike in size, small enough for the motion
/// to be linear in the parameters. Where it is not, as with friction from which on nothing slips, values
/// beyond them may come as near: of the range in forty parts, those whose sum of squares is no more than
/// (ts)² above the least. Then the interval goes on to the first part on either side that does not.
/// @throws InputError as FittedScene, or where no place of the grid has a motion, with the reason of one.
Fit fit(const SceneDocument& document, const Measurement& measured, std::vector<VariedKey> parameters);

/// What the residual means, in sentences.
std::vector<std::string> meaning(const Fit& fit, const Measurement& measured);

Json fit_json(const std::string& title, const Measurement& measured, const Fit& fit,
              const std::string& command);

/// Writes FOLDER/fit.csv, what was measured beside the fitted motion, and FOLDER/fit.json.
void write_fit(const std::string& title, const Measurement& measured, const Fit& fit,
               const std::filesystem::path& folder, const std::string& command);

}  // namespace rockstack
