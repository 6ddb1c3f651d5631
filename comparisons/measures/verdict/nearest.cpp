#include "comparisons/measures/verdict/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/verdict/outcome.hpp"

namespace rockstack {
namespace {

constexpr std::size_t most_named = 3;  ///< sets, or scenes, that a sentence names

/// Sets that share the first rank, in one scene or several.
struct First {
  std::vector<std::string> sets;
  std::vector<std::string> scenes;
  bool all = false;  ///< nothing is told apart
};

std::vector<ReplicatedRow> rows_of(const std::vector<ReplicatedRow>& rows, const std::string& scene) {
  std::vector<ReplicatedRow> own;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(own),
               [&](const ReplicatedRow& one) { return one.row.scene == scene; });
  return own;
}

First first_of(const std::vector<RankedSet>& ranking) {
  First first;
  for (const RankedSet& set : ranking)
    if (set.rank == 1) first.sets.push_back(set_name(set.engine, set.solver, set.settings));
  first.all = first.sets.size() == ranking.size();
  return first;
}

/// Scenes by who is first in them.
std::vector<First> firsts_of(const std::vector<ReplicatedRow>& rows, const std::vector<std::string>& scenes) {
  std::vector<First> list;
  for (const std::string& scene : scenes) {
    const std::vector<RankedSet> ranking = rank_all(rows_of(rows, scene));
    if (ranking.empty()) continue;
    First first = first_of(ranking);
    const auto known =
        std::find_if(list.begin(), list.end(), [&](const First& one) { return one.sets == first.sets; });
    if (known != list.end()) {
      known->scenes.push_back(scene);
    } else {
      first.scenes = {scene};
      list.push_back(first);
    }
  }
  return list;
}

/// What rows' errors are of: "21 replicates", "5 to 15 replicates", "one run each".
std::string evidence(const std::vector<ReplicatedRow>& rows) {
  std::set<std::size_t> counts;
  for (const ReplicatedRow& one : rows)
    if (can_be_ranked(one)) counts.insert(one.errors.size());
  if (counts.empty() || *counts.rbegin() < 2) return "one run each";
  return *counts.begin() == *counts.rbegin()
             ? fmt::format("{} replicates", *counts.begin())
             : fmt::format("{} to {} replicates", *counts.begin(), *counts.rbegin());
}

/// Of a scene among others.
std::string place(const First& first) {
  return first.scenes.empty() ? "" : "in " + joined(first.scenes) + " ";
}

std::string part(const First& first, const std::string& by) {
  if (first.sets.size() == 1) return place(first) + first.sets[0] + " is nearest to the exact motion";
  if (first.all) return place(first) + "no set can be told to be nearest, by " + by;
  return fmt::format("{}{} are nearest and cannot be told apart by {}", place(first),
                     joined_up_to(most_named, first.sets), by);
}

/// The last set, where all others are shown to be nearer.
std::string furthest(const std::vector<RankedSet>& ranking) {
  const RankedSet& last = ranking.back();
  if (ranking.size() < 2 || last.rank != static_cast<int>(ranking.size())) return "";
  return fmt::format("; {} is furthest, its errors {:.2g} times the least in the mean",
                     set_name(last.engine, last.solver, last.settings), last.score);
}

/// A ranking of one step needs no word of it.
std::string over_steps(const std::vector<ReplicatedRow>& rows) {
  std::set<double> steps;
  for (const ReplicatedRow& one : rows)
    if (can_be_ranked(one)) steps.insert(*one.row.dt);
  return steps.size() > 1 ? "over all steps " : "";
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

/// Of more scenes than are told one by one.
std::string over_all(const std::vector<ReplicatedRow>& rows, const std::vector<RankedSet>& ranking,
                     const std::vector<First>& firsts, std::size_t scenes) {
  First first = first_of(ranking);
  first.scenes = {fmt::format("the ranking over {} scenes that move", scenes)};
  std::string text = part(first, evidence(rows));
  for (const First& one : firsts) {
    if (one.sets != first.sets || first.sets.size() > 1) continue;
    text += " (alone first in " + joined(one.scenes) + ")";
  }
  return text;
}

}  // namespace

std::string nearest_sentence(const std::vector<ReplicatedRow>& rows, const std::vector<std::string>& scenes) {
  const std::vector<RankedSet> ranking = rank_all(rows);
  if (ranking.size() < 2) return "";
  std::vector<First> firsts = firsts_of(rows, scenes);
  if (scenes.size() == 1) firsts.front().scenes.clear();
  std::size_t moving = 0;
  for (const First& one : firsts) moving += one.scenes.size();
  std::string text;
  if (moving > most_named) {
    text = over_all(rows, ranking, firsts, moving);
  } else {
    for (const First& one : firsts) text += (text.empty() ? "" : "; ") + part(one, evidence(rows));
  }
  return capitalised(over_steps(rows) + text) + furthest(ranking) + ".";
}

}  // namespace rockstack
