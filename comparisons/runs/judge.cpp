#include "comparisons/runs/judge.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace rockstack {
namespace {

void add_evidence(const RunMetrics& run, ReplicatedRow& row) {
  const bool done = run.status == RunStatus::done && run.error;
  row.errors.push_back(done ? *run.error : std::numeric_limits<double>::infinity());
  if (!done || !run.peak_angle) return;
  row.peaks.push_back(*run.peak_angle);
  row.exact_peaks.push_back(*run.exact_peak_angle);
}

/// Ranks of the rows of one scene and step, given to them.
void rank(const std::vector<ReplicatedRow*>& rows) {
  std::vector<ReplicatedRow> list;
  list.reserve(rows.size());
  for (const ReplicatedRow* row : rows) list.push_back(*row);
  for (const RankedSet& set : rank_all(list))
    for (ReplicatedRow* one : rows)
      if (one->row.engine == set.engine && one->row.solver == set.solver && one->row.settings == set.settings)
        one->row.rank = set.rank;
}

}  // namespace

std::vector<JudgedScene> judged_scenes(const std::vector<Suite>& suites) {
  std::vector<JudgedScene> scenes;
  for (const Suite& suite : suites)
    for (const NamedScene& scene : suite.scenes)
      scenes.push_back({scene.name, scale_of(scene.scene, suite.tolerance)});
  return scenes;
}

ReplicatedRow told_row(const DrawnRow& drawn, const SceneScale& scale) {
  ReplicatedRow told{drawn.nominal, {}};
  add_evidence(drawn.nominal, told);
  for (const RunMetrics& draw : drawn.draws) add_evidence(draw, told);
  if (!drawn.draws.empty() && drawn.nominal.status == RunStatus::done) summarise(drawn.draws, told.row);
  if (is_engine(told.row)) told.row.outcome = outcome(told.row, scale);
  return told;
}

std::vector<ReplicatedRow> told_rows(const std::vector<DrawnRow>& rows,
                                     const std::vector<JudgedScene>& scenes) {
  std::map<std::string, SceneScale> scales;
  for (const JudgedScene& scene : scenes) scales[scene.name] = scene.scale;
  std::vector<ReplicatedRow> told;
  told.reserve(rows.size());
  std::map<std::pair<std::string, double>, std::vector<ReplicatedRow*>> cells;
  for (const DrawnRow& row : rows) {
    told.push_back(told_row(row, scales.at(row.nominal.scene)));
    if (is_engine(told.back().row)) cells[{row.nominal.scene, *row.nominal.dt}].push_back(&told.back());
  }
  for (const auto& [cell, own] : cells) rank(own);
  return told;
}

RowTeller::RowTeller(const std::vector<Job>& jobs, const std::vector<JudgedScene>& scenes, const Tell& tell)
    : scenes_(scenes), tell_(tell) {
  for (const Job& job : jobs) ++left_[cell_of(job)];
}

RowTeller::Cell RowTeller::cell_of(const Job& job) {
  return {job.scene.name, job.series == nullptr ? 0 : job.dt};
}

void RowTeller::add(const Job& job, const DrawnRow& row) {
  const Cell cell = cell_of(job);
  std::vector<DrawnRow>& own = rows_[cell];
  own.push_back(row);
  if (--left_[cell] > 0) return;
  std::vector<RunMetrics> rows;
  for (ReplicatedRow& one : told_rows(own, scenes_)) rows.push_back(std::move(one.row));
  const auto place = [](const RunMetrics& one) {
    return std::tuple(one.status != RunStatus::done, one.rank.value_or(0), one.error.value_or(0));
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const RunMetrics& a, const RunMetrics& b) { return place(a) < place(b); });
  tell_(rows);
  rows_.erase(cell);
}

}  // namespace rockstack
