#include "comparisons/measures/statistics/fits.hpp"

#include <fmt/format.h>

#include <boost/math/tools/minima.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <tuple>

#include "analytic/scene/lists.hpp"
#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {
namespace {

/// Columns whose absolute values are errors.
constexpr std::array quantities{"rms_angle_difference", "first_impact_time_difference"};

/// Rows that differ in their time step alone.
using Series = std::vector<const RunMetrics*>;

std::vector<Series> series_of(const std::vector<RunMetrics>& rows) {
  const auto key = [](const RunMetrics& row) {
    return std::tie(row.scene, row.engine, row.solver, row.settings);
  };
  std::vector<Series> list;
  for (const RunMetrics& row : rows) {
    if (!row.dt) continue;
    const auto same = [&](const Series& one) { return key(*one.front()) == key(row); };
    found_or_added(list, same, {}).push_back(&row);
  }
  return list;
}

constexpr double least_order = 0.1, most_order = 6;
constexpr std::size_t least_steps = 5, parameters = 3;

struct Range {
  double low, high;
};

/// A place in the search and the sum of squares there.
struct Found {
  double x = 0, y = 0, sum = HUGE_VAL;
};

/// The least value of f(x, y) in a box: grids that shrink about the best place so far.
template <class Function>
Found least(const Function& f, Range x, Range y) {
  constexpr int cells = 12, rounds = 16;
  const Range all_x = x, all_y = y;
  Found best;
  for (int round = 0; round < rounds; ++round) {
    for (int i = 0; i <= cells; ++i)
      for (int j = 0; j <= (y.low < y.high ? cells : 0); ++j) {
        const double at_x = x.low + (x.high - x.low) * i / cells, at_y = y.low + (y.high - y.low) * j / cells;
        if (const double sum = f(at_x, at_y); sum < best.sum) best = {at_x, at_y, sum};
      }
    const auto around = [](double middle, Range now, Range all) {
      const double reach = 0.22 * (now.high - now.low);
      return Range{std::max(all.low, middle - reach), std::min(all.high, middle + reach)};
    };
    x = around(best.x, x, all_x);
    y = around(best.y, y, all_y);
  }
  return best;
}

/// Errors and steps as logarithms, steps from their mean.
class Data {
 public:
  explicit Data(const std::vector<StepError>& errors) {
    for (const StepError& one : errors) mean_ += std::log(one.step) / static_cast<double>(errors.size());
    for (const StepError& one : errors) {
      steps_.push_back(std::log(one.step) - mean_);
      errors_.push_back(std::log(one.error));
    }
  }

  std::size_t size() const { return steps_.size(); }
  double mean_step() const { return mean_; }
  /// Where curves turn from the model error to the power: from far below the smallest to above the largest
  /// step.
  Range turns() const {
    const auto [low, high] = std::ranges::minmax_element(steps_);
    return {*low - 8, *high + 4};
  }

  /// Mean (an estimate of ln c) and sum of squares of ln error − ln(rᵖ + dtᵖ).
  struct Rest {
    double mean, sum;
  };
  Rest rest(double order, double turn) const {
    double mean = 0, squares = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const double own = errors_[i] - shape(i, order, turn);
      const double before = own - mean;
      mean += before / static_cast<double>(i + 1);
      squares += before * (own - mean);
    }
    return {mean, squares};
  }

  /// The sum of squares with ln c given.
  double sum(double order, double turn, double coefficient) const {
    double squares = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const double off = errors_[i] - shape(i, order, turn) - coefficient;
      squares += off * off;
    }
    return squares;
  }

 private:
  double shape(std::size_t i, double order, double turn) const {
    return turn == -HUGE_VAL ? order * steps_[i]
                             : order * turn + std::log1p(std::exp(order * (steps_[i] - turn)));
  }

  double mean_ = 0;
  std::vector<double> steps_, errors_;
};

constexpr double no_turn = -HUGE_VAL;  ///< of a curve without model error

/// The best curve without model error.
Found best_power(const Data& data) {
  constexpr int bits = std::numeric_limits<double>::digits / 2;  // a minimum is no sharper
  const auto sum = [&](double order) { return data.rest(order, no_turn).sum; };
  const auto [order, least_sum] = boost::math::tools::brent_find_minima(sum, least_order, most_order, bits);
  return {order, no_turn, least_sum};
}

/// The best curve: order, turn and the sum of squares.
Found best_curve(const Data& data) {
  const auto sum = [&](double order, double turn) { return data.rest(order, turn).sum; };
  const Found curve = least(sum, {least_order, most_order}, data.turns());
  const Found power = best_power(data);
  return curve.sum < power.sum ? curve : power;
}

/// Where a profile leaves the limit between a place inside and one further out; that one if it is inside too.
double edge(const std::function<double(double)>& profile, double limit, double inside, double outside) {
  if (profile(outside) <= limit) return outside;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (inside + outside);
    (profile(middle) <= limit ? inside : outside) = middle;
  }
  return inside;
}

