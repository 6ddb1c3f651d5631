#include "comparisons/measures/statistics/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "comparisons/measures/results/csv_writer.hpp"

namespace rockstack {
namespace {

constexpr double failure_ratio = 100;

using Cell = std::pair<std::string, double>;         ///< scene and step
using Errors = std::map<Cell, double>;               ///< of one set; infinite where its run is not done
using Sets = std::map<std::string, Errors>;          ///< of one solver, by their settings
using Solver = std::pair<std::string, std::string>;  ///< engine and solver

/// The least error of any set in each cell where one is done.
Errors least_errors(const Sets& sets) {
  Errors least;
  for (const auto& [settings, errors] : sets) {
    for (const auto& [cell, error] : errors) {
      if (!std::isfinite(error)) continue;
      const auto [known, added] = least.emplace(cell, error);
      if (!added) known->second = std::min(known->second, error);
    }
  }
  return least;
}

RankedSet score(const Errors& errors, const Errors& least) {
  RankedSet set;
  double sum = 0;
  for (const auto& [cell, best] : least) {
    const auto own = errors.find(cell);
    if (own == errors.end()) continue;
    const bool done = std::isfinite(own->second);
    const double ratio = !done ? failure_ratio : best > 0 ? own->second / best : 1;
    ++set.cells;
    set.failed += done ? 0 : 1;
    set.worst = std::max(set.worst, ratio);
    sum += std::log(ratio);
  }
  set.score = set.cells > 0 ? std::exp(sum / set.cells) : 0;
  return set;
}

}  // namespace

std::vector<RankedSet> rank_sets(const std::vector<RunMetrics>& rows) {
  std::map<Solver, Sets> solvers;
  for (const RunMetrics& row : rows) {
    if (!row.dt || row.settings.empty()) continue;
    solvers[{row.engine, row.solver}][row.settings][{row.scene, *row.dt}] =
        row.status == RunStatus::done && row.rms_angle_difference ? *row.rms_angle_difference : INFINITY;
  }
  std::vector<RankedSet> ranking;
  for (const auto& [solver, sets] : solvers) {
    if (sets.size() < 2) continue;
    const Errors least = least_errors(sets);
    std::vector<RankedSet> own;
    for (const auto& [settings, errors] : sets) {
      own.push_back(score(errors, least));
      std::tie(own.back().engine, own.back().solver) = solver;
      own.back().settings = settings;
    }
    std::stable_sort(own.begin(), own.end(),
                     [](const RankedSet& a, const RankedSet& b) { return a.score < b.score; });
    for (std::size_t i = 0; i < own.size(); ++i) own[i].rank = static_cast<int>(i) + 1;
    ranking.insert(ranking.end(), own.begin(), own.end());
  }
  return ranking;
}

std::string ranking_csv(const std::vector<RankedSet>& sets) {
  CsvWriter csv;
  csv.line("engine", "solver", "rank", "settings", "score", "worst", "cells", "failed");
  for (const RankedSet& set : sets)
    csv.line(set.engine, set.solver, set.rank, set.settings, set.score, set.worst, set.cells, set.failed);
  return csv.text();
}

}  // namespace rockstack
