#include "comparisons/measures/verdict/verdict.hpp"

#include <fmt/format.h>

#include <set>
#include <tuple>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/sentences.hpp"

namespace rockstack {
namespace {

/// When rows of one step stop agreeing.
struct AgreementEnds {
  std::vector<double> times;  ///< s, infinite where they do not
  bool beyond = false;        ///< of these, one up to a horizon that is before its scene's end
};

/// After how long engines leave the exact motion. Of many runs the first says little: how many do, and where
/// half of all do, by when these have. The times of fewer say nothing: those that leave at a fine step leave
/// soon.
std::string leaving(AgreementEnds ends) {
  constexpr std::size_t many = 8;
  std::ranges::sort(ends.times);
  const auto leave = static_cast<std::size_t>(
      std::ranges::count_if(ends.times, [](double time) { return std::isfinite(time); }));
  const char* const stays = ends.beyond ? "not before the horizon" : "not at all";
  // They agree up to the lower time, and have left by the upper one.
  const auto after = [](double time) { return fmt::format("{:.2g}", two_digits_down(time)); };
  const auto by = [](double time) { return fmt::format("{:.2g}", two_digits_up(time)); };
  if (leave == 0) return stays;
  const double first = ends.times.front(), last = ends.times[leave - 1];
  const std::size_t all = ends.times.size(), half = (all + 1) / 2;
  if (all > many)
    return fmt::format(
        "in {} of {} runs{}", leave, all,
        half > leave ? "" : fmt::format(", half of the {} by {} s", all, by(ends.times[half - 1])));
  return fmt::format("after {}{} s{}", after(first), after(first) == after(last) ? "" : " to " + after(last),
                     leave < all ? fmt::format(" or {}", stays) : "");
}

/// "5.86 s in spanos-synthetic" of each scene that ends before its horizon.
std::string horizons(const std::vector<ReplicatedRow>& rows, const std::vector<JudgedScene>& scenes) {
  std::vector<std::string> texts;
  for (const JudgedScene& scene : scenes) {
    const auto row = std::ranges::find_if(
        rows, [&](const ReplicatedRow& one) { return one.scene == scene.name && can_be_ranked(one); });
    if (row == rows.end() || row->horizon.value_or(scene.duration) >= scene.duration) continue;
    texts.push_back(fmt::format("{} in {}", quantity_text(*row->horizon, "s"), scene.name));
  }
  return texts.empty() ? "" : " (the horizon: " + joined(texts) + ")";
}

constexpr std::size_t most_named = 3;  ///< sets, or scenes, that a sentence names

/// Sets that share the first rank, in one scene or several.
struct First {
  std::vector<std::string> sets;
  std::vector<std::string> scenes;
  bool all = false;   ///< nothing is told apart
  std::string steps;  ///< alone_at_steps()
};

First first_of(const std::vector<RankedSet>& ranking) {
  First first;
  for (const RankedSet& set : ranking)
    if (set.rank == 1) first.sets.push_back(set_name(set));
  first.all = first.sets.size() == ranking.size();
  return first;
}

/// Who is alone nearest at single steps, of several that are nearest over all of them.
std::string alone_at_steps(const std::vector<ReplicatedRow>& rows) {
  std::map<double, std::vector<ReplicatedRow>, std::greater<>> steps;
  for (const ReplicatedRow& one : rows)
    if (one.dt) steps[*one.dt].push_back(one);
  std::vector<std::string> texts;
  for (const auto& [dt, own] : steps) {
    const First first = first_of(rank_all(own));
    if (first.all || first.sets.size() != 1) continue;
    texts.push_back(fmt::format("at {} it is {}", quantity_text(dt, "s"), first.sets[0]));
  }
  return texts.empty() ? "" : ", but " + joined(texts) + " alone";
}

/// Scenes by who is first in them.
std::vector<First> firsts_of(const std::vector<ReplicatedRow>& rows, const std::vector<JudgedScene>& scenes) {
  std::vector<First> list;
  for (const JudgedScene& scene : scenes) {
    const std::vector<ReplicatedRow> own = rows_of(rows, scene);
    const std::vector<RankedSet> ranking = rank_all(own);
    if (ranking.empty()) continue;
    First first = first_of(ranking);
    if (first.sets.size() > 1) first.steps = alone_at_steps(own);
    const auto same = [&](const First& other) {
      return std::tie(first.sets, first.steps) == std::tie(other.sets, other.steps);
    };
    found_or_added(list, same, first).scenes.push_back(scene.name);
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

std::string part(const First& first, const std::string& by) {
  const std::string place = first.scenes.empty() ? "" : "in " + joined(first.scenes) + " ";
  if (first.sets.size() == 1) return place + first.sets[0] + " is nearest to the exact motion";
  if (first.all) return fmt::format("{}{} cannot tell which set is nearest{}", place, by, first.steps);
  return fmt::format("{}{} are nearest, which {} cannot tell apart{}", place,
                     joined_up_to(most_named, first.sets), by, first.steps);
}

/// The sets to which most others are shown to be nearer, where these are half of all or more; `over`: which
/// scenes, where words before speak of one.
std::string furthest(const std::vector<RankedSet>& ranking, const std::string& over) {
  const RankedSet& last = *std::ranges::max_element(ranking, {}, &RankedSet::rank);
  const std::size_t others = ranking.size() - 1, nearer = static_cast<std::size_t>(last.rank) - 1;
  std::vector<std::string> sets, failing;
  int failed = 0;
  for (const RankedSet& set : ranking) {
    if (set.rank != last.rank) continue;
    sets.push_back(set_name(set));
    if (set.failed > 0) failing.push_back(sets.back());
    failed += set.failed;
  }
  if (2 * nearer < others) return "";
  if (!failing.empty())
    return fmt::format("; {}{} {} in {}", over, joined_up_to(most_named, failing),
                       failing.size() == 1 ? "fails" : "fail",
                       counted(static_cast<std::size_t>(failed), "run"));
  if (nearer < others)
    return fmt::format("; {}furthest {} {}: {} of the {} other sets are nearer", over,
                       sets.size() == 1 ? "is" : "are", joined_up_to(most_named, sets), nearer, others);
  return fmt::format(
      "; {}{} is furthest: {:.2g} times the least error of a scene and step, in the geometric mean", over,
      set_name(last), last.score);
}

/// A ranking of one step needs no word of it.
std::string over_steps(const std::vector<ReplicatedRow>& rows) {
  std::set<double> steps;
  for (const ReplicatedRow& one : rows)
    if (can_be_ranked(one)) steps.insert(*one.dt);
  return steps.size() > 1 ? "over all steps together " : "";
}

/// Headline of more scenes than are told one by one.
std::string over_all(const std::vector<ReplicatedRow>& rows, const std::vector<RankedSet>& ranking,
                     const std::vector<First>& firsts, std::size_t scenes) {
  First first = first_of(ranking);
  first.scenes = {fmt::format("the ranking over {} scenes that move,", scenes)};
  std::string text = part(first, evidence(rows));
  for (const First& one : firsts)
    if (one.sets == first.sets && one.sets.size() == 1)
      text += " (alone first in " + joined(one.scenes) + ")";
  return text;
}

}  // namespace

std::vector<ReplicatedRow> rows_of(std::vector<ReplicatedRow> rows, const JudgedScene& scene) {
  std::erase_if(rows, [&](const ReplicatedRow& one) { return one.scene != scene.name; });
  return rows;
}

std::string agreement_sentence(const std::vector<ReplicatedRow>& rows,
                               const std::vector<JudgedScene>& scenes) {
  std::map<double, AgreementEnds, std::greater<>> steps;
  for (const ReplicatedRow& row : rows) {
    if (!can_be_ranked(row)) continue;
    const JudgedScene& scene = part_named(scenes, row.scene);
    AgreementEnds& ends = steps[*row.dt];
    const bool whole = agrees(row, scene);
    ends.times.push_back(whole ? INFINITY : agreement_end(row, scene));
    ends.beyond = ends.beyond || (whole && row.horizon.value_or(scene.duration) < scene.duration);
  }
  if (steps.empty()) return "";
  std::vector<double> reported = mapped(steps, [](const auto& step) { return step.first; });
  if (reported.size() > 3) reported = {reported.front(), reported[reported.size() / 2], reported.back()};
  const auto told = [&](double dt) { return quantity_text(dt, "s") + " " + leaving(steps.at(dt)); };
  const double tolerance = scenes.front().tolerance;
  const bool of_replicates =
      std::ranges::any_of(rows, [](const ReplicatedRow& one) { return one.errors.size() > 1; });
  return fmt::format(
      "Engines leave the exact motion at a time step of {}{}; to leave it is to be off by more than {} or {:g} % of the least block "
      "height{}.",
      joined_texts(reported, told, "; at "), horizons(rows, scenes), quantity_text(tolerance, "rad"),
      100 * tolerance, of_replicates ? ", in the median of replicates" : "");
}

std::string nearest_sentence(const std::vector<ReplicatedRow>& all, const std::vector<JudgedScene>& scenes) {
  const std::vector<ReplicatedRow> rows = rows_that_count(all);
  const std::vector<RankedSet> ranking = rank_all(rows);
  if (ranking.size() < 2) return "";
  std::vector<First> firsts = firsts_of(rows, scenes);
  if (scenes.size() == 1) firsts.front().scenes.clear();
  std::size_t moving = 0;
  for (const First& one : firsts) moving += one.scenes.size();
  const auto told = [&](const First& first) { return part(first, evidence(rows)); };
  const std::string text =
      moving > most_named ? over_all(rows, ranking, firsts, moving) : joined_texts(firsts, told, "; ");
  const bool one_by_one = moving > 1 && moving <= most_named;
  return capitalised(over_steps(rows) + text) +
         furthest(ranking, one_by_one ? fmt::format("over these {} scenes ", moving) : "") + ".";
}

}  // namespace rockstack
