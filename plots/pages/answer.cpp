#include "plots/pages/answer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "plots/data/selection.hpp"
#include "plots/pages/sentences.hpp"

namespace rockstack::plots {
namespace {

/// A median and quartiles; the quartiles are NaN where there are too few numbers for them.
struct Spread {
  double lower = 0, median = 0, upper = 0;
};

/// The number below which a share of sorted numbers lies, on straight lines between them.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Spread spread_of(std::vector<double> values) {
  constexpr std::size_t fewest = 3;
  std::sort(values.begin(), values.end());
  if (values.size() < fewest) return {std::nan(""), quantile(values, 0.5), std::nan("")};
  return {quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75)};
}

/// "1.2e-3 rad (quartiles 4e-4 to 2e-3)".
std::string words(const Spread& spread) {
  const std::string median = fmt::format("{:.2g} rad", spread.median);
  return std::isnan(spread.lower)
             ? median
             : fmt::format("{} (quartiles {:.2g} to {:.2g})", median, spread.lower, spread.upper);
}

/// Engine runs that were held against an exact motion.
std::vector<Run> compared_runs(const Comparison& comparison) {
  std::vector<Run> runs;
  for (const Run& run : comparison.runs)
    if (run.done() && !std::isnan(run.dt) && !std::isnan(run.rms_angle_difference)) runs.push_back(run);
  return runs;
}

/// One solver with its settings, at one step over all scenes.
struct Series {
  std::string label;
  Spread error;  ///< rad
};

/// The step that most runs were made at, the smallest of those.
double common_step(const std::vector<Run>& runs) {
  std::map<double, std::size_t> counts;
  for (const Run& run : runs) ++counts[run.dt];
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

/// The label of a run without its step, for the inside of a sentence.
std::string line_phrase(Run run) {
  run.dt = std::nan("");
  return run_phrase(run);
}

/// Series by ascending error, those that have most scenes. That of a series with one run has the quartiles of
/// its draws.
std::vector<Series> series_at(const std::vector<Run>& runs, double dt) {
  std::map<std::string, std::vector<const Run*>> groups;
  for (const Run& run : runs)
    if (run.dt == dt) groups[line_phrase(run)].push_back(&run);
  const auto scenes_of = [](const std::vector<const Run*>& group) {
    std::set<std::string> names;
    for (const Run* run : group) names.insert(run->scene);
    return names.size();
  };
  std::size_t most = 0;
  for (const auto& [label, group] : groups) most = std::max(most, scenes_of(group));
  std::vector<Series> list;
  for (const auto& [label, group] : groups) {
    if (scenes_of(group) < most) continue;
    std::vector<double> errors;
    for (const Run* run : group) errors.push_back(run->rms_angle_difference);
    const Run& first = *group.front();
    list.push_back({label, group.size() > 1 ? spread_of(errors)
                                            : Spread{first.rms_angle_difference_lower, errors.front(),
                                                     first.rms_angle_difference_upper}});
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const Series& a, const Series& b) { return a.error.median < b.error.median; });
  return list;
}

std::string nearest_and_furthest(const std::vector<Run>& runs, std::size_t scenes) {
  const double dt = common_step(runs);
  const std::vector<Series> list = series_at(runs, dt);
  const std::string over = scenes > 1 ? fmt::format(", over {} scenes", scenes) : "";
  std::string text = fmt::format(
      "At a step of {}{}, {} is nearest to the exact motion: its median RMS angle difference is {}",
      duration_text(dt), over, list.front().label, words(list.front().error));
  if (list.size() > 1)
    text += fmt::format("; {} is furthest from it, with {}", list.back().label, words(list.back().error));
  return text + ".";
}

std::string all_runs(const std::vector<Run>& runs) {
  std::vector<double> errors(runs.size());
  std::transform(runs.begin(), runs.end(), errors.begin(),
                 [](const Run& run) { return run.rms_angle_difference; });
  const auto [least, most] = std::minmax_element(errors.begin(), errors.end());
  return fmt::format("Over all {} at all steps the median is {}, from {:.2g} to {:.2g} rad.",
                     counted(runs.size(), "engine run"), words(spread_of(errors)), *least, *most);
}

/// How fast the first impact's error falls with the step, where that was fitted.
std::optional<std::string> order_of_convergence(const Comparison& comparison) {
  std::vector<double> orders;
  for (const Fit& fit : comparison.fits)
    if (fit.holds && fit.quantity == "first_impact_time_difference") orders.push_back(fit.order);
  if (orders.empty()) return std::nullopt;
  const auto [least, most] = std::minmax_element(orders.begin(), orders.end());
  return fmt::format(
      "The error of the first impact falls with the step to the power {:.2f} in the median of "
      "{} fits ({:.2f} to {:.2f}).",
      spread_of(orders).median, orders.size(), *least, *most);
}

/// Shares of perturbed scenes that topple, a sentence a scene.
void add_shares(const Comparison& comparison, std::vector<std::string>& sentences) {
  for (const ComparedScene& scene : comparison.scenes) {
    std::vector<std::string> engines;
    double exact = 0, count = 0;
    for (const Distance& one : comparison.distances) {
      if (one.scene != scene.name || one.quantity != "toppled" || std::isnan(one.exact_mean)) continue;
      exact = one.exact_mean, count = one.exact_runs;
      const auto run = std::find_if(comparison.runs.begin(), comparison.runs.end(),
                                    [&](const Run& each) { return each.name == one.run; });
      const std::string name = run == comparison.runs.end() ? one.run : run_phrase(*run);
      engines.push_back(fmt::format("{:.3g} % with {}{}", 100 * one.mean, name,
                                    one.distance > one.critical ? " – more than chance apart" : ""));
    }
    if (!engines.empty())
      sentences.push_back(fmt::format("Of {} scenes that differ a little {:.3g} % topple exactly, and {}.",
                                      count, 100 * exact, joined(engines)));
  }
}

}  // namespace

std::vector<std::string> answer(const Comparison& comparison) {
  std::vector<std::string> sentences;
  add_shares(comparison, sentences);
  const std::vector<Run> runs = compared_runs(comparison);
  if (!runs.empty()) {
    sentences.push_back(nearest_and_furthest(runs, comparison.scenes.size()));
    if (const auto order = order_of_convergence(comparison)) sentences.push_back(*order);
    if (runs.size() > 1) sentences.push_back(all_runs(runs));
  }
  return sentences;
}

}  // namespace rockstack::plots
