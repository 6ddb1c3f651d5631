#include "comparisons/studies/diff/reports.hpp"

#include <gtest/gtest.h>

#include <boost/property_tree/xml_parser.hpp>
#include <sstream>

#include "analytic/scene/messages/input_error.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

/// One row of an engine whose replicates' angles are from 4 to 6 mrad, times a factor, and whose first
/// impacts are 4.9 ms early, times the same.
RecordedResults results(double factor) {
  RecordedRun run;
  for (int i = 0; i < 11; ++i) {
    RunMetrics& row = run.replicates.emplace_back();
    row.scene = "first | look";
    row.engine = "ode";
    row.solver = "step";
    row.settings = "tuned";
    row.run = "first-look.<ode>";
    row.dt = 0.01;
    row.steps = 500;
    row.error = row.rms_angle_difference = factor * (4e-3 + 2e-4 * i);
    row.first_impact_time_difference = -factor * (4.8e-3 + 2e-5 * i);
  }
  run.row = run.replicates.front();
  return {"results", {}, {}, {run}};
}

std::string complaint(const std::string& text) {
  try {
    read_upper_bound(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

boost::property_tree::ptree read_xml(const std::string& text) {
  std::istringstream stream(text);
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(stream, tree);
  return tree;
}

TEST(UpperBounds, HaveTheFieldsWordsAndUnits) {
  EXPECT_EQ(read_upper_bound("angles=10mrad").quantity->name, "rms_angle_difference");
  EXPECT_DOUBLE_EQ(read_upper_bound("angles=10mrad").value, 0.01);
  EXPECT_DOUBLE_EQ(read_upper_bound("rms_angle_difference=0.01rad").value, 0.01);
  EXPECT_DOUBLE_EQ(read_upper_bound("first-impact=5ms").value, 5e-3);
  EXPECT_DOUBLE_EQ(read_upper_bound("centres=2mm").value, 2e-3);
  EXPECT_DOUBLE_EQ(read_upper_bound("energy-gain=1%").value, 0.01);
  EXPECT_DOUBLE_EQ(read_upper_bound("impacts-missed=3").value, 3);
}

TEST(UpperBounds, ThatAreWronglyAskedForSayWhatIsAllowed) {
  EXPECT_EQ(complaint("angles=10kg"),
            "--fail-above angles=10kg: must be a number ≥ 0 in mrad, rad, as angles=10mrad");
  EXPECT_NE(complaint("angels=1mrad").find("did you mean angles?"), std::string::npos);
  EXPECT_NE(complaint("agreement=1s").find("must be one of failures, "), std::string::npos)
      << "more is better";
  EXPECT_NE(complaint("angles").find("must be QUANTITY=VALUE"), std::string::npos);
  EXPECT_NE(complaint("angles=").find("must be a number"), std::string::npos);
  EXPECT_NE(complaint("angles=-1mrad").find("must be a number ≥ 0"), std::string::npos);
  EXPECT_NE(complaint("impacts-missed=3s").find("without a unit"), std::string::npos);
  EXPECT_THROW(bounded_rows({read_upper_bound("sinking=1mm")}, results(1)), InputError) << "no row has it";
}

// The median of 4 to 6 mrad is 5.
TEST(UpperBounds, HoldMediansOfNewRowsAndRowsThatAreNotDoneAreAboveThem) {
  const std::vector<UpperBound> bounds{read_upper_bound("angles=5.1mrad"),
                                       read_upper_bound("first-impact=4ms")};
  RecordedResults now = results(1);
  const auto rows = bounded_rows(bounds, now);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_FALSE(rows[0].above());
  EXPECT_TRUE(rows[1].above()) << "4.9 ms early";
  now.runs.front().row.status = RunStatus::signal;
  now.runs.front().replicates.clear();
  EXPECT_TRUE(bounded_rows(bounds, now)[0].above());
}

TEST(Reports, AHeadlineNamesWhatIsWorseInTheFieldsUnits) {
  const ResultsChange change = hold_against(results(1), results(10), {});
  EXPECT_EQ(change.headline(),
            "Worse: ode:step (tuned): angles 5 → 50 mrad, first impact −4.9 → −49 ms; 1 of 1 row worse.");
}

TEST(Reports, JUnitHasATestCaseANumberAndFailuresSayByHowMuch) {
  const RecordedResults now = results(10);
  const std::vector<UpperBound> asked{read_upper_bound("angles=10mrad")};
  const std::vector<BoundedRow> bounds = bounded_rows(asked, now);
  const ResultsChange change = hold_against(results(1), now, {});
  const auto suites = read_xml(junit_xml({change, bounds})).get_child("testsuites");
  const auto row = suites.get_child("testsuite");
  EXPECT_EQ(row.get<std::string>("<xmlattr>.name"), "first-look.<ode>");
  EXPECT_EQ(row.get<int>("<xmlattr>.failures"), 4) << "error, angles, first impact, and angles above 10 mrad";
  std::map<std::string, std::string> failures;
  for (const auto& [kind, one] : row)
    if (kind == "testcase")
      failures[one.get<std::string>("<xmlattr>.name")] = one.get("failure.<xmlattr>.message", "");
  EXPECT_TRUE(failures.at("angles").starts_with("5 → 50 mrad, p = ")) << failures.at("angles");
  EXPECT_EQ(failures.at("angles at most 10 mrad"), "angles: 50 mrad, above 10 mrad");

  const ResultsChange same = hold_against(now, now, {});
  const auto quiet = read_xml(junit_xml({same, {}})).get_child("testsuites");
  int suites_there = 0;
  for (const auto& [kind, suite] : quiet) {
    if (kind != "testsuite") continue;
    ++suites_there;
    EXPECT_EQ(suite.get<int>("<xmlattr>.failures"), 0);
  }
  EXPECT_EQ(suites_there, 2) << "the row, and whether all is decided";
}

TEST(Reports, MarkdownHasALineARowWhoseCellsStayCells) {
  const ResultsChange change = hold_against(results(1), results(10), {});
  const std::string text = summary_markdown({change, {}});
  EXPECT_NE(
      text.find(
          "| worse | first \\| look | ode:step (tuned) | 10 ms | **5 → 50 mrad** | **−4.9 → −49 ms** |"),
      std::string::npos)
      << text;
}

TEST(Reports, ABaselineInOneFileIsReadBackWhole) {
  const TemporaryFolder folder;
  const RecordedResults before = results(1);
  const auto file = folder.write("base.json", packed_results(before));
  const RecordedResults read = read_recorded_results(file);
  EXPECT_EQ(packed_results(read), packed_results(before));
  EXPECT_EQ(hold_against(before, results(10), {}).headline(), hold_against(read, results(10), {}).headline());
  const auto other = folder.write("other.json", "{}");
  EXPECT_THROW(read_recorded_results(other), InputError);
}

}  // namespace
}  // namespace rockstack
