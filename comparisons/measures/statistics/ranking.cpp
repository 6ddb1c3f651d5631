#include "comparisons/measures/statistics/ranking.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "analytic/scene/lists.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/statistics/joint_test.hpp"
#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {
namespace {

constexpr double failure_ratio = 100;
/// Errors that are less are rounding, and all alike.
constexpr double least_error = 1e-12;

using Cell = std::pair<std::string, double>;  ///< scene and step
using Name = std::tuple<std::string, std::string, std::string>;

/// Error of one set in one cell.
struct Error {
  double median = 0;  ///< infinite where its run is not done
  std::vector<double> replicates;
};

using Errors = std::map<Cell, Error>;
using Sets = std::map<Name, Errors>;

Sets sets_of(const std::vector<ReplicatedRow>& all) {
  const std::vector<ReplicatedRow> rows = rows_that_count(all);
  std::set<std::string> moving;  // scenes
  for (const ReplicatedRow& one : rows)
    if (can_be_ranked(one)) moving.insert(one.scene);
  Sets sets;
  for (const ReplicatedRow& row : rows) {
    if (!row.dt || row.settings.empty() || !moving.contains(row.scene)) continue;
    Error error{INFINITY, {INFINITY}};
    if (row.status == RunStatus::done && row.error) error = {std::max(*row.error, least_error), row.errors};
    for (double& value : error.replicates) value = std::max(value, least_error);
    sets[{row.engine, row.solver, row.settings}][{row.scene, *row.dt}] = std::move(error);
  }
  return sets;
}

/// The least error of any set in each cell where one is done.
std::map<Cell, double> least_errors(const Sets& sets) {
  std::map<Cell, double> least;
  for (const auto& [name, errors] : sets)
    for (const auto& [cell, error] : errors) {
      if (!std::isfinite(error.median)) continue;
      double& known = least.try_emplace(cell, error.median).first->second;
      known = std::min(known, error.median);
    }
  return least;
}

RankedSet score(const Name& name, const Errors& errors, const std::map<Cell, double>& least) {
  RankedSet set;
  std::tie(set.engine, set.solver, set.settings) = name;
  double sum = 0;
  for (const auto& [cell, best] : least) {
    const auto own = errors.find(cell);
    if (own == errors.end()) continue;
    const bool done = std::isfinite(own->second.median);
    const double ratio = done ? own->second.median / best : failure_ratio;
    ++set.cells;
    set.failed += done ? 0 : 1;
    set.worst = std::max(set.worst, ratio);
    sum += std::log(ratio);
  }
  set.score = set.cells > 0 ? std::exp(sum / set.cells) : 0;
  return set;
}

/// What replicates say of a pair: a superiority above one half speaks for the first as the nearer one.
MannWhitney test_of(const Errors& first, const Errors& second) {
  std::vector<Stratum> strata;
  for (const auto& [cell, error] : first)
    if (const auto other = second.find(cell); other != second.end())
      strata.push_back({error.replicates, other->second.replicates});
  return strata.empty() ? MannWhitney{} : mann_whitney(strata);
}

/// Gives ranks to sets in the order of their scores: one more than how many fail in fewer cells, or in as
/// many and are shown to be nearer.
void rank(const Sets& sets, std::vector<RankedSet>& list) {
  const auto errors_of = [&](const RankedSet& set) -> const Errors& {
    return sets.at({set.engine, set.solver, set.settings});
  };
  for (RankedSet& set : list)
    set.rank = 1 + static_cast<int>(std::ranges::count_if(
                       list, [&](const RankedSet& other) { return other.failed < set.failed; }));
  std::vector<MannWhitney> tests;
  for (std::size_t j = 1; j < list.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) tests.push_back(test_of(errors_of(list[i]), errors_of(list[j])));
  const std::vector<double> p_values = adjust({tests.begin(), tests.end()}, separation_level).p_values;
  for (std::size_t j = 0, pair = 0; j < list.size(); ++j)
    for (std::size_t i = 0; i < j; ++i, ++pair)
      if (list[i].failed == list[j].failed && p_values[pair] <= separation_level &&
          tests[pair].superiority > 0.5)
        ++list[j].rank;
}

std::vector<RankedSet> ranked(const Sets& sets) {
  const std::map<Cell, double> least = least_errors(sets);
  std::vector<RankedSet> list;
  for (const auto& [name, errors] : sets) list.push_back(score(name, errors, least));
  std::erase_if(list, [](const RankedSet& set) { return set.cells == 0; });
  std::ranges::stable_sort(list, {}, &RankedSet::score);
  rank(sets, list);
  return list;
}

}  // namespace

