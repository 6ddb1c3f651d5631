#include <fmt/format.h>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/studies/fit/fit.hpp"

namespace rockstack {
namespace {

/// How far a residual may lie above the test's uncertainty, and a correlation from zero, before chance is no
/// reason: three standard deviations.
constexpr double chance = 3;

/// JSON writes bounds that are infinite as null.
Json parameter_json(const FittedParameter& one) {
  return {{"key", one.parameter.key}, {"low", one.parameter.low}, {"high", one.parameter.high},
          {"value", one.value},       {"lower", one.lower},       {"upper", one.upper}};
}

/// What is left between motion and test, in sentences.
std::vector<std::string> residual_meaning(const Fit& fit, const Measurement& measured) {
  if (fit.rounding)
    return {fmt::format(
        "The fitted motion is the test's to rounding, over {} readings up to {:.4g} s: bounds are of rounding.",
        fit.readings, fit.horizon)};
  const auto count = static_cast<double>(fit.readings);
  std::vector<std::string> list{fmt::format(
      "The fitted motion is {:.3g} {} off in the root of the mean square, over {} readings up to {:.4g} s.",
      fit.residual, measured.unit(), fit.readings, fit.horizon)};
  if (measured.uncertainty) {
    const double ratio = fit.residual / *measured.uncertainty;
    const double freedom = count - static_cast<double>(fit.parameters.size());
    list.push_back(fmt::format("That is {:.3g} times the uncertainty of the test: the model {}.", ratio,
                               ratio > 1 + chance / std::sqrt(2 * freedom) ? "leaves something out"
                                                                           : "tells all that the test does"));
  }
  list.push_back(
      std::abs(fit.correlation) > chance / std::sqrt(count)
          ? fmt::format(
                "Neighbouring residuals go together, with a correlation of {:.2f}: they are of the model or "
                "of the instrument rather than noise, and the intervals are too narrow.",
                fit.correlation)
          : fmt::format("Neighbouring residuals have a correlation of {:.2f}, as independent noise has: the "
                        "intervals hold in 95 of 100 tests.",
                        fit.correlation));
  return list;
}

/// What was found, and what it means.
std::vector<std::string> headline(const Fit& fit, const Measurement& measured) {
  std::vector<std::string> list = mapped(fit.parameters, [](const FittedParameter& one) {
    const std::string found = fmt::format("{} = {:.6g}", one.parameter.key, one.value);
    return std::isinf(one.lower)
               ? found + "."
               : fmt::format("{}, with 95 % confidence from {:.6g} to {:.6g}.", found, one.lower, one.upper);
  });
  for (std::string& sentence : meaning(fit, measured)) list.push_back(std::move(sentence));
  return list;
}

}  // namespace

std::vector<std::string> meaning(const Fit& fit, const Measurement& measured) {
  std::vector<std::string> list = residual_meaning(fit, measured);
  for (const FittedParameter& one : fit.parameters)
    if (is_clock(one.parameter) && std::isfinite(one.lower) && !one.holds(0))
      list.push_back(
          fmt::format("The clock of the test is {} {} than the scene's, which is one of what was fitted.",
                      quantity_text(std::abs(one.value), "s"), one.value > 0 ? "later" : "earlier"));
  for (const FittedParameter& one : fit.parameters) {
    if (std::isinf(one.lower)) {
      list.push_back(
          fmt::format("The test does not tell {}: no value of it, or of others with it, changes the "
                      "motion.",
                      one.parameter.key));
    } else if (one.flat) {
      list.push_back(
          fmt::format("{} may as well lie anywhere from {:.4g} to {:.4g}: the motion comes as near.",
                      one.parameter.key, one.lower, one.upper));
    } else if (one.at_end()) {
      list.push_back(
          fmt::format("{} stands at an end of its range: the best may lie beyond.", one.parameter.key));
    }
  }
  return list;
}

Json fit_json(const std::string& title, const Measurement& measured, const Fit& fit,
              const std::string& command) {
  return {{"title", title},
          {"headline", headline(fit, measured)},
          {"file", measured.file},
          {"columns", measured.columns},
          {"unit", measured.unit()},
          {"uncertainty", measured.uncertainty ? Json(*measured.uncertainty) : Json()},
          {"horizon", fit.horizon},
          {"readings", fit.readings},
          {"residual", fit.residual},
          {"correlation", fit.correlation},
          {"parameters", mapped(fit.parameters, parameter_json)},
          {"meaning", meaning(fit, measured)},
          {"environment", environment({})},
          {"command", command}};
}

void write_fit(const std::string& title, const Measurement& measured, const Fit& fit,
               const std::filesystem::path& folder, const std::string& command) {
  CsvWriter csv;
  csv.add("time");
  for (const char* kind : {"measured", "fitted"})
    for (const std::string& column : measured.columns) csv.add(fmt::format("{}_{}", kind, column));
  csv.end_line();
  const std::size_t width = measured.columns.size();
  for (std::size_t i = 0; i < fit.times.size(); ++i) {
    csv.add(fit.times[i]);
    for (const auto* values : {&measured.values, &fit.motion})
      for (std::size_t k = i * width; k < (i + 1) * width; ++k)
        csv.add(std::isnan((*values)[k]) ? std::nullopt : std::optional((*values)[k]));
    csv.end_line();
  }
  write_file(folder / "fit.csv", csv.text());
  write_file(folder / "fit.json", fit_json(title, measured, fit, command).dump(2) + "\n");
}

}  // namespace rockstack