Bounded order_bounds(const Data& data, const Found& best, double limit) {
  const auto profile = [&](double order) {
    const auto sum = [&](double turn, double) { return data.rest(order, turn).sum; };
    return std::min(least(sum, data.turns(), {0, 0}).sum, data.rest(order, no_turn).sum);
  };
  return {best.x, edge(profile, limit, best.x, least_order), edge(profile, limit, best.x, most_order)};
}

/// Model errors from a thousandth of the least error to the largest error; below it one counts as none.
Bounded model_error_bounds(const Data& data, double model_error, double power_sum, double limit,
                           Range errors) {
  const auto profile = [&](double logarithm) {
    const auto sum = [&](double order, double turn) {
      return data.sum(order, turn, logarithm - order * turn);
    };
    return least(sum, {least_order, most_order}, data.turns()).sum;
  };
  const double smallest = std::log(1e-3 * errors.low);
  const double inside = std::max(smallest, model_error > 0 ? std::log(model_error) : smallest);
  const double low = power_sum <= limit ? 0 : std::exp(edge(profile, limit, inside, smallest));
  return {model_error, low, std::exp(edge(profile, limit, inside, std::log(errors.high)))};
}

std::string failure(const StepFit& fit, double constant_sum, double limit) {
  if (fit.scatter > std::log(3))
    return fmt::format("the errors scatter about the curve by a factor of {:.3g}", std::exp(fit.scatter));
  if (constant_sum <= limit) return "the errors do not fall with the step";
  if (fit.order.low <= least_order || fit.order.high >= most_order) return "the order is not bounded";
  return "";
}

}  // namespace

std::vector<SeriesFit> fit_runs(const std::vector<RunMetrics>& rows) {
  std::vector<SeriesFit> fits;
  for (const Series& series : series_of(rows)) {
    if (series.size() < least_steps) continue;
    const RunMetrics& row = *series.front();
    for (const char* quantity : quantities) {
      std::vector<StepError> errors;
      for (const RunMetrics* one : series)
        if (const Json error = column_named(quantity).cell(*one); !error.is_null())
          errors.push_back({*one->dt, std::abs(error.get<double>())});
      fits.push_back({row.scene, row.engine, row.solver, row.settings, quantity, fit_steps(errors)});
    }
  }
  return fits;
}

void to_json(Json& json, const SeriesFit& one) {
  const StepFit& fit = one.fit;
  const bool fitted = fit.model_error.high > 0;
  const auto cell = [&](double value) { return fitted ? Json(value) : Json(); };
  json = {{"scene", one.scene},
          {"engine", one.engine},
          {"solver", one.solver},
          {"settings", one.settings},
          {"quantity", one.quantity},
          {"steps", fit.points},
          {"gap", cell(fit.model_error.value)},
          {"gap_low", cell(fit.model_error.low)},
          {"gap_high", cell(fit.model_error.high)},
          {"order", cell(fit.order.value)},
          {"order_low", cell(fit.order.low)},
          {"order_high", cell(fit.order.high)},
          {"coefficient", cell(fit.coefficient)},
          {"scatter", cell(fit.scatter)},
          {"holds", fit.holds()},
          {"reason", fit.reason}};
}

void from_json(const Json& json, SeriesFit& one) {
  const auto number = [&](const std::string& key) {
    return json.at(key).is_null() ? std::nan("") : json.at(key).get<double>();
  };
  const auto bounded = [&](const std::string& key) {
    return Bounded{number(key), number(key + "_low"), number(key + "_high")};
  };
  const StepFit fit{json.at("steps"),      bounded("gap"),    bounded("order"),
                    number("coefficient"), number("scatter"), json.at("reason")};
  one = {json.at("scene"),    json.at("engine"),   json.at("solver"),
         json.at("settings"), json.at("quantity"), fit};
}

StepFit fit_steps(std::vector<StepError> errors) {
  std::erase_if(errors, [](const StepError& one) { return !(std::isfinite(one.error) && one.error > 0); });
  StepFit fit;
  fit.points = errors.size();
  if (fit.points < least_steps) {
    fit.reason = fmt::format("{} steps are fewer than {}", fit.points, least_steps);
    return fit;
  }
  const Data data(errors);
  const auto [low, high] = std::ranges::minmax_element(
      errors, [](const StepError& a, const StepError& b) { return a.error < b.error; });
  const Found best = best_curve(data);
  const std::size_t freedom = fit.points - parameters;
  const double ratio = reach_of_interval(freedom);
  // Rounding alone must not leave a best place out of its own bounds.
  const double limit = best.sum * (1 + ratio * ratio / static_cast<double>(freedom)) + 1e-20;
  const double coefficient = data.rest(best.x, best.y).mean;
  const double model_error = best.y == no_turn ? 0 : std::exp(coefficient + best.x * best.y);
  fit.scatter = std::sqrt(best.sum / static_cast<double>(freedom));
  fit.coefficient = std::exp(coefficient - best.x * data.mean_step());
  fit.order = order_bounds(data, best, limit);
  fit.model_error =
      model_error_bounds(data, model_error, best_power(data).sum, limit, {low->error, high->error});
  fit.reason = failure(fit, data.rest(0, no_turn).sum, limit);
  return fit;
}

}  // namespace rockstack
