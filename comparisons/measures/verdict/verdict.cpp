#include "comparisons/measures/verdict/verdict.hpp"

#include <fmt/format.h>

#include <cctype>
#include <nlohmann/json.hpp>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/sentences.hpp"

namespace rockstack {
namespace {

std::string phrase(const RunMetrics& row) {
  return fmt::format("{} at {}", set_name(row), quantity_text(*row.dt, "s"));
}

std::string exact_sentence(const RunMetrics& exact, const JudgedScene& scene) {
  const std::string doubt = exact.outcome.empty() ? "" : ". It is " + exact.outcome;
  const std::string end = exact.toppled.empty() ? fmt::format("lasts {}", quantity_text(scene.duration, "s"))
                                                : "ends as " + with_verb(exact.toppled, "falls");
  return fmt::format("The exact motion {} and has {}{}.", end, impacts_text(exact), doubt);
}

/// "2 to 5 mrad": a unit that both ends have is said once, as is an end that reads like the other.
std::string range_text(double least, double most, const std::string& unit) {
  const std::string from = quantity_text(least, unit, 2), to = quantity_text(most, unit, 2);
  const std::size_t end = from.find(' ');
  const bool same_unit = from.substr(end) == to.substr(to.find(' '));
  return from == to ? from : fmt::format("{} to {}", same_unit ? from.substr(0, end) : from, to);
}

/// "2 to 5 ms early", or "2 ms early to 3 ms late".
std::string lateness_text(double least, double most, const std::string& unit) {
  if (most < 0) return range_text(-most, -least, unit) + " early";
  if (least >= 0) return range_text(least, most, unit) + " late";
  return fmt::format("{} early to {} late", quantity_text(-least, unit, 2), quantity_text(most, unit, 2));
}

/// "10 ms: 2 to 5 mrad; 1 ms: …" of a column, in the place of {} in a sentence; empty where no row has it.
std::string by_step(const std::vector<ReplicatedRow>& rows, fmt::format_string<std::string> sentence,
                    const char* unit, std::optional<double> RunMetrics::*measure,
                    std::string (*text)(double, double, const std::string&) = range_text) {
  std::map<double, std::pair<double, double>, std::greater<>> ranges;  // of each step, the coarsest first
  for (const ReplicatedRow& one : rows) {
    const std::optional<double>& value = one.*measure;
    if (!is_engine(one) || !value) continue;
    auto& [least, most] = ranges.try_emplace(*one.dt, *value, *value).first->second;
    least = std::min(least, *value);
    most = std::max(most, *value);
  }
  std::vector<std::string> parts;
  parts.reserve(ranges.size());
  for (const auto& [dt, range] : ranges)
    parts.push_back(fmt::format("{}: {}", quantity_text(dt, "s"), text(range.first, range.second, unit)));
  return parts.empty() ? "" : fmt::format(sentence, fmt::format("{}", fmt::join(parts, "; ")));
}

/// How late the first impact of one scene comes in engines; empty where none can be compared.
std::string first_impact_sentence(const std::vector<ReplicatedRow>& rows) {
  const auto exact = std::ranges::find(rows, "exact", &RunMetrics::engine);
  if (exact == rows.end() || !exact->first_impact_time) return "";
  const std::string by_steps =
      by_step(rows, "{}", "s", &RunMetrics::first_impact_time_difference, lateness_text);
  return by_steps.empty() ? ""
                          : fmt::format("Engines have the first impact, at {}, by step: {}.",
                                        quantity_text(*exact->first_impact_time, "s"), by_steps);
}

/// Empty where nothing slips otherwise.
std::string slip_sentence(const std::vector<ReplicatedRow>& rows) {
  const bool same = std::ranges::none_of(
      rows, [](const ReplicatedRow& one) { return is_engine(one) && one.slip_error.value_or(0) != 0; });
  return same ? "" : by_step(rows, "Slips are off by at most: {}.", "m", &RunMetrics::slip_error);
}

void add_sequences(const std::vector<ReplicatedRow>& rows, const JudgedScene& scene,
                   std::vector<std::string>& sentences) {
  std::size_t compared = 0, all = 0;
  int missed = 0, extra = 0;
  bool whole = true;
  for (const auto& one : rows) {
    if (!is_engine(one) || !one.impacts_missed) continue;
    ++compared;
    whole = whole && one.horizon.value_or(scene.duration) >= scene.duration;
    if (one.impacts_missed == 0 && one.impacts_extra == 0) ++all;
    missed = std::max(missed, *one.impacts_missed);
    extra = std::max(extra, one.impacts_extra.value_or(0));
  }
  if (compared > 0)
    sentences.push_back(fmt::format(
        "Of {} {} the exact sequence of impacts{}{}.", counted(compared, "engine row"),
        all == 0   ? "none has"
        : all == 1 ? "1 has"
                   : fmt::format("{} have", all),
        whole ? "" : " up to the horizon",
        all == compared ? ""
                        : fmt::format("; {} up to {} and have up to {} extra",
                                      all == 0 ? "they miss" : "the others miss", missed, extra)));
}

void add_beyond(const std::vector<ReplicatedRow>& rows, const JudgedScene& scene,
                std::vector<std::string>& sentences) {
  std::vector<std::string> other;
  std::size_t compared = 0;
  double horizon = scene.duration;
  for (const ReplicatedRow& one : rows) {
    if (!can_be_ranked(one)) continue;
    horizon = one.horizon.value_or(horizon);
    ++compared;
    if (!one.peaks.empty() && mann_whitney(one.exact_peaks, one.peaks).p_value <= separation_level)
      other.push_back(phrase(one));
  }
  if (compared == 0 || horizon >= scene.duration) return;
  sentences.push_back(
      fmt::format("Exact motions of scenes that differ in the sixth digit part after {}; later on largest "
                  "angles, energy, motion at rest and toppling alone are compared.",
                  quantity_text(horizon, "s")));
  sentences.push_back(
      other.empty()
          ? fmt::format(
                "Largest angles over the whole scene cannot be told from the exact ones in any of {}.",
                counted(compared, "row"))
          : fmt::format("Largest angles over the whole scene are others than the exact ones in {} of {}: {}.",
                        other.size(), counted(compared, "row"), joined_up_to(4, other)));
}

/// How many of a scene's perturbed neighbours topple, exactly and with engines, in a sentence; empty where
/// that was not asked for, or none topples.
std::string toppling_sentence(const std::vector<DistributionDistance>& distances,
                              const std::vector<ReplicatedRow>& rows, const std::string& scene) {
  std::vector<std::string> engines;
  double exact = 0, most = 0;
  std::size_t count = 0;
  for (const DistributionDistance& one : distances) {
    if (one.scene != scene || one.quantity != "toppled") continue;
    exact = one.exact_mean, count = one.exact;
    most = std::max({most, one.exact_mean, one.other_mean});
    const auto row = std::ranges::find(rows, one.run, &RunMetrics::run);
    const std::string run = row == rows.end() || !is_engine(*row) ? one.run : phrase(*row);
    engines.push_back(fmt::format("{:.3g} % with {}{}", 100 * one.other_mean, run,
                                  one.apart.distance > one.apart.critical ? ", more than chance apart" : ""));
  }
  if (most == 0) return "";
  return fmt::format("Of {} scenes that differ a little from {} {:.3g} % topple exactly, and {}.", count,
                     scene, 100 * exact, joined(engines));
}

/// How fast the error of a scene's first impact falls with the step, in a sentence; empty where it was not
/// fitted.
std::string convergence_sentence(const std::vector<SeriesFit>& fits, const std::string& scene) {
  std::vector<double> orders;
  for (const SeriesFit& one : fits)
    if (one.scene == scene && one.fit.holds() && one.quantity == "first_impact_time_difference")
      orders.push_back(one.fit.order.value);
  if (orders.empty()) return "";
  std::ranges::sort(orders);
  return fmt::format(
      "The error of the first impact falls with the step to the power {:.2f} ({} of {:.2f} to {:.2f}).",
      orders[(orders.size() - 1) / 2], counted(orders.size(), "fit"), orders.front(), orders.back());
}

/// What the rows of one scene come to beside what a headline says: the exact motion, what happens otherwise,
/// errors, the first impact, slips, sequences of impacts, what distributions tell beyond the horizon, and
/// what failed. A sentence each, empty where there is nothing to say.
std::vector<std::string> scene_sentences(const std::vector<ReplicatedRow>& rows, const JudgedScene& scene) {
  const auto exact = std::ranges::find(rows, "exact", &RunMetrics::engine);
  const bool solved = exact != rows.end() && exact->status == RunStatus::done;
  const std::string angles =
      by_step(rows, "RMS angle differences by step: {}.", "rad", &RunMetrics::rms_angle_difference);
  const std::string centres = by_step(rows, "RMS distances of centres from the exact ones: {}.", "m",
                                      &RunMetrics::rms_position_difference);
  std::vector<std::string> sentences{
      solved ? exact_sentence(*exact, scene) : "There is no exact motion to compare with.",
      event_sentence(rows, rows.size()), angles, angles.empty() ? "" : centres, slip_sentence(rows)};
  add_sequences(rows, scene, sentences);
  add_beyond(rows, scene, sentences);
  for (const auto& one : rows)
    if (one.status != RunStatus::done)
      sentences.push_back(fmt::format("{} failed: {}.", one.dt ? phrase(one) : one.engine, one.reason));
  return sentences;
}

/// Scenes in which nothing moves: what happens in engines is told by itself.
std::string rest_sentence(const std::vector<ReplicatedRow>& rows, const std::vector<JudgedScene>& scenes) {
  std::vector<std::string> at_rest;
  for (const JudgedScene& scene : scenes) {
    const bool rests = std::ranges::any_of(rows, [&](const ReplicatedRow& one) {
      return one.scene == scene.name && one.motion && *one.motion <= rest_extent;
    });
    if (rests) at_rest.push_back(scene.name);
  }
  return at_rest.empty() ? "" : fmt::format("Nothing moves in {}, where no set is ranked.", joined(at_rest));
}

/// Scenes whose exact motion is not the only one, not one of blocks that only push and stick, or not one that
/// engines are asked for: they stand on contacts of their own.
std::string doubt_sentence(const std::vector<ReplicatedRow>& rows) {
  std::vector<std::string> doubts;
  for (const ReplicatedRow& one : rows) {
    if (one.engine != "exact") continue;
    const std::string motion = fmt::format("in {} the exact motion ", one.scene);
    if (!one.outcome.empty()) doubts.push_back(motion + "is " + one.outcome);
    if (one.law == name(Law::compliant))
      doubts.push_back(motion + "stands on springs that engines do not have");
  }
  if (doubts.empty()) return "";
  return capitalised(joined(doubts)) + ".";
}

std::string together(const std::string& first, std::string second) {
  if (first.empty() || second.empty()) return first + second;
  second.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(second.front())));
  return first.substr(0, first.size() - 1) + "; " + second;
}

