#include "plots/pages/summary.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "comparisons/measures/results/csv.hpp"
#include "plots/data/events.hpp"
#include "plots/data/selection.hpp"
#include "plots/pages/sentences.hpp"

namespace rockstack::plots {
namespace {

/// True for an engine's run; other exact solutions have no settings.
bool is_engine(const Run& run) {
  return !run.settings.empty();
}

/// The engine run of the scene with the smallest `measure`, without those that have none; null if no run has.
template <class Measure>
const Run* least(const std::vector<Run>& runs, const Measure& measure) {
  const Run* best = nullptr;
  for (const Run& run : runs)
    if (is_engine(run) && !std::isnan(measure(run)) && (!best || measure(run) < measure(*best))) best = &run;
  return best;
}

std::string exact_sentence(const Run& exact, int blocks) {
  const std::vector<double> times = read_columns(exact.folder / "history.csv", {"time"})[0];
  const double end = times.empty() ? 0 : times.back();
  const ExactEvents events = read_events(exact, blocks, end, "");
  double first = end;
  for (const std::vector<double>& interface : events.impact_times)
    if (!interface.empty()) first = std::min(first, interface.front());
  if (events.impacts == 0) return fmt::format("The exact motion lasts {:.4g} s and has no impact.", end);
  return fmt::format("The exact motion lasts {:.4g} s and has {}, chatter included, the first at {:.6g} s.",
                     end, counted(events.impacts, "impact"), first);
}

/// What stands behind the numbers, and how long they mean something.
void add_draws(const std::vector<Run>& runs, const ComparedScene& scene,
               std::vector<std::string>& sentences) {
  double draws = 1;
  for (const Run& run : runs)
    if (run.draws > draws) draws = run.draws;
  if (draws > 1)
    sentences.push_back(fmt::format(
        "Numbers of engines are medians of up to {} replicates: steps and scenes that hardly differ.",
        draws));
  if (std::isnan(scene.predictable_time) || runs.empty()) return;
  sentences.push_back(
      fmt::format("Two exact motions that differ in the sixth digit stay together until {:.4g} s: "
                  "later differences say nothing about an engine.",
                  scene.predictable_time));
}

void add_nearest(const std::vector<Run>& runs, std::vector<std::string>& sentences) {
  const auto rms = [](const Run& run) { return run.rms_angle_difference; };
  const auto reversed_rms = [](const Run& run) { return -run.rms_angle_difference; };
  const Run* nearest = least(runs, rms);
  const Run* furthest = least(runs, reversed_rms);
  if (!nearest) return;
  sentences.push_back(fmt::format("Nearest to it is {}, with an RMS angle difference of {:.3g} rad.",
                                  run_phrase(*nearest), nearest->rms_angle_difference));
  if (furthest != nearest)
    sentences.push_back(fmt::format("Furthest from it is {}, with {:.3g} rad.", run_phrase(*furthest),
                                    furthest->rms_angle_difference));
}

void add_slips(const std::vector<Run>& runs, std::vector<std::string>& sentences) {
  const Run* nearest = least(runs, [](const Run& run) { return run.slip_error; });
  const Run* furthest = least(runs, [](const Run& run) { return -run.slip_error; });
  if (!nearest || furthest->slip_error == 0) return;
  sentences.push_back(
      fmt::format("Slips are within {:.3g} m with {}", nearest->slip_error, run_phrase(*nearest)));
  sentences.back() += furthest == nearest ? "."
                                          : fmt::format(", and within {:.3g} m with {}.",
                                                        furthest->slip_error, run_phrase(*furthest));
}

void add_agreement(const Comparison& comparison, const std::vector<Run>& runs,
                   std::vector<std::string>& sentences) {
  const Run* longest = least(runs, [](const Run& run) { return -run.agreement_time; });
  const Run* shortest = least(runs, [](const Run& run) { return run.agreement_time; });
  if (!longest) return;
  const auto as_long = std::count_if(runs.begin(), runs.end(), [&](const Run& run) {
    return is_engine(run) && run.agreement_time == longest->agreement_time;
  });
  const std::string who = as_long > 1 ? fmt::format("{} runs", as_long) : run_phrase(*longest);
  sentences.push_back(fmt::format("Within {:.3g} rad of it in every angle: {} for longest, until {:.4g} s",
                                  comparison.tolerance, who, longest->agreement_time));
  sentences.back() += shortest->agreement_time == longest->agreement_time
                          ? "."
                          : fmt::format("; {} for shortest, until {:.4g} s.", run_phrase(*shortest),
                                        shortest->agreement_time);
}

void add_first_impact(const std::vector<Run>& runs, std::vector<std::string>& sentences) {
  const auto size = [](const Run& run) { return std::abs(run.first_impact_time_difference); };
  const auto reversed = [&](const Run& run) { return -size(run); };
  const Run* nearest = least(runs, size);
  const Run* furthest = least(runs, reversed);
  if (!nearest) return;
  const auto words = [](const Run& run) {
    const double late = run.first_impact_time_difference;
    return late == 0 ? std::string("on time")
                     : duration_text(std::abs(late)) + (late > 0 ? " late" : " early");
  };
  sentences.push_back(
      fmt::format("The first impact comes nearest with {}, {}", run_phrase(*nearest), words(*nearest)));
  sentences.back() += furthest == nearest
                          ? "."
                          : fmt::format("; furthest with {}, {}.", run_phrase(*furthest), words(*furthest));
}

void add_impacts(const std::vector<Run>& runs, std::vector<std::string>& sentences) {
  std::size_t compared = 0, all = 0;
  for (const Run& run : runs) {
    if (!is_engine(run) || std::isnan(run.impacts_missed)) continue;
    ++compared;
    if (run.impacts_missed == 0 && run.impacts_extra == 0) ++all;
  }
  if (compared > 0)
    sentences.push_back(fmt::format("Of {}, {} the exact sequence of impacts, none missed and none extra.",
                                    counted(compared, "engine run"),
                                    all == 0   ? "none has"
                                    : all == 1 ? "1 has"
                                               : fmt::format("{} have", all)));
}

/// How many runs stay with the exact motion to their end, and how many do not.
void add_agreeing(const Comparison& comparison, std::vector<std::string>& sentences) {
  std::size_t compared = 0, agreeing = 0;
  for (const Run& run : comparison.runs) {
    if (!is_engine(run) || std::isnan(run.largest_angle_difference)) continue;
    ++compared;
    if (run.largest_angle_difference <= comparison.tolerance) ++agreeing;
  }
  if (compared == 0) return;
  sentences.push_back(fmt::format(
      "Of {} compared with the exact motion, {} every angle within {:.3g} rad of it to the end, {} not.",
      counted(compared, "engine run"), agreeing == 1 ? "1 keeps" : fmt::format("{} keep", agreeing),
      comparison.tolerance, compared - agreeing == 1 ? "1 does" : fmt::format("{} do", compared - agreeing)));
}

}  // namespace

std::vector<std::string> summary(const Comparison& comparison) {
  std::size_t failed = 0;
  for (const Run& run : comparison.runs)
    if (!run.done()) ++failed;
  std::vector<std::string> sentences{
      fmt::format("{} of {}; {} failed.", counted(comparison.runs.size(), "run"),
                  counted(comparison.scenes.size(), "scene"), failed == 0 ? "none" : std::to_string(failed))};
  add_agreeing(comparison, sentences);
  if (!comparison.left_out.empty())
    sentences.push_back(fmt::format("This build leaves out {}.", joined(comparison.left_out)));
  return sentences;
}

std::vector<std::string> summary(const Comparison& comparison, const ComparedScene& scene) {
  const std::vector<Run> runs = done_runs(comparison, scene.name);
  std::vector<std::string> sentences;
  if (!runs.empty() && runs.front().exact()) {
    sentences.push_back(exact_sentence(runs.front(), scene.blocks));
  } else {
    sentences.push_back("There is no exact run to compare with.");
  }
  add_draws(runs, scene, sentences);
  add_nearest(runs, sentences);
  add_slips(runs, sentences);
  add_agreement(comparison, runs, sentences);
  add_first_impact(runs, sentences);
  add_impacts(runs, sentences);
  for (const Run& run : comparison.runs)
    if (run.scene == scene.name && !run.done())
      sentences.push_back(fmt::format("{} failed: {}.", run_phrase(run), run.reason));
  return sentences;
}

}  // namespace rockstack::plots
