#include <gtest/gtest.h>

#include "comparisons/studies/sweep/sweep.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

TEST(SweepHeadline, SaysWhereHalfToppleHowManyDidAndWhatIsUndecided) {
  const TemporaryFolder folder;
  folder.write(
      "runs.csv",
      "run,toppled,falling,ground_left,status\n0,0,0,0,done\n1,1,0,0,done\n2,,,,failed\n3,0,2,0,done\n4,0,1,0,done\n");
  folder.write("fragility-fit.csv", "median,beta,log_likelihood\n3.125,0.25,-20\n");
  SummaryKeys keys;
  keys.intensity = "ground.horizontal.peak";
  EXPECT_EQ(sweep_headline(folder.path(), keys),
            (std::vector<std::string>{
                "Half of the runs topple at a peak ground acceleration of 3.12 m/s², by the fitted lognormal "
                "curve; its logarithmic spread β is 0.25.",
                "Of 4 runs 1 topples.",
                "2 more are past balance at the end, and count as standing: a longer duration decides.",
                "1 failed; runs.csv says why."}));
  folder.write("fragility-fit.csv", "median,beta,log_likelihood\n");
  EXPECT_EQ(sweep_headline(folder.path(), keys)[0].rfind("No lognormal curve fits: ", 0), 0U);
}

TEST(SweepHeadline, SaysWhatIsCutShort) {
  const TemporaryFolder folder;
  folder.write("runs.csv",
               "run,toppled,falling,ground_left,status\n0,0,0,2,done\n1,1,0,0,done\n2,0,1,11.2,done\n");
  folder.write("fragility-fit.csv", "median,beta,log_likelihood\n8.06,0.25,-20\n");
  SummaryKeys keys;
  keys.intensity = "ground.horizontal.peak";
  EXPECT_EQ(sweep_headline(folder.path(), keys),
            (std::vector<std::string>{
                "Half of the runs topple at a peak ground acceleration of 8.06 m/s² or less, by the fitted "
                "lognormal curve; its logarithmic spread β is 0.25.",
                "Of 3 runs 1 topples.",
                "2 more end while the ground moves on, for up to 11.2 s, and count as standing: a longer "
                "duration decides."}));
}

}  // namespace
}  // namespace rockstack