/// What was asked of perturbed scenes comes first.
std::vector<std::string> headline_of(const ComparisonEvidence& evidence,
                                     const std::vector<JudgedScene>& scenes) {
  constexpr std::size_t most_events = 2;
  const auto& rows = evidence.rows;
  std::vector<std::string> sentences;
  sentences.reserve(scenes.size() + 4);
  for (const JudgedScene& scene : scenes)
    sentences.push_back(toppling_sentence(evidence.distances, rows, scene.name));
  sentences.push_back(together(doubt_sentence(rows), agreement_sentence(rows, scenes)));
  if (scenes.size() == 1) sentences.push_back(first_impact_sentence(rows));
  sentences.push_back(event_sentence(rows, most_events));
  sentences.push_back(together(nearest_sentence(rows, scenes), rest_sentence(rows, scenes)));
  std::erase(sentences, "");
  sentences.resize(std::min<std::size_t>(sentences.size(), 4));
  return sentences;
}

/// Sentences on a scene; where it is alone the headline has said what all scenes come to.
std::vector<std::string> sentences_of(const ComparisonEvidence& evidence, const JudgedScene& scene,
                                      bool alone) {
  const std::vector<ReplicatedRow> own = rows_of(evidence.rows, scene);
  std::vector<std::string> sentences = scene_sentences(own, scene);
  if (!alone)
    sentences.insert(sentences.begin() + 1, {agreement_sentence(own, {scene}), first_impact_sentence(own),
                                             nearest_sentence(own, {scene})});
  sentences.push_back(toppling_sentence(evidence.distances, own, scene.name));
  sentences.push_back(convergence_sentence(evidence.fits, scene.name));
  std::erase(sentences, "");
  return sentences;
}

}  // namespace

