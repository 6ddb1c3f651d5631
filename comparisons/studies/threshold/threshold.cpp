#include "comparisons/studies/threshold/threshold.hpp"

#include <fmt/format.h>

#include "analytic/scene/input/toml_reader.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "analytic/scene/messages/one_line.hpp"
#include "comparisons/measures/results/csv.hpp"

namespace rockstack {
namespace {

constexpr double resolution = 1e-12;       ///< of a threshold, relative
constexpr std::size_t bracket_values = 8;  ///< of a bracket, its ends among them, run side by side

/// So many values at equal distances, the ends of the range among them.
std::vector<double> spaced(double low, double high, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = std::lerp(low, high, static_cast<double>(i) / static_cast<double>(count - 1));
  return values;
}

std::vector<TriedValue> tried_at(const SceneDocument& document, const std::string& key,
                                 const std::vector<double>& values, MotionLibrary& library) {
  const auto node_of = [&](double number) {
    return Value{{.kind = Node::Kind::number, .place = "--vary " + key, .number = number},
                 number_text(number)};
  };
  Ensemble runs;
  runs.base = document;
  runs.variations = {{.keys = {key}, .values = mapped(values, node_of), .distribution = {}, .place = {}}};
  runs.axes = {{"", {0}, values.size()}};
  std::vector<TriedValue> tried = mapped(values, [](double value) { return TriedValue{value, {}}; });
  make_runs(runs, 0, values.size(), library, [&](const RunResult& result) {
    TriedValue& one = tried[result.run];
    if (result.outcome != nullptr) one.outcome = *result.outcome;
    one.reason = result.reason;
  });
  return tried;
}

/// Closes in on the first change between two neighbours whose outcomes differ; ends at a value without a
/// motion. @returns the last value with the lower one's outcome, and the next.
std::pair<double, double> change_between(const SceneDocument& document, const ThresholdRequest& request,
                                         double low, double high, bool at_low, MotionLibrary& library) {
  while (high - low > resolution * std::max(std::abs(low), std::abs(high))) {
    const double before_low = low, before_high = high;
    for (const TriedValue& one :
         tried_at(document, request.vary.key, spaced(low, high, bracket_values), library)) {
      if (!one.outcome) return {low, high};
      const bool same = request.outcome.of(*one.outcome) == at_low;
      (same ? low : high) = one.value;
      if (!same) break;
    }
    if (low == before_low && high == before_high) break;
  }
  return {low, high};
}

}  // namespace

ThresholdOutcome outcome_named(const std::string& text, std::size_t blocks) {
  if (text == "topples")
    return {"topples", "stands",
            [](const RunOutcome& outcome) { return outcome.toppled != 0 || outcome.falling != 0; }};
  if (text == "lifts")
    return {"lifts", "does not lift", [](const RunOutcome& outcome) {
              return outcome.motion != MotionMode::rest && outcome.motion != MotionMode::slide;
            }};
  const std::size_t above = text.find('>');
  const std::string name = text.substr(0, above);
  const auto least = above == std::string::npos ? std::nullopt : number_in(text.substr(above + 1));
  std::vector<std::string> names;
  for (const OutcomeColumn& column : outcome_columns(blocks)) {
    const auto* measure = std::get_if<OutcomeColumn::Measure>(&column.value);
    if (measure == nullptr) continue;
    if (column.name == name && least)
      return {fmt::format("has {} > {}", name, *least), fmt::format("has {} ≤ {}", name, *least),
              [measure = *measure, least = *least](const RunOutcome& outcome) {
                return measure(outcome).value_or(-std::numeric_limits<double>::infinity()) > least;
              }};
    names.push_back(column.name);
  }
  throw InputError(
      fmt::format("--outcome {}: must be topples, lifts or COLUMN>NUMBER with one of the columns {}",
                  one_line(text), fmt::join(names, ", ")));
}

std::optional<double> Threshold::first() const {
  if (ranges.size() < 2 || ranges.front().happens) return std::nullopt;
  return ranges[1].from;
}

Threshold threshold(const SceneDocument& document, const ThresholdRequest& request, MotionLibrary& library) {
  const auto& [key, low, high] = request.vary;
  Threshold found{tried_at(document, key, spaced(low, high, request.values), library), {}};
  for (const TriedValue& one : found.tried) {
    if (!one.outcome) continue;
    const bool happens = request.outcome.of(*one.outcome);
    if (found.ranges.empty()) {
      found.ranges.push_back({one.value, one.value, happens});
    } else if (OutcomeRange& last = found.ranges.back(); last.happens == happens) {
      last.to = one.value;
    } else {
      const auto [before, after] =
          change_between(document, request, last.to, one.value, last.happens, library);
      last.to = before;
      found.ranges.push_back({after, one.value, happens});
    }
  }
  if (found.ranges.empty())
    throw InputError(fmt::format("--vary {}: no value has a motion: {}", key, found.tried.front().reason));
  return found;
}

ThresholdSpectrum threshold_spectrum(const SceneDocument& document, const ThresholdRequest& request,
                                     const VariedKey& over, std::size_t values, MotionLibrary& library,
                                     const std::function<void(std::size_t)>& progress) {
  ThresholdSpectrum spectrum{over, spaced(over.low, over.high, values), {}};
  SceneDocument varied = document;
  for (const double value : spectrum.values) {
    set_value(varied.root, over.key,
              {.kind = Node::Kind::number, .place = "--over " + over.key, .number = value});
    spectrum.thresholds.push_back(threshold(varied, request, library));
    progress(spectrum.thresholds.size());
  }
  return spectrum;
}

}  // namespace rockstack
