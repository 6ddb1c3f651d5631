#include "comparisons/studies/fit/fit.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <unsupported/Eigen/NonLinearOptimization>

#include "analytic/scene/input/toml_reader.hpp"
#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/runs/job.hpp"

namespace rockstack {
namespace {

using Values = std::vector<double>;
using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr double off = 10;  ///< residual of what has no motion, rad or m

/// The residuals as Eigen's method takes them: of the parameters as shares of their ranges.
struct Shares {
  using Scalar = double;
  using InputType = VectorXd;
  using ValueType = VectorXd;
  using JacobianType = MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const FittedScene& fitted;

  int inputs() const { return static_cast<int>(fitted.parameters().size()); }
  int values() const { return static_cast<int>(fitted.size()); }

  /// Beyond a range its end counts.
  Values at(const VectorXd& shares) const {
    Values list;
    for (const auto& [key, low, high] : fitted.parameters())
      list.push_back(low + (high - low) * std::clamp(shares[static_cast<Index>(list.size())], 0.0, 1.0));
    return list;
  }
  int operator()(const VectorXd& shares, VectorXd& residuals) const {
    residuals = fitted.residuals(at(shares));
    return 0;
  }
  int df(const VectorXd& shares, MatrixXd& jacobian) const {
    jacobian = fitted.derivatives(at(shares));
    for (Index k = 0; const auto& [key, low, high] : fitted.parameters()) jacobian.col(k++) *= high - low;
    return 0;
  }
};

struct Place {
  VectorXd shares;
  double sum = 0;  ///< of the squares of the residuals
};

/// The best places of a grid, the middles of equal parts of each range.
std::vector<Place> best_places(const Shares& shares) {
  constexpr double most_places = 200;
  constexpr std::size_t kept = 3;
  const std::vector<VariedKey>& parameters = shares.fitted.parameters();
  const auto along = std::ranges::count_if(parameters, std::not_fn(is_clock));
  const double each = std::floor(std::pow(most_places, 1.0 / static_cast<double>(along)) + 1e-9);
  const auto most_parts = static_cast<std::size_t>(std::clamp(each, 3.0, 40.0));
  std::size_t places = 1;
  for (std::ptrdiff_t k = 0; k < along; ++k) places *= most_parts;
  std::vector<Place> best;
  for (std::size_t number = 0; number < places; ++number) {
    Place place{VectorXd(shares.inputs())};
    std::size_t left = number;
    for (Index k = 0; k < shares.inputs(); ++k) {
      const std::size_t parts = is_clock(parameters[static_cast<std::size_t>(k)]) ? 1 : most_parts;
      place.shares[k] = (static_cast<double>(left % parts) + 0.5) / static_cast<double>(parts);
      left /= parts;
    }
    place.sum = shares.fitted.residuals(shares.at(place.shares)).squaredNorm();
    best.insert(std::ranges::find_if(best, [&](const Place& one) { return place.sum < one.sum; }), place);
    if (best.size() > kept) best.pop_back();
  }
  return best;
}

/// The place that the method comes to, begun anew for as long as that brings it nearer: impacts make
/// residuals bend, and its trust region shrinks at each bend.
Place refined(Shares shares, Place place) {
  for (double before = std::numeric_limits<double>::infinity(); place.sum < 0.9 * before;) {
    before = place.sum;
    Eigen::LevenbergMarquardt<Shares> method(shares);
    method.parameters.xtol = method.parameters.ftol = 1e-12;
    Place next = place;
    method.minimize(next.shares);
    next.sum = shares.fitted.residuals(shares.at(next.shares)).squaredNorm();
    if (next.sum < place.sum) place = next;
  }
  return place;
}

constexpr double untold = 1e-8;  ///< rad or m over a range, and of directions; differences are as good

/// How far each parameter may be off by the derivatives: infinite for what has a share in a direction that
/// moves nothing, NaN for what does not change the motion by itself, near what was found. `most`: by which a
/// direction may be off, rad or m.
Values half_widths(const FittedScene& fitted, const Values& values, double most) {
  MatrixXd jacobian = fitted.derivatives(values);
  VectorXd scales = jacobian.colwise().norm();
  for (Index k = 0; const auto& [key, low, high] : fitted.parameters()) {
    const bool moves = scales[k] * (high - low) > untold * std::sqrt(static_cast<double>(jacobian.rows()));
    jacobian.col(k) *= moves ? 1 / scales[k] : 0;
    if (!moves) scales[k] = std::numeric_limits<double>::quiet_NaN();
    ++k;
  }
  Values list;
  const Eigen::JacobiSVD<MatrixXd> svd(jacobian, Eigen::ComputeThinV);
  for (Index k = 0; k < jacobian.cols(); ++k) {
    double sum = 0;
    for (Index j = 0; j < jacobian.cols(); ++j) {
      const double share = svd.matrixV()(k, j), moved = svd.singularValues()[j];
      if (moved > untold)
        sum += share * share / (moved * moved);
      else if (std::abs(share) > 1e-3)
        sum = std::numeric_limits<double>::infinity();
    }
    list.push_back((std::isinf(sum) ? sum : most * std::sqrt(sum)) / scales[k]);
  }
  return list;
}

/// A parameter with its interval; the others stay as they were found. `most`: the sum of the squares of the
/// residuals up to which a value comes as near to the test.
FittedParameter with_interval(const FittedScene& fitted, Values values, std::size_t k, double half_width,
                              double most) {
  const VariedKey& parameter = fitted.parameters()[k];
  constexpr int parts = 40;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double found = values[k], part = (parameter.high - parameter.low) / parts;
  const auto at = [&](int place) {
    return std::lerp(parameter.low, parameter.high, static_cast<double>(std::clamp(place, 0, parts)) / parts);
  };
  int first = static_cast<int>(std::ceil((found - parameter.low) / part)), last = first - 1;
  for (int place = 0; place <= parts; ++place) {
    values[k] = at(place);
    if (fitted.residuals(values).squaredNorm() > most) continue;
    first = std::min(first, place);
    last = std::max(last, place);
  }
  const double lower = found - half_width, upper = found + half_width;
  if (at(first) >= lower && at(last) <= upper) return {parameter, found, lower, upper};
  if (first == 0 && last == parts) return {parameter, found, -infinity, infinity};
  return {parameter, found, at(first - 1), at(last + 1), true};
}

}  // namespace

FittedScene::FittedScene(const SceneDocument& document, const Measurement& measured,
                         const std::vector<VariedKey>& parameters, double horizon)
    : document_(document), measured_(measured), parameters_(parameters) {
  const std::size_t width = measured.columns.size();
  for (std::size_t i = 0; i < measured.times.size() && measured.times[i] <= horizon; ++i) {
    times_.push_back(measured.times[i]);
    for (std::size_t k = i * width; k < (i + 1) * width; ++k)
      if (!std::isnan(measured.values[k])) places_.push_back(k);
  }
  if (size() <= parameters.size())
    throw InputError(
        fmt::format("{}: must hold more readings than there are parameters up to {:.4g} s, where the "
                    "motion can be predicted",
                    measured.file, horizon));
}

Scene FittedScene::scene(const std::vector<double>& values) const {
  SceneDocument document = document_;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!is_clock(parameters_[k]))
      apply_override(document.root, fmt::format("{}={}", parameters_[k].key, values[k]));
  return make_scene(document, library_);
}

