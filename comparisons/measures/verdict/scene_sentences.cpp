#include "comparisons/measures/verdict/scene_sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/statistics/mann_whitney.hpp"

namespace rockstack {
namespace {

std::string phrase(const RunMetrics& row) {
  return fmt::format("{} at {}", set_name(row), quantity_text(*row.dt, "s"));
}

std::string exact_sentence(const RunMetrics& exact, const SceneScale& scale) {
  const std::string end = exact.toppled.empty() ? fmt::format("lasts {}", quantity_text(scale.duration, "s"))
                                                : "ends as a block falls: " + exact.toppled;
  if (exact.impacts.value_or(0) == 0) return fmt::format("The exact motion {} and has no impact.", end);
  return fmt::format("The exact motion {} and has {} fast enough to be compared, {} with chatter.", end,
                     counted(static_cast<std::size_t>(*exact.impacts), "impact"),
                     *exact.impacts + exact.slower_impacts.value_or(0));
}

/// The least and the largest of a column at each step, the coarsest first.
struct Range {
  const RunMetrics* least = nullptr;
  const RunMetrics* most = nullptr;
};

template <class Value>
std::map<double, Range, std::greater<>> ranges(const std::vector<ReplicatedRow>& rows, const Value& value) {
  std::map<double, Range, std::greater<>> list;
  for (const auto& one : rows) {
    const RunMetrics& row = one.row;
    if (!is_engine(row) || !value(row)) continue;
    Range& range = list[*row.dt];
    if (!range.least || *value(row) < *value(*range.least)) range.least = &row;
    if (!range.most || *value(row) > *value(*range.most)) range.most = &row;
  }
  return list;
}

/// "10 ms: 2 to 5 mrad; 1 ms: …" of a column.
template <class Value>
std::string by_step(const std::vector<ReplicatedRow>& rows, const char* unit, const Value& value,
                    std::string (*text)(double, const std::string&, int)) {
  std::vector<std::string> parts;
  for (const auto& [dt, range] : ranges(rows, value)) {
    const std::string least = text(*value(*range.least), unit, 2), most = text(*value(*range.most), unit, 2);
    parts.push_back(fmt::format("{}: {}", quantity_text(dt, "s"),
                                least == most ? least : fmt::format("{} to {}", least, most)));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

void add_errors(const std::vector<ReplicatedRow>& rows, std::vector<std::string>& sentences) {
  const std::string angles = by_step(
      rows, "rad", [](const RunMetrics& row) { return row.rms_angle_difference; }, quantity_text);
  if (angles.empty()) return;
  sentences.push_back(fmt::format("RMS angle differences by step: {}.", angles));
  const std::string places = by_step(
      rows, "m", [](const RunMetrics& row) { return row.rms_position_difference; }, quantity_text);
  if (!places.empty())
    sentences.push_back(fmt::format("RMS distances of centres from the exact ones: {}.", places));
}

void add_first_impact(const std::vector<ReplicatedRow>& rows, std::vector<std::string>& sentences) {
  const std::string text = by_step(
      rows, "s", [](const RunMetrics& row) { return row.first_impact_time_difference; },
      signed_quantity_text);
  if (!text.empty()) sentences.push_back(fmt::format("The first impact is off by (+: late): {}.", text));
}

void add_slips(const std::vector<ReplicatedRow>& rows, std::vector<std::string>& sentences) {
  const auto slip = [](const RunMetrics& row) { return row.slip_error; };
  const auto list = ranges(rows, slip);
  if (std::all_of(list.begin(), list.end(), [&](const auto& one) { return *slip(*one.second.most) == 0; }))
    return;
  sentences.push_back(fmt::format("Slips are off by at most: {}.", by_step(rows, "m", slip, quantity_text)));
}

void add_sequences(const std::vector<ReplicatedRow>& rows, std::vector<std::string>& sentences) {
  std::size_t compared = 0, all = 0;
  for (const auto& one : rows) {
    if (!is_engine(one.row) || !one.row.impacts_missed) continue;
    ++compared;
    if (one.row.impacts_missed == 0 && one.row.impacts_extra == 0) ++all;
  }
  if (compared > 0)
    sentences.push_back(fmt::format("Of {} {} the exact sequence of impacts, none missed and none extra.",
                                    counted(compared, "engine row"),
                                    all == 0   ? "none has"
                                    : all == 1 ? "1 has"
                                               : fmt::format("{} have", all)));
}

/// Whether replicates show a row's largest angles to be others than the exact ones.
bool has_other_peaks(const ReplicatedRow& one) {
  return !one.peaks.empty() && mann_whitney(one.exact_peaks, one.peaks).p_value <= separation_level;
}

void add_beyond(const std::vector<ReplicatedRow>& rows, const SceneScale& scale,
                std::vector<std::string>& sentences) {
  std::vector<std::string> other;
  std::size_t compared = 0;
  double horizon = scale.duration;
  for (const ReplicatedRow& one : rows) {
    if (!can_be_ranked(one)) continue;
    horizon = one.row.horizon.value_or(horizon);
    ++compared;
    if (has_other_peaks(one)) other.push_back(phrase(one.row));
  }
  if (compared == 0 || horizon >= scale.duration) return;
  sentences.push_back(
      fmt::format("Exact motions of scenes that differ in the sixth digit part after {}; later on largest "
                  "angles, energy, "
                  "motion at rest and toppling alone are compared.",
                  quantity_text(horizon, "s")));
  sentences.push_back(
      other.empty()
          ? fmt::format(
                "Largest angles over the whole scene cannot be told from the exact ones in any of {}.",
                counted(compared, "row"))
          : fmt::format("Largest angles over the whole scene are others than the exact ones in {} of {}: {}.",
                        other.size(), counted(compared, "row"), joined_up_to(4, other)));
}

}  // namespace

std::vector<std::string> scene_sentences(const std::vector<ReplicatedRow>& rows, const JudgedScene& scene) {
  std::vector<std::string> sentences;
  const auto exact = std::find_if(rows.begin(), rows.end(),
                                  [](const ReplicatedRow& one) { return one.row.engine == "exact"; });
  const bool solved = exact != rows.end() && exact->row.status == RunStatus::done;
  sentences.push_back(solved ? exact_sentence(exact->row, scene.scale)
                             : "There is no exact motion to compare with.");
  sentences.push_back(event_sentence(rows, {scene}, rows.size()));
  add_errors(rows, sentences);
  add_first_impact(rows, sentences);
  add_slips(rows, sentences);
  add_sequences(rows, sentences);
  add_beyond(rows, scene.scale, sentences);
  for (const auto& one : rows)
    if (one.row.status != RunStatus::done)
      sentences.push_back(
          fmt::format("{} failed: {}.", one.row.dt ? phrase(one.row) : one.row.engine, one.row.reason));
  return sentences;
}

}  // namespace rockstack
