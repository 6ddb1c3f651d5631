#include "comparisons/measures/statistics/ranking.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {
namespace {

/// A row whose replicates lie within a tenth of its error, all of them apart from those of half of it.
ReplicatedRow run(const char* settings, const char* scene, double error, RunStatus status = RunStatus::done) {
  ReplicatedRow one;
  RunMetrics& row = one;
  row.engine = "ode";
  row.solver = "step";
  row.settings = settings;
  row.scene = scene;
  row.dt = 1e-3;
  row.status = status;
  if (status != RunStatus::done) return one;
  row.error = error;
  row.motion = 1;
  for (const double part : {0.9, 0.95, 1.0, 1.05, 1.1}) one.errors.push_back(part * error);
  return one;
}

TEST(Ranking, IsByTheGeometricMeanOfRatiosToTheBestOfEachScene) {
  const auto ranking =
      rank_sets({run("a", "one", 1), run("b", "one", 4), run("a", "two", 16), run("b", "two", 1)});
  ASSERT_EQ(ranking.size(), 2U);
  EXPECT_EQ(ranking[0].settings, "b");
  EXPECT_DOUBLE_EQ(ranking[0].score, 2);
  EXPECT_DOUBLE_EQ(ranking[0].worst, 4);
  EXPECT_DOUBLE_EQ(ranking[1].score, 4);
  EXPECT_EQ(ranking[1].rank, 1) << "each is nearer in one scene, so that no test tells them apart";
}

TEST(Ranking, ARunThatIsNotDoneCountsAsAHundredTimesTheBest) {
  const auto ranking =
      rank_sets({run("a", "one", 1), run("b", "one", 0, RunStatus::signal),
                 run("a", "two", 0, RunStatus::failed), run("b", "two", 0, RunStatus::failed)});
  ASSERT_EQ(ranking.size(), 2U);
  EXPECT_EQ(ranking[1].settings, "b");
  EXPECT_DOUBLE_EQ(ranking[1].score, 100);
  EXPECT_EQ(ranking[1].failed, 1);
  EXPECT_EQ(ranking[1].cells, 1) << "a scene that no set does says nothing";
  EXPECT_EQ(ranking[0].rank, 1);
  EXPECT_EQ(ranking[1].rank, 2) << "no replicate has to tell that";
}

// At the finest step, say, where replicates are dear.
TEST(Ranking, ASingleRunDoesNotCountWhereOthersHaveReplicates) {
  auto rows = std::vector<ReplicatedRow>{run("a", "one", 1), run("b", "one", 4), run("a", "two", 16),
                                         run("b", "two", 1)};
  for (std::size_t i : {2U, 3U}) rows[i].errors.resize(1);
  const auto ranking = rank_sets(rows);
  ASSERT_EQ(ranking.size(), 2U);
  EXPECT_EQ(ranking[0].settings, "a");
  EXPECT_EQ(ranking[0].cells, 1);
  EXPECT_DOUBLE_EQ(ranking[1].score, 4);
  EXPECT_EQ(ranking[1].rank, 2);
  for (ReplicatedRow& one : rows) one.errors.resize(1);
  EXPECT_DOUBLE_EQ(rank_sets(rows)[1].score, 4) << "where all are single runs all count";
  EXPECT_EQ(rank_sets(rows)[1].cells, 2);
}

TEST(Ranking, NeedsSeveralSets) {
  EXPECT_TRUE(rank_sets({run("a", "one", 1), run("a", "two", 1)}).empty());
}

// Five replicates of either that lie apart have a chance of 2/252; of three replicates it is 2/20.
TEST(Ranking, SetsThatReplicatesDoNotTellApartShareARank) {
  auto rows = std::vector<ReplicatedRow>{run("a", "one", 1), run("b", "one", 1.15), run("c", "one", 3)};
  const auto ranking = rank_all(rows);
  ASSERT_EQ(ranking.size(), 3U);
  EXPECT_EQ(ranking[0].rank, 1);
  EXPECT_EQ(ranking[1].rank, 1) << "their replicates overlap";
  EXPECT_EQ(ranking[2].rank, 3);
  for (ReplicatedRow& row : rows) row.errors.resize(3);
  for (const RankedSet& set : rank_all(rows)) EXPECT_EQ(set.rank, 1);
  // At several steps three replicates are enough.
  auto finer = rows;
  for (ReplicatedRow& row : finer) row.dt = 1e-4;
  rows.insert(rows.end(), finer.begin(), finer.end());
  EXPECT_EQ(rank_all(rows)[2].rank, 3);
}

/// Sets whose replicates lie apart, at so many steps.
std::vector<ReplicatedRow> sets_apart(std::size_t sets, std::size_t steps, int replicates) {
  std::vector<ReplicatedRow> rows;
  for (std::size_t set = 0; set < sets; ++set) {
    for (std::size_t step = 1; step <= steps; ++step) {
      rows.push_back(run(("set " + std::to_string(set)).c_str(), "one", std::pow(3, set)));
      rows.back().dt = 1e-3 * static_cast<double>(step);
      rows.back().errors.assign(static_cast<std::size_t>(replicates), *rows.back().error);
      for (std::size_t i = 0; i < rows.back().errors.size(); ++i)
        rows.back().errors[i] *= 1 + 0.01 * static_cast<double>(i);
    }
  }
  return rows;
}

TEST(Ranking, ReplicatesThatTellApartDoAndOneLessDoesNot) {
  for (const auto& [sets, steps] : {std::pair{14U, 1U}, {28U, 1U}}) {
    const int replicates = replicates_that_tell_apart(sets, steps);
    const auto ranking = rank_all(sets_apart(sets, steps, replicates));
    for (std::size_t i = 0; i < ranking.size(); ++i)
      EXPECT_EQ(ranking[i].rank, static_cast<int>(i) + 1) << sets;
    for (const RankedSet& set : rank_all(sets_apart(sets, steps, replicates - 1)))
      EXPECT_EQ(set.rank, 1) << sets;
  }
  EXPECT_EQ(replicates_that_tell_apart(14, 2), 5) << "several steps tell more than one";
}

// Two comparisons of n replicates that lie apart do so by chance in 2 of C(2n, n) cases at each step.
TEST(Ranking, ReplicatesThatShowChangesDoAndOneLessDoesNot) {
  for (const auto& [sets, steps] : {std::pair{1U, 1U}, {2U, 1U}, {4U, 1U}, {4U, 3U}, {700U, 2U}}) {
    const int replicates = replicates_that_show_changes(std::vector(sets, std::size_t{steps}), 0.01);
    const auto chance = [steps = steps](int n) {
      std::vector<Stratum> strata(steps);
      for (Stratum& one : strata)
        for (int i = 0; i < n; ++i) {
          one.first.push_back(i);
          one.second.push_back(n + i);
        }
      return mann_whitney(strata).p_value;
    };
    EXPECT_LE(sets * chance(replicates), 0.005) << sets;
    EXPECT_GT(sets * chance(replicates - 1), 0.005) << sets;
  }
  EXPECT_EQ(replicates_that_tell_apart(4, 1), 7) << "that a comparison with another shows a change";
  EXPECT_EQ(sets_that_can_change({{7}, {5}, {1, 1, 1}, {5, 5}}, 0.01),
            (std::vector{true, false, false, true}));
}

// What rests has errors of rounding; a set that is best there alone is not best.
TEST(Ranking, ScenesAtRestAreLeftOut) {
  std::vector<ReplicatedRow> rows{run("a", "one", 1), run("b", "one", 3), run("a", "rest", 1e-9),
                                  run("b", "rest", 1e-18)};
  for (ReplicatedRow& row : rows)
    if (row.scene == "rest") row.motion = 1e-14;
  const auto ranking = rank_all(rows);
  EXPECT_EQ(ranking[0].settings, "a");
  EXPECT_EQ(ranking[0].cells, 1);
  EXPECT_TRUE(rank_all({rows[2], rows[3]}).empty());
}

}  // namespace
}  // namespace rockstack