Values FittedScene::motion(const std::vector<double>& values) const {
  double late = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (is_clock(parameters_[k])) late = values[k];
  const Scene asked = scene(values);
  Values shifted{0};
  for (const double time : times_)
    if (time > late && time - late <= asked.duration) shifted.push_back(time - late);
  const History history = solve(asked, {.sample_times = shifted});
  const Values found = readings_of(measured_, asked, history, centres_of(asked, history));
  const std::size_t width = measured_.columns.size();
  Values list;
  for (std::size_t i = 0, row = 0; i < times_.size(); ++i) {
    if (times_[i] > late) row = std::min(row + 1, found.size() / width - 1);
    for (std::size_t k = row * width; k < (row + 1) * width; ++k) list.push_back(found[k]);
  }
  return list;
}

VectorXd FittedScene::residuals(const std::vector<double>& values) const {
  VectorXd list = VectorXd::Constant(static_cast<Index>(size()), off);
  Values found;
  try {
    found = motion(values);
  } catch (const std::exception&) {
    return list;
  }
  for (std::size_t i = 0; i < size(); ++i)
    list[static_cast<Index>(i)] = found[places_[i]] - measured_.values[places_[i]];
  return list;
}

MatrixXd FittedScene::derivatives(const std::vector<double>& values) const {
  constexpr double step = 1e-5;
  MatrixXd matrix(static_cast<Index>(size()), static_cast<Index>(values.size()));
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto& [key, low, high] = parameters_[k];
    Values below = values, above = values;
    below[k] = std::max(low, values[k] - step * (high - low));
    above[k] = std::min(high, values[k] + step * (high - low));
    matrix.col(static_cast<Index>(k)) = (residuals(above) - residuals(below)) / (above[k] - below[k]);
  }
  return matrix;
}

bool FittedParameter::at_end() const {
  const double margin = 1e-3 * (parameter.high - parameter.low);
  return value < parameter.low + margin || value > parameter.high - margin;
}

Fit fit(const SceneDocument& document, const Measurement& measured, std::vector<VariedKey> parameters) {
  constexpr double tolerance = 0.01;  // rad, as that of a suite
  constexpr double latest = 0.1;      // of the clock, as a share of the test's time
  const double most = latest * (measured.times.back() - measured.times.front());
  if (most > 0 && std::ranges::none_of(parameters, is_clock)) parameters.push_back({clock_key, -most, most});
  const FittedScene whole(document, measured, parameters, measured.times.back());
  const Shares over_all{whole};
  const Place guess = best_places(over_all).front();
  const Scene guessed =
      whole.scene(over_all.at(guess.shares));  // tells what is wrong where no place has a motion
  if (guess.sum >= off * off * static_cast<double>(whole.size()))
    throw InputError("--vary: must leave a motion somewhere in the ranges");
  Fit result;
  result.horizon =
      std::min(predictable_time(guessed, {.runs = horizon_scenes}, tolerance), measured.times.back());
  const FittedScene fitted(document, measured, parameters, result.horizon);
  const Shares shares{fitted};
  std::vector<Place> places = best_places(shares);
  for (Place& place : places) place = refined(shares, place);
  const Place& best = *std::ranges::min_element(places, {}, &Place::sum);
  const Values values = shares.at(best.shares);
  const VectorXd residuals = fitted.residuals(values);
  const Index count = residuals.size(), free = count - shares.inputs();
  result.readings = fitted.size();
  result.residual = residuals.norm() / std::sqrt(static_cast<double>(free));
  if (best.sum > 0) result.correlation = residuals.head(count - 1).dot(residuals.tail(count - 1)) / best.sum;
  result.rounding = result.residual < untold;
  const double reach = std::hypot(result.residual * reach_of_interval(static_cast<std::size_t>(free)),
                                  untold * std::sqrt(static_cast<double>(count)));
  for (const double half_width : half_widths(fitted, values, reach))
    result.parameters.push_back(
        with_interval(fitted, values, result.parameters.size(), half_width, best.sum + reach * reach));
  result.times = measured.times;
  result.motion = whole.motion(values);
  return result;
}

}  // namespace rockstack