std::string impacts_text(const RunMetrics& exact) {
  const int slower = exact.slower_impacts.value_or(0);
  if (exact.impacts.value_or(0) == 0) return slower > 0 ? "no impact but chatter" : "no impact";
  std::string text = counted(static_cast<std::size_t>(*exact.impacts), "impact");
  if (slower > 0) text += fmt::format(" and {} in chatter, too slow to be compared", slower);
  if (exact.first_impact_time && exact.first_impact_speed)
    text += fmt::format(", the first at {} and {}", quantity_text(*exact.first_impact_time, "s"),
                        quantity_text(*exact.first_impact_speed, "m/s"));
  return text;
}

ComparisonVerdict verdict_of(const ComparisonEvidence& evidence, const std::vector<JudgedScene>& scenes) {
  const auto sentences = [&](const JudgedScene& scene) {
    return sentences_of(evidence, scene, scenes.size() == 1);
  };
  return {headline_of(evidence, scenes), mapped(scenes, sentences), rank_all(evidence.rows)};
}

ComparisonVerdict verdict_from(const Json& json) {
  const auto sentences = [](const Json& scene) {
    return scene.at("sentences").get<std::vector<std::string>>();
  };
  return {json.at("headline"), mapped(json.at("scenes"), sentences), json.at("ranking")};
}

Json verdict_json(const ComparisonVerdict& verdict, const std::vector<JudgedScene>& scenes) {
  Json json{{"headline", verdict.headline}, {"scenes", Json::array()}, {"ranking", verdict.ranking}};
  for (std::size_t i = 0; i < scenes.size(); ++i)
    json["scenes"].push_back({{"name", scenes[i].name}, {"sentences", verdict.scenes[i]}});
  json["ranking_definition"] = fmt::format(
      "rows are ranked by `error`, up to the horizon of each scene: each over the least of its scene and step, "
      "then the geometric mean over scenes and steps; scenes at rest are left out, and so is a row of one run where others have replicates. A set is called nearer than "
      "another only where Mann–Whitney tests of replicates, by ranks within each scene and step, show it at a "
      "level of {:g} % over all pairs (Holm), or where it fails less often. A rank is one more than the number of sets that are so",
      100 * separation_level);
  return json;
}

}  // namespace rockstack
