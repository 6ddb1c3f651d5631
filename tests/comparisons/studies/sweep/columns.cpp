#include <gtest/gtest.h>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/long_table.hpp"
#include "tests/comparisons/studies/sweep/sweep_folder.hpp"
#include "tests/stride.hpp"

namespace rockstack {
namespace {

constexpr RunsFormat as_columns = RunsFormat::npz;

/// 132 runs in 5 blocks, of which some fail: drawn heights, which may be negative, over a grid of amplitudes
/// and two laws.
Ensemble failing_ensemble(const std::string& seed = "4") {
  return ensemble_from("samples = 11\nseed = " + seed + "\n" + ensemble_of_one_block(R"([[vary]]
key = "ground.horizontal.amplitude"
range = {from = 1, to = 12, count = 6}
[[vary]]
key = "law"
values = ["paper", "consistent"]
[[vary]]
key = "blocks.1.height"
normal = {mean = 1, deviation = 0.8}
[summary]
intensity = "ground.horizontal.amplitude"
)"));
}

std::vector<std::string> reasons_in(const std::filesystem::path& folder) {
  std::vector<std::string> reasons;
  for (TableRows row(failures_file(folder), {"run", "reason"}); row.next();)
    if (!row.text(1).empty()) reasons.push_back(row.text(0) + " " + row.text(1));
  return reasons;
}

void expect_same_rows(const std::filesystem::path& a, const std::filesystem::path& b,
                      const std::vector<std::string>& names) {
  TableRows one(a, names), other(b, names);
  while (one.next()) {
    ASSERT_TRUE(other.next());
    for (std::size_t c = 0; c < names.size(); ++c) EXPECT_EQ(one.text(c), other.text(c)) << names[c];
  }
  EXPECT_FALSE(other.next());
}

// The shortest text of a number reads back to its bits.
TEST(SweepColumns, AreTheLinesToTheBit) {
  const Ensemble ensemble = failing_ensemble();
  const TemporaryFolder lines, columns;
  const SweepResult one = sweep_into(lines.path(), ensemble);
  const SweepResult other = sweep_into(columns.path(), ensemble, {.format = as_columns});
  std::vector<std::string> names = column_names(lines.path() / "runs.csv");
  std::erase(names, "reason");
  EXPECT_EQ(column_names(columns.path() / "runs.csv"), names);
  expect_same_rows(lines.path() / "runs.csv", columns.path() / "runs.csv", names);
  EXPECT_GT(one.failed, 0U);
  EXPECT_EQ(other.failed, one.failed);
  EXPECT_EQ(other.reason, one.reason);
  EXPECT_EQ(reasons_in(lines.path()).size(), one.failed);
  EXPECT_EQ(reasons_in(columns.path()), reasons_in(lines.path()));
  EXPECT_EQ(other.headline.back(), std::to_string(one.failed) + " failed; failures.csv says why.");
}

TEST(SweepColumns, HaveTheSummariesOfTheLines) {
  const TemporaryFolder lines, columns;
  const Ensemble ensemble = ensemble_from(ensemble_of_one_block(R"([[vary]]
key = "ground.horizontal.amplitude"
range = {from = 1, to = 12, count = 12}
[[vary]]
key = "ground.horizontal.period"
range = {from = 0.3, to = 0.8, count = 11}
[summary]
intensity = "ground.horizontal.amplitude"
)"));
  sweep_into(lines.path(), ensemble);
  sweep_into(columns.path(), ensemble, {.format = as_columns});
  for (const char* name : {"fragility.csv", "fragility-fit.csv", "incremental-fractiles.csv"})
    EXPECT_EQ(bytes_in(lines.path() / name), bytes_in(columns.path() / name)) << name;
  expect_same_rows(lines.path() / "incremental.csv", columns.path() / "incremental.csv",
                   {"curve", "intensity", "peak_ratio", "toppled"});
  EXPECT_FALSE(std::filesystem::exists(columns.path() / "incremental.csv"));
  // A curve names runs where the lines name their values.
  const auto periods = table_columns(columns.path() / "runs.csv", {"ground.horizontal.period"})[0];
  TableRows values(lines.path() / "incremental.csv", {"values"});
  for (TableRows run(columns.path() / "incremental.csv", {"run"}); run.next();) {
    ASSERT_TRUE(values.next());
    EXPECT_EQ(values.text(0),
              "ground.horizontal.period=" + number_text(periods.at(static_cast<std::size_t>(run.value(0)))));
  }
}

TEST(SweepColumns, HaveTheMapsOfTheLines) {
  const std::string runs = R"([[vary]]
key = "ground.horizontal.amplitude"
range = {from = 1, to = 12, count = 6}
[[vary]]
key = "ground.horizontal.period"
range = {from = 0.3, to = 0.8, count = 5}
[[vary]]
key = "blocks.1.height"
values = [0.8, 1.0]
[summary]
intensity = "ground.horizontal.amplitude"
)";
  for (const auto& [summary, file, names] :
       {std::tuple{"period = \"ground.horizontal.period\"\n", "overturning.csv",
                   std::vector<std::string>{"period", "frequency", "intensity", "runs", "rest", "rocking",
                                            "toppled_after_impact", "toppled_without_impact", "failed"}},
        std::tuple{"friction = \"ground.horizontal.period\"\n", "modes.csv",
                   std::vector<std::string>{"intensity", "friction", "runs", "onset_rock", "rock", "topple",
                                            "rest", "failed"}}}) {
    const TemporaryFolder lines, columns;
    const Ensemble ensemble = ensemble_from(ensemble_of_one_block(runs + summary));
    sweep_into(lines.path(), ensemble);
    sweep_into(columns.path(), ensemble, {.format = as_columns});
    expect_same_rows(lines.path() / file, columns.path() / file, names);
    EXPECT_EQ(table_columns(columns.path() / file, {"runs"})[0], std::vector<double>(30, 2.0));
  }
}

TEST(SweepColumns, HaveTheIndicesOfTheLines) {
  const TemporaryFolder lines, columns;
  const Ensemble ensemble = ensemble_from("samples = 20\nseed = 4\n" + ensemble_of_one_block(R"([[vary]]
key = "ground.horizontal.amplitude"
values = [2.5, 5, 10]
[[vary]]
key = "blocks.1.height"
one_of = [0.9, 1.1]
[[vary]]
key = "ground.horizontal.period"
uniform = [0.4, 0.8]
[summary]
intensity = "ground.horizontal.amplitude"
indices = ["peak_ratio", "toppled"]
)"));
  sweep_into(lines.path(), ensemble);
  sweep_into(columns.path(), ensemble, {.format = as_columns});
  for (const char* name : {"indices.csv", "fragility.csv", "sweep.json"})
    EXPECT_EQ(bytes_in(lines.path() / name), bytes_in(columns.path() / name)) << name;
}

TEST(SweepColumns, AreTheSameBytesHoweverTheyWereMade) {
  const Ensemble ensemble = failing_ensemble();
  const TemporaryFolder whole, stopped;
  sweep_into(whole.path(), ensemble, {.format = as_columns});
  const SweepResult first = sweep_into(stopped.path(), ensemble, {.blocks = 2, .format = as_columns});
  EXPECT_FALSE(first.finished());
  EXPECT_FALSE(std::filesystem::exists(stopped.path() / "runs.npz"));
  const SweepResult second = sweep_into(stopped.path(), ensemble, {.threads = 3, .format = as_columns});
  EXPECT_EQ(first.computed + second.computed, 132U);
  for (const char* name : {"runs.npz", "failures.csv", "sweep.json", "fragility.csv"}) {
    EXPECT_FALSE(bytes_in(whole.path() / name).empty()) << name;
    EXPECT_EQ(bytes_in(whole.path() / name), bytes_in(stopped.path() / name)) << name;
  }
}

// Columns that are whole stand for the journal.
TEST(SweepColumns, AreGoneOnFromWithoutAJournal) {
  const TemporaryFolder folder;
  sweep_into(folder.path(), failing_ensemble(), {.format = as_columns});
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "runs.journal"));
  const std::string runs = bytes_in(folder.path() / "runs.npz");
  const SweepResult again = sweep_into(folder.path(), failing_ensemble(), {.format = as_columns});
  EXPECT_TRUE(again.finished());
  EXPECT_EQ(again.computed, 0U);
  EXPECT_THROW(sweep_into(folder.path(), failing_ensemble("5"), {.format = as_columns}), InputError);
  EXPECT_THROW(sweep_into(folder.path(), failing_ensemble()), InputError) << "as lines";
  EXPECT_EQ(bytes_in(folder.path() / "runs.npz"), runs);
  const TemporaryFolder lines;
  sweep_into(lines.path(), failing_ensemble());
  EXPECT_THROW(sweep_into(lines.path(), failing_ensemble(), {.format = as_columns}), InputError);
}

// A kill may tear the journal's last block anywhere, and may come between the columns and the journal's end.
TEST(SweepColumns, ATornJournalCostsItsLastBlockAlone) {
  const Ensemble ensemble = failing_ensemble();
  const TemporaryFolder whole, torn;
  sweep_into(torn.path(), ensemble, {.blocks = 5, .format = as_columns});
  sweep_into(whole.path(), ensemble, {.blocks = 4, .format = as_columns});
  const std::string journal = bytes_in(whole.path() / "runs.journal");
  const std::string runs = bytes_in(torn.path() / "runs.npz");
  ASSERT_FALSE(runs.empty());
  const auto last = journal.rfind("\npart ") + 1;
  for (std::size_t length = last; length < journal.size(); length += std::size_t{8} * testing::stride) {
    std::filesystem::remove(torn.path() / "runs.npz");
    torn.write("runs.journal", journal.substr(0, length));
    EXPECT_EQ(sweep_into(torn.path(), ensemble, {.format = as_columns}).computed, 132U - 3 * 32U);
    ASSERT_EQ(bytes_in(torn.path() / "runs.npz"), runs) << "torn after " << length << " bytes";
  }
  torn.write("runs.journal", journal);
  EXPECT_EQ(sweep_into(torn.path(), ensemble, {.format = as_columns}).computed, 0U);
  EXPECT_FALSE(std::filesystem::exists(torn.path() / "runs.journal"));
}

TEST(SweepColumns, AreUsualOfManyRuns) {
  EXPECT_EQ(usual_format(most_csv_runs), RunsFormat::csv);
  EXPECT_EQ(usual_format(most_csv_runs + 1), RunsFormat::npz);
}

}  // namespace
}  // namespace rockstack
