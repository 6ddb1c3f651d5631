#include <fmt/format.h>

#include <set>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/verdict/verdict.hpp"

// What happens in engines and not in the exact motion, in a sentence.

namespace rockstack {
namespace {

constexpr std::size_t most_sets = 3;  ///< that a sentence names

/// The row of each set in which something happens that does not in the exact motion, with the largest error.
std::vector<const RunMetrics*> rows_with_events(const std::vector<ReplicatedRow>& rows,
                                                const std::vector<JudgedScene>& scenes) {
  std::vector<const RunMetrics*> list;
  for (const RunMetrics& row : rows) {
    if (!is_engine(row) || !row.error || event_of(row, scene_in(scenes, row.scene)).empty()) continue;
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
    const std::string event = event_of(*row, scene_in(scenes, row->scene));
    const std::string verb = event.substr(0, event.find_first_of(" ,"));
    if (verb == "sinks") deepest = std::max(deepest, sunk_in(*row, scene_in(scenes, row->scene)).depth);
    if (verb == "rises") highest = std::max(highest, row->gap.value_or(0));
    sets[verb == "sinks" || verb == "rises" || verb == "stands" ? verb : "falls"].insert(set_name(*row));
  }
  std::vector<std::string> parts;
  const auto add = [&](const char* verb, const std::string& what) {
    if (const auto& own = sets[verb]; !own.empty())
      parts.push_back(fmt::format("with {} {}", joined_up_to(most_sets, {own.begin(), own.end()}), what));
  };
  add("falls", "blocks fall or topple that do not in the exact motion");
  add("stands", "blocks stand that fall in the exact motion");
  add("sinks", fmt::format("blocks sink in, by {} at most", quantity_text(deepest, "m", 2)));
  add("rises", fmt::format("blocks rise that do not lift off in the exact motion, by {} at most",
                           quantity_text(highest, "m", 2)));
  return capitalised(fmt::format("{}.", fmt::join(parts, "; ")));
}

}  // namespace

std::string event_sentence(const std::vector<ReplicatedRow>& rows, const std::vector<JudgedScene>& scenes,
                           std::size_t most) {
  const std::vector<const RunMetrics*> events = rows_with_events(rows, scenes);
  if (events.empty()) return "";
  if (events.size() > most) return counted_events(events, scenes);
  const auto told = [&](const RunMetrics* row) {
    const std::string event = event_of(*row, scene_in(scenes, row->scene));
    const char* subject = event.starts_with("block")                                 ? ""
                          : event.starts_with("sinks") || event.starts_with("rises") ? "a block "
                                                                                     : "it ";
    return fmt::format("with {} in {} at {} {}{}", set_name(*row), row->scene, quantity_text(*row->dt, "s"),
                       subject, event);
  };
  return capitalised(text_of_each(events, told, "; ")) + ".";
}

}  // namespace rockstack
