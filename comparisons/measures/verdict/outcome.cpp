#include "comparisons/measures/verdict/verdict.hpp"

#include <fmt/format.h>

#include <set>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/results/sentences.hpp"

// What becomes of a run: what happens in engines and not in the exact motion, and whether they agree.

namespace rockstack {
namespace {

constexpr std::size_t most_sets = 1;  ///< that a sentence names of more than two

std::string fall_of(const RunMetrics& row) {
  if (row.toppling_verdict == TopplingVerdict::exact_alone)
    return "stands, though in the exact motion a block falls";
  if (row.toppling_verdict != TopplingVerdict::engine_alone) return "";
  return row.fallen.empty() ? with_verb(row.toppled, "topples") : with_verb(row.fallen, "has fallen off");
}

/// How deep a block has sunk in.
struct Sunk {
  double depth = 0;    ///< m
  bool stays = false;  ///< to the end, not for a moment
};

/// Where it stays so by more than told_sinking of the least block height, or is deeper by the tolerance for a
/// moment; nought elsewhere.
Sunk sunk_in(const RunMetrics& row, const JudgedScene& scene) {
  const double off = row.largest_position_difference.value_or(0);
  const double at_the_end = std::min(row.sinking.value_or(0), off);
  const double deepest = std::min(row.penetration.value_or(0), off);
  if (deepest > scene.tolerance * scene.least_height && deepest > 2 * at_the_end) return {deepest, false};
  if (at_the_end > told_sinking * scene.least_height) return {at_the_end, true};
  return {};
}

/// The row of each set in which something happens that does not in the exact motion, with the largest error.
std::vector<const RunMetrics*> rows_with_events(const std::vector<ReplicatedRow>& rows,
                                                const std::vector<JudgedScene>& scenes) {
  std::vector<const RunMetrics*> list;
  for (const RunMetrics& row : rows) {
    if (!is_engine(row) || !row.error || event_of(row, part_named(scenes, row.scene)).empty()) continue;
    const auto same = [&](const RunMetrics* other) {
      return other->scene == row.scene && set_name(*other) == set_name(row);
    };
    const RunMetrics*& worst = found_or_added(list, same, &row);
    if (*row.error > *worst->error) worst = &row;
  }
  return list;
}

/// Which sets have events of each kind, and how deep blocks sink in and how high they rise at most.
std::string counted_events(const std::vector<const RunMetrics*>& events,
                           const std::vector<JudgedScene>& scenes) {
  std::map<std::string, std::set<std::string>> sets;  // by what happens
  double deepest = 0, highest = 0;
  for (const RunMetrics* row : events) {
    const std::string event = event_of(*row, part_named(scenes, row->scene));
    const std::string verb = event.substr(0, event.find_first_of(" ,"));
    if (verb == "sinks") deepest = std::max(deepest, sunk_in(*row, part_named(scenes, row->scene)).depth);
    if (verb == "rises") highest = std::max(highest, row->gap.value_or(0));
    sets[verb == "block" ? "falls" : verb].insert(set_name(*row));
  }
  std::vector<std::string> parts;
  const auto add = [&](const char* verb, const std::string& what) {
    if (const auto& own = sets[verb]; !own.empty())
      parts.push_back(fmt::format("with {}, {}", joined_up_to(most_sets, {own.begin(), own.end()}), what));
  };
  add("falls", "blocks fall or topple that do not in the exact motion");
  add("stands", "blocks stand that fall in the exact motion");
  add("topples", "some replicates topple otherwise than the exact motion");
  add("sinks", fmt::format("blocks sink in, by {} at most", quantity_text(deepest, "m", 2)));
  add("rises", fmt::format("blocks rise that do not lift off in the exact motion, by {} at most",
                           quantity_text(highest, "m", 2)));
  return capitalised(fmt::format("{}.", fmt::join(parts, "; ")));
}

std::string at_rest(const RunMetrics& row, const JudgedScene& scene, const std::string& event) {
  const bool turns = row.largest_angle_difference.value_or(0) > scene.tolerance;
  const bool sinks = event.starts_with("sinks");
  if (!event.empty() && !(sinks && !turns)) return event;
  if (sinks) return "rests, but " + event;
  if (row.gap.value_or(0) > scene.tolerance * scene.least_height)
    return "does not rest: rises by " + quantity_text(*row.gap, "m", 2);
  const std::string off = quantity_text(row.largest_position_difference.value_or(0), "m", 2) + " off";
  if (turns)
    return fmt::format("does not rest: {} and {}", quantity_text(*row.largest_angle_difference, "rad", 2),
                       off);
  return agrees(row, scene) ? "rests" : "rests, but is " + off;
}

}  // namespace

std::string event_of(const RunMetrics& row, const JudgedScene& scene) {
  // In how many runs it topples otherwise, where not in all or none.
  const int other = row.draws_other_verdict.value_or(0), all = row.draws.value_or(1);
  const std::string replicates =
      other > 0 && other < all ? fmt::format("in {} of {} replicates", other, all) : "";
  if (const std::string fall = fall_of(row); !fall.empty())
    return replicates.empty() ? fall : fall + ", " + replicates;
  if (!replicates.empty()) return "topples otherwise " + replicates;
  if (const auto [depth, stays] = sunk_in(row, scene); depth > 0)
    return "sinks in by " + quantity_text(depth, "m", 2) + (stays ? "" : " for a moment");
  const bool pivots = row.law == name(Law::paper) || row.law == name(Law::consistent);
  const bool rises = pivots && row.motion > rest_extent && row.gap > scene.tolerance * scene.least_height;
  return rises ? "rises by " + quantity_text(*row.gap, "m", 2) : "";
}

std::string event_sentence(const std::vector<ReplicatedRow>& rows, const std::vector<JudgedScene>& scenes,
                           std::size_t most) {
  const std::vector<const RunMetrics*> events = rows_with_events(rows, scenes);
  if (events.empty()) return "";
  if (events.size() > most) return counted_events(events, scenes);
  const auto told = [&](const RunMetrics* row) {
    const std::string event = event_of(*row, part_named(scenes, row->scene));
    const char* subject = event.starts_with("block")                                 ? ""
                          : event.starts_with("sinks") || event.starts_with("rises") ? "a block "
                                                                                     : "it ";
    return fmt::format("with {} in {} at {} {}{}", set_name(*row), row->scene, quantity_text(*row->dt, "s"),
                       subject, event);
  };
  return capitalised(text_of_each(events, told, "; ")) + ".";
}

std::string with_verb(const std::string& block_and_time, const std::string& verb) {
  const std::size_t at = block_and_time.find(" at ");
  const double time = std::stod(block_and_time.substr(at + 4));
  return block_and_time.substr(0, at) + " " + verb + " at " + quantity_text(time, "s");
}

bool is_engine(const RunMetrics& row) {
  return row.dt && !row.settings.empty() && row.settings != "baseline";
}

std::string set_name(const std::string& engine, const std::string& solver, const std::string& settings) {
  return fmt::format("{}:{} ({})", engine, solver, settings);
}

bool agrees(const RunMetrics& row, const JudgedScene& scene) {
  return row.largest_angle_difference.value_or(0) <= scene.tolerance &&
         row.relative_position_difference.value_or(0) <= scene.tolerance;
}

double agreement_end(const RunMetrics& row, const JudgedScene& scene) {
  const double horizon = row.horizon.value_or(scene.duration);
  if (agrees(row, scene)) return horizon;
  return std::min(
      {horizon, row.agreement_time.value_or(horizon), row.position_agreement_time.value_or(horizon)});
}

std::string outcome(const RunMetrics& row, const JudgedScene& scene) {
  if (row.status != RunStatus::done) return name(row.status) + ": " + row.reason;
  if (!row.error) return "";
  const std::string event = event_of(row, scene);
  if (row.motion && *row.motion <= rest_extent) return at_rest(row, scene, event);
  const double horizon = row.horizon.value_or(scene.duration);
  const std::string until = !agrees(row, scene) ? "until " + quantity_text(agreement_end(row, scene), "s")
                            : horizon < scene.duration ? "to the horizon"
                                                       : "to the end";
  return "agrees " + until + (event.empty() ? "" : "; " + event);
}

}  // namespace rockstack
