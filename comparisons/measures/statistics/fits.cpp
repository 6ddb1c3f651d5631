#include "comparisons/measures/statistics/fits.hpp"

#include <nlohmann/json.hpp>
#include <tuple>

#include "analytic/scene/lists.hpp"

namespace rockstack {
namespace {

constexpr std::size_t least_steps = 5;

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

}  // namespace rockstack
