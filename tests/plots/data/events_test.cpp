#include "plots/data/events.hpp"

#include <gtest/gtest.h>

#include "analytic/scene/history.hpp"
#include "plots/data/run_files.hpp"
#include "plots/data/selection.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

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
    EXPECT_EQ(read_contact_summary(comparison.runs.front()).interfaces.size(), slides ? 1U : 0U);
  }
}

TEST(Contacts, VariantsAreNamedByWhatTheyChange) {
  plots::Run run;
  run.engine = "friction=0.3";
  EXPECT_TRUE(is_variant(run) && has_own_friction(run));
  EXPECT_EQ(line_label(run), "exact, friction 0.3");
  run.engine = "unilateral";
  EXPECT_TRUE(is_variant(run) && !has_own_friction(run));
  EXPECT_EQ(line_label(run), "exact, law unilateral");
}

}  // namespace
}  // namespace rockstack::plots
