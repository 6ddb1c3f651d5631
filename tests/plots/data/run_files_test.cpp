#include "plots/data/run_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "analytic/scene/history.hpp"
#include "plots/data/patterns.hpp"
#include "plots/data/selection.hpp"
#include "plots/pages/sections.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

plots::Run run_with(const fs::path& folder, const std::string& file, const std::string& text) {
  fs::create_directories(folder);
  std::ofstream(folder / file) << text;
  plots::Run run;
  run.folder = folder;
  return run;
}

MotionTally tally(bool topples) {
  return {{0.1}, 3, topples};
}

TEST(Share, IsTheCountOfTheTallies) {
  const std::vector<MotionTally> exact{tally(true), tally(false), tally(true), tally(false)};
  const std::vector<MotionTally> engine{tally(true), tally(true), {}, tally(false)};
  const Share own = toppled_share(exact, exact);
  EXPECT_EQ(own.of, 4u);
  EXPECT_EQ(own.toppled, 2u);
  EXPECT_EQ(own.agree, own.of);
  const Share share = toppled_share(engine, exact);
  EXPECT_EQ(share.of, 3u) << "a scene that could not be solved has no answer";
  EXPECT_EQ(share.toppled, 2u);
  EXPECT_EQ(share.agree, 2u);
}

TEST(Replicates, AreSortedAndThoseWithoutANumberDropped) {
  const plots::Run run = run_with(testing::fresh_folder(), "draws.csv", "run,agreement_time\na,3\nb,\nc,1\n");
  EXPECT_EQ(replicates_of(run, "agreement_time"), (std::vector<double>{1, 3}));
  EXPECT_TRUE(replicates_of(plots::Run{}, "agreement_time").empty());
}

// An engine that is late but loses the same has the same losses, which add up to all that is lost.
TEST(ImpactLosses, CountTheSameImpactsWheneverTheyCome) {
  const fs::path folder = testing::fresh_folder();
  std::string energy = "time,exact,engine,input,balance\n";
  for (int i = 0; i <= 40; ++i) {
    const std::string own = std::to_string(100 - 30 * (i >= 13) - 20 * (i >= 24));
    energy += std::to_string(i) + "," + std::to_string(100 - 30 * (i >= 10) - 20 * (i >= 20)) + "," + own +
              ",0," + own + "\n";
  }
  plots::Run run = run_with(folder, "energy.csv", energy);
  run = run_with(folder, "impacts.csv",
                 "number,interface,exact_time,engine_time,difference,verdict\n1,1,9.5,12.5,3,matched\n"
                 "2,1,19.5,23.5,4,matched\n3,1,30,,,missed\n");
  const std::vector<ImpactLoss> losses = impact_losses(run);
  ASSERT_EQ(losses.size(), 2U);
  double lost = 0;
  for (const ImpactLoss& loss : losses) {
    EXPECT_EQ(loss.engine, loss.exact) << loss.number;
    lost += loss.exact;
  }
  EXPECT_EQ(losses.front().exact, 30);
  EXPECT_EQ(lost, 50);
}

TEST(Contacts, AreShownByArrowsAndDashes) {
  EXPECT_EQ(shown_pattern(named_pattern("C<-R>", 3)), "C←–R→");
  EXPECT_EQ(shown_pattern(named_pattern("2b", 2)), "2b");
}

TEST(Contacts, TellOfASceneWhetherItsFiguresHaveSlips) {
  const std::filesystem::path folder = testing::fresh_folder();
  for (const bool slides : {false, true}) {
    testing::write_sample(folder, {.slides = slides});
    const Comparison comparison = read_comparison(folder);
    EXPECT_EQ(comparison.scenes.front().slips, slides);
    EXPECT_EQ(history_of(comparison.runs.front())->slips.empty(), !slides);
    EXPECT_EQ(contact_section(comparison).empty(), !slides);
  }
}

TEST(Contacts, VariantsAreNamedByWhatTheyChange) {
  plots::Run run;
  run.engine = "friction=0.3";
  run.solver = "taylor";
  EXPECT_TRUE(run.is_variant() && run.has_own_friction());
  EXPECT_EQ(line_label(run), "exact, friction 0.3");
  run.engine = "unilateral";
  EXPECT_TRUE(run.is_variant() && !run.has_own_friction());
  EXPECT_EQ(line_label(run), "exact, law unilateral");
}

}  // namespace
}  // namespace rockstack::plots
