#include "comparisons/measures/statistics/ranking.hpp"

#include <gtest/gtest.h>

namespace rockstack {
namespace {

RunMetrics run(const char* settings, const char* scene, double error, RunStatus status = RunStatus::done) {
  RunMetrics row;
  row.engine = "ode";
  row.solver = "step";
  row.settings = settings;
  row.scene = scene;
  row.dt = 1e-3;
  row.status = status;
  if (status == RunStatus::done) row.rms_angle_difference = error;
  return row;
}

TEST(Ranking, IsByTheGeometricMeanOfRatiosToTheBestOfEachScene) {
  const auto ranking =
      rank_sets({run("a", "one", 1), run("b", "one", 4), run("a", "two", 16), run("b", "two", 1)});
  ASSERT_EQ(ranking.size(), 2U);
  EXPECT_EQ(ranking[0].settings, "b");
  EXPECT_DOUBLE_EQ(ranking[0].score, 2);
  EXPECT_DOUBLE_EQ(ranking[0].worst, 4);
  EXPECT_EQ(ranking[1].rank, 2);
  EXPECT_DOUBLE_EQ(ranking[1].score, 4);
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
}

TEST(Ranking, NeedsSeveralSets) {
  EXPECT_TRUE(rank_sets({run("a", "one", 1), run("a", "two", 1)}).empty());
}

}  // namespace
}  // namespace rockstack