bool can_be_ranked(const RunMetrics& row) {
  return row.dt && !row.settings.empty() && row.status == RunStatus::done && row.error &&
         row.motion.value_or(0) > rest_extent;
}

std::vector<ReplicatedRow> rows_that_count(std::vector<ReplicatedRow> rows) {
  const auto is_single = [](const ReplicatedRow& one) { return one.errors.size() < 2; };
  const auto is_done = [](const ReplicatedRow& one) { return one.status == RunStatus::done; };
  if (!std::ranges::all_of(rows, is_single))
    std::erase_if(rows, [&](const ReplicatedRow& one) { return is_single(one) && is_done(one); });
  return rows;
}

int replicates_that_tell_apart(std::size_t sets, std::size_t steps) {
  const double pairs = static_cast<double>(sets) * (static_cast<double>(sets) - 1) / 2;
  int n = 5;
  double ways = 252;
  while (pairs * 2 / std::pow(ways, steps) > separation_level) {
    ++n;
    ways *= 2 * (2.0 * n - 1) / n;
  }
  return std::max(n, replicates_that_show_changes(std::vector(sets, steps), change_level));
}

std::vector<bool> sets_that_can_change(const std::vector<std::vector<int>>& sets, double level) {
  std::vector<TestChance> tests;  // of all sets, then of their rows
  const auto add = [&](double logarithm) {
    tests.push_back({.least_p_value = std::min(1.0, 2 * std::exp(-logarithm))});
  };
  const auto ways = [](int n) {  // ln((2n)!/n!²)
    double sum = 0;
    for (int i = 1; i <= n; ++i) sum += std::log1p(static_cast<double>(n) / i);
    return sum;
  };
  for (const std::vector<int>& rows : sets) {
    double all = 0;
    for (const int replicates : rows) all += replicates > 1 ? ways(replicates) : 0;
    add(all);
  }
  for (const std::vector<int>& rows : sets)
    for (const int replicates : rows)
      if (rows.size() > 1 && replicates > 1) add(ways(replicates));
  std::vector<bool> shown = could_show(std::move(tests), foremost_share * level);
  std::size_t row = sets.size();
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (const int replicates : sets[i])
      if (sets[i].size() > 1 && replicates > 1 && shown[row++]) shown[i] = true;
  shown.resize(sets.size());
  return shown;
}

int replicates_that_show_changes(const std::vector<std::size_t>& rows_of_sets, double level) {
  for (int n = 2;; ++n) {
    const auto sets = mapped(rows_of_sets, [n](std::size_t rows) { return std::vector(rows, n); });
    const std::vector<bool> shown = sets_that_can_change(sets, level);
    if (std::ranges::find(shown, false) == shown.end()) return n;
  }
}

int replicates_that_decide(std::size_t numbers, double level) {
  std::size_t n = 2;
  const double share = (1 - foremost_share) * level;
  while (least_joint_chance(n, n) * static_cast<double>(numbers) > share) ++n;
  return static_cast<int>(n);
}

std::vector<RankedSet> rank_all(const std::vector<ReplicatedRow>& rows) {
  return ranked(sets_of(rows));
}

std::vector<RankedSet> rank_sets(const std::vector<ReplicatedRow>& rows) {
  std::map<std::pair<std::string, std::string>, Sets> solvers;
  for (auto& [name, errors] : sets_of(rows))
    solvers[{std::get<0>(name), std::get<1>(name)}].emplace(name, errors);
  std::vector<RankedSet> ranking;
  for (const auto& [solver, sets] : solvers) {
    if (sets.size() < 2) continue;
    const std::vector<RankedSet> own = ranked(sets);
    ranking.insert(ranking.end(), own.begin(), own.end());
  }
  return ranking;
}

void to_json(Json& json, const RankedSet& set) {
  json = {{"rank", set.rank},   {"engine", set.engine}, {"solver", set.solver}, {"settings", set.settings},
          {"score", set.score}, {"worst", set.worst},   {"cells", set.cells},   {"failed", set.failed}};
}

void from_json(const Json& json, RankedSet& set) {
  set = {json.at("engine"), json.at("solver"), json.at("settings"), json.at("rank"),
         json.at("score"),  json.at("worst"),  json.at("cells"),    json.at("failed")};
}

std::string ranking_csv(const std::vector<RankedSet>& sets) {
  CsvWriter csv;
  csv.line("engine", "solver", "rank", "settings", "score", "worst", "cells", "failed");
  for (const RankedSet& set : sets)
    csv.line(set.engine, set.solver, set.rank, set.settings, set.score, set.worst, set.cells, set.failed);
  return csv.text();
}

}  // namespace rockstack
