#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/measures/verdict/verdict.hpp"
#include "comparisons/runs/draws.hpp"

namespace rockstack {

/// The scenes of suites, with what their rows are held against.
std::vector<JudgedScene> judged_scenes(const std::vector<Suite>& suites);

/// A row as it is told, the median over its replicates, with what stands behind it and what becomes of it in
/// words; without its rank, which all rows of a scene make.
ReplicatedRow told_row(const DrawnRow& row, const SceneScale& scale);

/// All rows so, with their ranks among those of their scene and step.
std::vector<ReplicatedRow> told_rows(const std::vector<DrawnRow>& rows,
                                     const std::vector<JudgedScene>& scenes);

/// Tells the rows of engines at one step of a scene once all are there, the nearest first, and likewise those
/// of the scene's exact solutions. Keeps references.
class RowTeller {
 public:
  using Tell = std::function<void(const std::vector<RunMetrics>&)>;

  RowTeller(const std::vector<Job>& jobs, const std::vector<JudgedScene>& scenes, const Tell& tell);

  void add(const Job& job, const DrawnRow& row);

 private:
  using Cell = std::pair<std::string, double>;  ///< scene and step, 0 of the exact solutions

  static Cell cell_of(const Job& job);

  const std::vector<JudgedScene>& scenes_;
  const Tell& tell_;
  std::map<Cell, std::size_t> left_;
  std::map<Cell, std::vector<DrawnRow>> rows_;
};

}  // namespace rockstack
