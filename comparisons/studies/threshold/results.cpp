#include <fmt/format.h>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/studies/threshold/threshold.hpp"

namespace rockstack {
namespace {

/// Ten digits, of the twelve that are known.
std::string value_text(const std::string& key, double value) {
  return fmt::format("{} = {:.10g}", key, value);
}

std::string ranges_csv(const Threshold& found) {
  CsvWriter csv;
  csv.line("from", "to", "happens");
  for (const OutcomeRange& range : found.ranges) csv.line(range.from, range.to, range.happens ? 1 : 0);
  return csv.text();
}

std::string tried_csv(const ThresholdRequest& request, const Threshold& found) {
  CsvWriter csv;
  csv.line("value", "happens", "peak_ratio", "toppled", "topple_time", "motion", "reason");
  for (const TriedValue& one : found.tried) {
    csv.add(one.value);
    if (const auto& outcome = one.outcome)
      csv.add(request.outcome.of(*outcome) ? 1 : 0, outcome->peak_ratio, outcome->toppled,
              outcome->topple_time, name(outcome->motion), "");
    else
      csv.add("", "", "", "", "", one.reason);
    csv.end_line();
  }
  return csv.text();
}

std::string spectrum_csv(const ThresholdSpectrum& spectrum) {
  CsvWriter csv;
  csv.line("value", "first", "ranges");
  for (std::size_t i = 0; i < spectrum.values.size(); ++i)
    csv.line(spectrum.values[i], spectrum.thresholds[i].first(), spectrum.thresholds[i].ranges.size());
  return csv.text();
}

Json json_of(const VariedKey& range) {
  return {{"key", range.key}, {"low", range.low}, {"high", range.high}};
}

}  // namespace

std::vector<std::string> threshold_headline(const ThresholdRequest& request, const Threshold& found) {
  const auto& [key, low, high] = request.vary;
  const ThresholdOutcome& outcome = request.outcome;
  const auto ranges = [&](bool happens) {
    std::vector<std::string> list;
    for (std::size_t i = 1; i < found.ranges.size(); ++i)
      if (const OutcomeRange& range = found.ranges[i]; range.happens == happens)
        list.push_back(i + 1 < found.ranges.size()
                           ? fmt::format("from {:.6g} to {:.6g}", range.from, range.to)
                           : fmt::format("from {:.6g} on", range.from));
    return list;
  };
  std::vector<std::string> sentences;
  const bool from_below = found.ranges.front().happens;
  if (const auto first = found.first())
    sentences.push_back(fmt::format("The stack {} first at {}.", outcome.happens, value_text(key, *first)));
  if (from_below)
    sentences.push_back(found.ranges.size() == 1
                            ? fmt::format("The stack {} at every {} that was tried, from {:g} to {:g}.",
                                          outcome.happens, key, low, high)
                            : fmt::format("The stack {} from {} on, the least that was tried, up to {:.10g}.",
                                          outcome.happens, value_text(key, low), found.ranges.front().to));
  else if (found.ranges.size() == 1)
    sentences.push_back(fmt::format("The stack {} at every {} that was tried, from {:g} to {:g}.",
                                    outcome.otherwise, key, low, high));
  const std::vector<std::string> back = ranges(false);
  if (!back.empty())
    sentences.push_back(fmt::format("Above that it {} again {}.", outcome.otherwise, joined(back)));
  std::size_t failed = 0, open = 0;
  for (const TriedValue& one : found.tried) {
    failed += !one.outcome;
    open += one.outcome && !request.outcome.of(*one.outcome) && one.outcome->ground_left > 0;
  }
  sentences.push_back(fmt::format("{} were tried, {:.3g} apart: what is narrower may be missed.",
                                  counted(found.tried.size(), "value"),
                                  (high - low) / static_cast<double>(found.tried.size() - 1)));
  if (open > 0)
    sentences.push_back(fmt::format("{} {} while the ground moves on: a longer duration decides.",
                                    counted(open, "motion"), open == 1 ? "ends" : "end"));
  if (failed > 0) sentences.push_back(fmt::format("{} failed; threshold.csv says why.", failed));
  return sentences;
}

Json write_threshold(const std::string& title, const ThresholdRequest& request, const Threshold& found,
                     const ThresholdSpectrum* spectrum, const std::filesystem::path& folder,
                     const std::string& command) {
  write_file(folder / "threshold.csv", tried_csv(request, found));
  write_file(folder / "threshold-ranges.csv", ranges_csv(found));
  const auto first = found.first();
  Json json{
      {"title", title},
      {"headline", threshold_headline(request, found)},
      {"tables", {"threshold-ranges.csv"}},
      {"vary", json_of(request.vary)},
      {"happens", request.outcome.happens},
      {"otherwise", request.outcome.otherwise},
      {"first", first ? Json(*first) : Json()},
      {"ranges", mapped(found.ranges,
                        [](const OutcomeRange& range) {
                          return Json{{"from", range.from}, {"to", range.to}, {"happens", range.happens}};
                        })},
      {"environment", environment({})},
      {"command", command}};
  if (spectrum != nullptr) {
    write_file(folder / "threshold-spectrum.csv", spectrum_csv(*spectrum));
    json["tables"].push_back("threshold-spectrum.csv");
    json["over"] = json_of(spectrum->over);
  }
  write_file(folder / "threshold.json", json.dump(2) + "\n");
  return json;
}

}  // namespace rockstack
