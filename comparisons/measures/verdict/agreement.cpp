#include "comparisons/measures/verdict/agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/sentences.hpp"

namespace rockstack {
namespace {

const SceneScale& scale_in(const std::vector<JudgedScene>& scenes, const std::string& name) {
  const auto found = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const JudgedScene& scene) { return scene.name == name; });
  return found->scale;
}

/// When rows of one step stop agreeing.
struct Ends {
  double first = INFINITY, last = 0;  ///< of those that do, s
  bool some_agree = false;
  bool beyond = false;  ///< of these, one up to a horizon that is before its scene's end
};

using EndsOfSteps = std::map<double, Ends, std::greater<>>;

EndsOfSteps ends_of(const std::vector<ReplicatedRow>& rows, const std::vector<JudgedScene>& scenes) {
  EndsOfSteps steps;
  for (const ReplicatedRow& one : rows) {
    if (!can_be_ranked(one)) continue;
    const RunMetrics& row = one.row;
    const SceneScale& scale = scale_in(scenes, row.scene);
    Ends& ends = steps[*row.dt];
    if (agrees(row, scale)) {
      ends.some_agree = true;
      ends.beyond = ends.beyond || row.horizon.value_or(scale.duration) < scale.duration;
    } else {
      ends.first = std::min(ends.first, agreement_end(row, scale));
      ends.last = std::max(ends.last, agreement_end(row, scale));
    }
  }
  return steps;
}

/// The coarsest, the middle one and the finest.
std::vector<double> told_steps(const EndsOfSteps& steps) {
  std::vector<double> all;
  for (const auto& [dt, ends] : steps) all.push_back(dt);
  if (all.size() > 3) all = {all.front(), all[all.size() / 2], all.back()};
  return all;
}

std::string until(const Ends& ends) {
  const std::string first = fmt::format("{:.2g}", ends.first), last = fmt::format("{:.2g}", ends.last);
  if (ends.last == 0 && ends.some_agree) return ends.beyond ? "to the horizon" : "to the end";
  if (ends.some_agree) return fmt::format("until {} s or longer", first);
  return first == last ? fmt::format("until {} s", first) : fmt::format("until {} to {} s", first, last);
}

/// "5.86 s in spanos-synthetic" of each scene that ends before its horizon.
std::string horizons(const std::vector<ReplicatedRow>& rows, const std::vector<JudgedScene>& scenes) {
  std::vector<std::string> texts;
  for (const JudgedScene& scene : scenes) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const ReplicatedRow& one) {
      return one.row.scene == scene.name && can_be_ranked(one);
    });
    if (row == rows.end() || row->row.horizon.value_or(scene.scale.duration) >= scene.scale.duration)
      continue;
    texts.push_back(fmt::format("{} in {}", quantity_text(*row->row.horizon, "s"), scene.name));
  }
  return texts.empty() ? "" : " (the horizon: " + joined(texts) + ")";
}

/// The row of each set in which something happens that does not in the exact motion, with the largest error.
std::vector<const RunMetrics*> rows_with_events(const std::vector<ReplicatedRow>& rows,
                                                const std::vector<JudgedScene>& scenes) {
  std::vector<const RunMetrics*> list;
  for (const ReplicatedRow& one : rows) {
    const RunMetrics& row = one.row;
    if (!is_engine(row) || !row.error || event_of(row, scale_in(scenes, row.scene)).empty()) continue;
    const auto known = std::find_if(list.begin(), list.end(), [&](const RunMetrics* other) {
      return other->scene == row.scene && set_name(*other) == set_name(row);
    });
    if (known == list.end()) {
      list.push_back(&row);
    } else if (*row.error > *(*known)->error) {
      *known = &row;
    }
  }
  return list;
}

}  // namespace

std::string agreement_sentence(const std::vector<ReplicatedRow>& rows,
                               const std::vector<JudgedScene>& scenes) {
  const EndsOfSteps steps = ends_of(rows, scenes);
  if (steps.empty()) return "";
  std::vector<std::string> parts;
  for (const double dt : told_steps(steps))
    parts.push_back(fmt::format("{} at a step of {}", until(steps.at(dt)), quantity_text(dt, "s")));
  const double tolerance = scenes.front().scale.tolerance;
  return fmt::format("Engines stay within {} and {:g} % of the least block height of the exact motion {}{}.",
                     quantity_text(tolerance, "rad"), 100 * tolerance,
                     fmt::format("{}", fmt::join(parts, ", ")), horizons(rows, scenes));
}

std::string event_sentence(const std::vector<ReplicatedRow>& rows, const std::vector<JudgedScene>& scenes,
                           std::size_t most) {
  const std::vector<const RunMetrics*> events = rows_with_events(rows, scenes);
  if (events.empty()) return "";
  if (events.size() > most)
    return fmt::format("In {} blocks sink, fall or topple otherwise than exactly.",
                       counted(events.size(), "set"));
  std::vector<std::string> parts;
  for (const RunMetrics* row : events) {
    const std::string event = event_of(*row, scale_in(scenes, row->scene));
    const char* subject = event.starts_with("block") ? "" : event.starts_with("sinks") ? "a block " : "it ";
    parts.push_back(fmt::format("with {} in {} at {} {}{}", set_name(*row), row->scene,
                                quantity_text(*row->dt, "s"), subject, event));
  }
  parts.front().front() = 'W';
  return fmt::format("{}.", fmt::join(parts, "; "));
}

}  // namespace rockstack
